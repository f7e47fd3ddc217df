#!/usr/bin/env python3
"""Prints eight scenes of two to nine swimmers in periodic boxes, one JSON line each (docs/fluid-inertia.md).

  docs/results/memory-scenes.py     equal calls print equal scenes

Units of length are a quarter of the smallest radius; fluid density is 1, kinematic viscosity 1/3. The swimmers of a scene
have one type with random radii, arms, stiffnesses and densities, and random orientations, positions and driving phases. Gaps between beads of different
swimmers are at least one smallest radius. "cycles": length of the runs.
"""
import json
import math
import random

VISCOSITY = 1 / 3
# Number of swimmers, period, largest ratio of radii, density of the beads, volume per swimmer divided by its enclosing cylinder
SCENES = [
    (2, 6000, 1.0, 1.0, 3.0),
    (2, 2500, 1.6, 3.0, 4.0),
    (3, 3500, 1.0, 2.0, 3.0),
    (4, 2000, 1.3, 1.0, 3.0),
    (4, 1500, 1.0, 1.0, 2.5),
    (6, 1000, 1.0, 1.0, 3.0),
    (8, 1200, 1.3, 1.0, 2.5),
    (9, 700, 1.0, 1.5, 3.0),
]


def direction(pick):
    while True:
        v = [pick.uniform(-1, 1) for _ in range(3)]
        length = math.hypot(*v)
        if 0.1 < length < 1:
            return [x / length for x in v]


def beads_of(position, axis, arms):
    offsets = [-arms[0], 0, arms[1]]
    middle = sum(offsets) / 3
    return [[p + (offset - middle) * a for p, a in zip(position, axis)] for offset in offsets]


def distance(a, b, edge):
    return math.hypot(*(((x - y + edge / 2) % edge) - edge / 2 for x, y in zip(a, b)))


def scene(number, count, period, most_ratio, density, room):
    pick = random.Random(f"memory {number}")
    radii = [4 * pick.uniform(1, most_ratio) for _ in range(3)]
    radii = [4 * r / min(radii) for r in radii]
    mean = sum(radii) / 3
    arms = [radii[i] + radii[i + 1] + pick.uniform(1.2, 2.5) * mean for i in range(2)]
    length = sum(arms) + radii[0] + radii[2]
    edge = 4 * round((count * room * length * math.pi * (2 * mean) ** 2 / 4 * 4) ** (1 / 3) / 4)
    edge = max(edge, 4 * math.ceil((length + 2 * mean) / 4))
    drag = 6 * math.pi * VISCOSITY * mean * 2 * math.pi / period
    softness = pick.uniform(0.3, 1.5)
    stiffness = drag / softness
    stroke = pick.uniform(0.3, 0.6) * 4
    amplitude = stroke * stiffness * math.hypot(1, softness / 2)
    swimmers, placed = [], []
    while len(swimmers) < count:
        position = [pick.uniform(0, edge) for _ in range(3)]
        axis = direction(pick)
        beads = beads_of(position, axis, arms)
        if any(
            distance(b, other, edge) < r + s + 4
            for b, r in zip(beads, radii)
            for other, s in placed
        ):
            continue
        placed += list(zip(beads, radii))
        swimmers.append(
            {
                "id": len(swimmers),
                "type": "a",
                "position": [round(x, 4) for x in position],
                "axis": axis,
                "driving": {"phase_offset": round(pick.uniform(-math.pi, math.pi), 4)},
            }
        )
    return {
        "cycles": 4,
        "layout": {
            "schema": "beadswim/layout/1",
            "units": "lattice",
            "fluid": {"density": 1.0, "kinematic_viscosity": VISCOSITY},
            "domain": {"lengths": [float(edge)] * 3, "boundary": ["periodic"] * 3},
            "types": {
                "a": {
                    "beads": [{"radius": round(r, 4), "density": density} for r in radii],
                    "springs": [
                        {"stiffness": float(f"{stiffness:.5g}"), "rest_length": round(arm, 4), "damping": 0.0} for arm in arms
                    ],
                    "angular_stiffness": float(f"{40 * stiffness * mean**2:.5g}"),
                    "driving": {
                        "amplitude": [float(f"{amplitude:.5g}")] * 2,
                        "phase": round(pick.uniform(0.9, 2.2), 4),
                        "period": float(period),
                        "frame": "body",
                    },
                }
            },
            "swimmers": swimmers,
        },
    }


for number, parameters in enumerate(SCENES):
    print(json.dumps(scene(number, *parameters)))
