#!/usr/bin/env python3
"""Motion of a triangle and of three beads in line by prescribed distances, in unbounded fluid without inertia.

    docs/results/shapes-theory.py >> shapes-inertia.jsonl     (ten seconds)

Shares no code with the programs. Radius a = 4, arms 20, amplitudes 4, as the gallery's triangle and prescribed-three-bead. Prints for
each shape and mobility the rotation [radian] and the displacement [length] per period, which do not depend on the period.

    rotne-prager   U_i = sum_j (1 + a^2/3 lap) G(x_i - x_j) F_j, G: Oseen tensor; a lone sphere for i = j
    strain         beads resist the rate of strain: in addition, stresslets S_j (symmetric, traceless) with which it vanishes,
                   U_i = ... - sum_j (1 + 4/15 a^2 lap) dG(x_i - x_j) S_j
                   0 = sum_j sym (1 + 4/15 a^2 lap) dG F_j - sum_j sym (1 + 1/5 a^2 lap) ddG S_j;  3 S_i/(20 pi eta a^3) for i = j
                   (Durlofsky, Brady and Bossis, J. Fluid Mech. 180 (1987) 21, without torques); the first order that is missing
                   are moments of second degree, of relative order (a/r)^6 and, for a mean force, (a/r)^5

Forces act along the bonds. In each step they follow from the prescribed rates of the distances; Runge-Kutta of order 4.
"""
import json
import math

A, ARM, AMPLITUDE, STEPS, DIFFERENCE = 4.0, 20.0, 4.0, 48, 0.02  # eta = 1/(8 pi): the motion does not depend on it
AXES = range(3)
R2, R6 = math.sqrt(2), math.sqrt(6)
STRAINS = [[[1 / R2, 0, 0], [0, -1 / R2, 0], [0, 0, 0]], [[1 / R6, 0, 0], [0, 1 / R6, 0], [0, 0, -2 / R6]],
           [[0, 1 / R2, 0], [1 / R2, 0, 0], [0, 0, 0]]]  # those that are even in z


