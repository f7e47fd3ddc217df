#!/usr/bin/env python3
"""Draws scenes of one swimmer at random, to compare stated uncertainties with errors (docs/stated-uncertainty.md).

  docs/results/random-scenes.py NUMBER SEED     prints one JSON line per scene; equal arguments give equal scenes

Units of length are a quarter of the smallest radius; fluid density is 1, kinematic viscosity 1/3. Drawn are, L for
log-uniform: radii up to 2.5 times the smallest (equal in two fifths of the scenes), gap of adjacent beads 1 to 4 mean radii (L),
gamma omega/k from 0.1 to 3 (L), damping up to that ratio (none in half of the scenes), density 1 to 5, period 700 to 10,000 (L),
stroke 0.1 to 0.6 smallest radii (L), ratio of driving amplitudes 1/2 to 2 (L), any phase, and a box from narrow to wide.
"cycles": enough for the arms to reach their periodic motion. "reference": resolution of the reference run, the finest of five
that needs fewer than 3e9 updates of cells.
"tested": three coarser runs, each with a random bead boundary. Scenes without a reference are drawn again.
"""
import json
import math
import random
import sys

CELL = 4  # smallest radius; every edge of the box is a multiple of it, and so a whole number of cells
VISCOSITY = 1 / 3
RESOLUTIONS = [(5, 1.0), (5, 1.5), (4, 1.0), (4, 1.5), (3, 1.0)]  # cells per radius, relaxation time
MOST_UPDATES = 3e9


def log_uniform(pick, low, high):
    return low * (high / low) ** pick.random()


def updates(edges, period, cycles, cells_per_radius, relaxation_time):
    cell = CELL / cells_per_radius
    step = (relaxation_time - 0.5) / 3 * cell**2 / VISCOSITY
    return math.prod(edges) / cell**3 * period / step * cycles


def scene(pick):
    ratios = [1.0] * 3 if pick.random() < 0.4 else [log_uniform(pick, 1, 2.5) for _ in range(3)]
    radii = [CELL * ratio / min(ratios) for ratio in ratios]
    mean = sum(radii) / 3
    arms = [radii[i] + radii[i + 1] + log_uniform(pick, 1, 4) * mean for i in range(2)]
    period = round(log_uniform(pick, 700, 10000))
    drag = 6 * math.pi * VISCOSITY * mean * 2 * math.pi / period  # gamma omega
    softness = log_uniform(pick, 0.1, 3)
    stiffness = drag / softness
    damping = 0 if pick.random() < 0.5 else pick.random() * stiffness * period / (2 * math.pi)
    amplitude = log_uniform(pick, 0.1, 0.6) * CELL * stiffness * math.hypot(1, softness / 2)
    ratio = math.sqrt(log_uniform(pick, 0.5, 2))
    walls = pick.choice(["periodic"] * 6 + ["free-slip"] * 2 + ["periodic,free-slip,free-slip"] * 2)
    length = sum(arms) + radii[0] + radii[2]
    edges = [length + log_uniform(pick, 0.8, 4) * sum(arms) / 2] + [
        2 * max(radii) + log_uniform(pick, 3, 18) * mean for _ in range(2)
    ]
    edges = [CELL * round(edge / CELL) for edge in edges]
    place = [edge / 2 + (pick.random() - 0.5) * CELL for edge in edges]
    place[0] += (arms[0] - arms[1]) / 2 + (radii[0] - radii[2]) / 2  # as much fluid before the swimmer as behind it
    density = 1 + 4 * pick.random()
    relaxation = (softness / 2 + damping * 2 * math.pi / period / stiffness) / (2 * math.pi)  # of the arms [cycle]
    cycles = max(4 if period < 1500 else 3, 2 + math.ceil(12 * relaxation))
    fine = [r for r in RESOLUTIONS if updates(edges, period, cycles, *r) < MOST_UPDATES]
    schemes = [pick.choice(["mr", "mr", "psm", "cli", "staircase"]) for _ in range(3)]
    taus = [pick.choice([0.8, 1.0, 1.5]) for _ in range(3)]
    phase = pick.uniform(-math.pi, math.pi)
    if not fine:
        return None

    def entries(values):
        return ",".join(f"{value:.6g}" for value in values)

    flags = (
        f"--radius {entries(radii)} --arm {entries(arms)} --stiffness {stiffness:.6g} --damping {damping:.6g} "
        f"--bead-density {density:.6g} --amplitude {entries([amplitude * ratio, amplitude / ratio])} --phase={phase:.6g} "
        f"--period {period} --viscosity {VISCOSITY:.15g} --box {entries(edges)} --boundary {walls} --position {entries(place)}"
    )
    coarse = sorted({max(2, fine[0][0] - 1), min(3, fine[0][0] - 1), 2})
    run = "--model lbm --cells-per-radius {} --relaxation-time {}"
    return {
        "layout": flags,
        "cycles": cycles,
        "reference": run.format(*fine[0]) + " --precision single",
        "tested": [
            run.format(n, tau) + f" --bead-boundary {scheme}" for n, tau, scheme in zip(coarse, taus, schemes)
        ],
    }


def main():
    number, seed = int(sys.argv[1]), int(sys.argv[2])
    pick = random.Random(seed)
    drawn = []
    while len(drawn) < number:
        drawn += [found for found in [scene(pick)] if found]
    for index, found in enumerate(drawn, start=1):
        print(json.dumps({"scene": index, **found}))


main()