def solve(matrix, columns):
    """Solves matrix X = columns by elimination with pivots."""
    n = len(matrix)
    rows = [list(matrix[i]) + list(columns[i]) for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    return [[x / rows[k][k] for x in rows[k][n:]] for k in range(n)]


def green(d, c):
    """(1 + c a^2 lap) of the Oseen tensor"""
    r = math.sqrt(sum(x * x for x in d))
    one, dyad = 1 / r + 2 * c * A * A / r**3, 1 / r**3 - 6 * c * A * A / r**5
    return [[one * (i == j) + dyad * d[i] * d[j] for j in AXES] for i in AXES]


def gradient(d, c, order=1):
    """Derivatives of green by components k (and l) of d, by central differences: [k](i, j) or [k][l](i, j)"""
    result = []
    for k in AXES:
        ends = [[x + s * DIFFERENCE * (a == k) for a, x in enumerate(d)] for s in (1, -1)]
        plus, minus = [green(e, c) if order == 1 else gradient(e, c) for e in ends]
        halve = lambda p, m: [halve(x, y) for x, y in zip(p, m)] if isinstance(p, list) else (p - m) / (2 * DIFFERENCE)
        result.append(halve(plus, minus))
    return result


def mobility(beads, strain):
    """Velocities in the plane (6) per force in the plane (6)"""
    n = len(beads)
    size, parts = 2 * n, len(STRAINS)
    M = [[0.0] * size for _ in range(size)]
    C = [[0.0] * size for _ in range(parts * n)]  # rate of strain per force
    D = [[0.0] * (parts * n) for _ in range(parts * n)]  # rate of strain per stresslet
    for i in range(n):
        for j in range(n):
            if i == j:
                for k in range(2):
                    M[2 * i + k][2 * i + k] = 4 / (3 * A)
                for s in range(parts):
                    D[parts * i + s][parts * i + s] = 8 * 3 / (20 * A**3)
                continue
            d = [beads[i][0] - beads[j][0], beads[i][1] - beads[j][1], 0.0]
            g = green(d, 1 / 3)
            for k in range(2):
                for l in range(2):
                    M[2 * i + k][2 * j + l] = g[k][l]
            if strain:
                dg, ddg = gradient(d, 4 / 15), gradient(d, 1 / 5, 2)
                for s, e in enumerate(STRAINS):
                    for l in range(2):
                        C[parts * i + s][2 * j + l] = sum(e[p][q] * dg[q][p][l] for p in AXES for q in AXES)
                    for t, f in enumerate(STRAINS):
                        D[parts * i + s][parts * j + t] = -sum(e[p][q] * f[u][v] * ddg[q][v][p][u]
                                                             for p in AXES for q in AXES for u in AXES for v in AXES)
    if strain:
        S = solve(D, C)  # stresslets per force, with the sign changed
        for r in range(size):
            for c in range(size):
                M[r][c] -= sum(C[k][r] * S[k][c] for k in range(parts * n))
    return M


def velocities(beads, bonds, rates, strain):
    M = mobility(beads, strain)
    B = []
    for i, j in bonds:
        d = [beads[j][k] - beads[i][k] for k in range(2)]
        length = math.hypot(*d)
        row = [0.0] * (2 * len(beads))
        for k in range(2):
            row[2 * i + k], row[2 * j + k] = -d[k] / length, d[k] / length
        B.append(row)
    MB = [[sum(m * b for m, b in zip(row, bond)) for bond in B] for row in M]
    BMB = [[sum(bond[r] * MB[r][c] for r in range(len(M))) for c in range(len(B))] for bond in B]
    tension = solve(BMB, [[rate] for rate in rates])
    v = [sum(x * t[0] for x, t in zip(row, tension)) for row in MB]
    return [v[2 * b:2 * b + 2] for b in range(len(beads))]


def cycle(beads, bonds, rates, strain):
    """Returns the beads after a period of length 1."""
    h = 1 / STEPS
    move = lambda v, f: [[x + f * u for x, u in zip(bead, w)] for bead, w in zip(beads, v)]
    for n in range(STEPS):
        at = lambda x, t: velocities(x, bonds, rates(t), strain)
        k1 = at(beads, n * h)
        k2 = at(move(k1, h / 2), (n + 0.5) * h)
        k3 = at(move(k2, h / 2), (n + 0.5) * h)
        k4 = at(move(k3, h), (n + 1) * h)
        beads = move([[(a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(*w)] for w in zip(k1, k2, k3, k4)], h)
    return beads


def lengths(t, phases):
    return [ARM + AMPLITUDE * math.sin(2 * math.pi * t + p) for p in phases]


def rates_of(phases):
    return lambda t: [2 * math.pi * AMPLITUDE * math.cos(2 * math.pi * t + p) for p in phases]


def triangle(strain):
    phases = [-2 * math.pi / 3 * k for k in range(3)]
    a, b, c = lengths(0, phases)
    x = (a * a + c * c - b * b) / (2 * a)
    beads = [[0.0, 0.0], [a, 0.0], [x, math.sqrt(c * c - x * x)]]
    end = cycle(beads, [(0, 1), (1, 2), (2, 0)], rates_of(phases), strain)
    return math.atan2(end[1][1] - end[0][1], end[1][0] - end[0][0]), 0.0


def line(strain):
    phases = [math.pi / 2, 0]
    a, b = lengths(0, phases)
    end = cycle([[-a, 0.0], [0.0, 0.0], [b, 0.0]], [(0, 1), (1, 2)], rates_of(phases), strain)
    return 0.0, sum(bead[0] for bead in end) / 3 - (b - a) / 3


for name, shape in ("triangle", triangle), ("prescribed-three-bead", line):
    for strain in False, True:
        turn, displacement = shape(strain)
        print(json.dumps({"kind": name, "theory": "strain" if strain else "rotne-prager",
                          "turn": round(turn, 6), "displacement": round(displacement, 6)}))
