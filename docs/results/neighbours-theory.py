#!/usr/bin/env python3
"""Theory of two swimmers side by side in fluid with inertia: mean velocities to second order in the driving amplitude.

    docs/results/neighbours-theory.py [PERIOD] >> neighbours.jsonl     (ten seconds; needs numpy)

Shares no code with the programs. The paper's swimmer (Pickl et al. 2017) in the periodic box of neighbours.sh, in lattice units:
radius 4, arms 20, viscosity 1/3; for T other than 2000 the same strokes. Prints a line per pair as neighbours.sh does, with the parts
of the sideways velocity: drift and Reynolds stress.

First order: complex amplitudes, q(t) = Im(q e^{iwt}), alpha^2 = iw rho/eta.
    flow        u(k) = (1 - kk/k^2) sum_j b_j(k) f_j/(eta (k^2 + alpha^2) V), k = 0 left out (no net force)
    beads       force F G(s_1) + S.grad G(s_2), Gaussians G(k) = exp(-s^2 k^2/2), s_1 = a/sqrt(pi), s_2 = a/(6 sqrt(pi))^(1/3) (force
                coupling: Lomholt & Maxey, J. Comput. Phys. 184 (2003) 381). The stresslet S (symmetric, traceless, even in z) makes the
                mean strain rate with weight G(s_2) vanish. b_n: spectra of the five components n of F and S; a bead's velocity and
                strain rates are the projections of the flow on them.
    forces      F = F_drive - K xi, xi = U/(iw); K: springs along x, angular spring along y; beads are as dense as the fluid
Second order: the mean velocities v_j of beads, and from them those of rigid swimmers without mean force and torque:
    v_j = 1/2 Re sum_i [(xi_j*.grad_j) R_ji f_i + (xi_i*.grad_i) S_ji f_i]     drift: the receiver moves; the source moves
          + [steady flow of the force density -rho div <u u> at bead j]        Reynolds stress
          + sum_i mu_ji F_i                                                    steady flow of mean inner forces
The flow of a bead goes on inside other beads, and the stress there counts too: an error of 0.014 at a distance of three radii.
"""
import json
import sys

import numpy as np

ETA, RHO, RADIUS, ARM = 1 / 3, 1.0, 4.0, 20.0
BOX = (60, 80, 40)
ANGULAR_STIFFNESS = 138.8


class Waves:
    """Wave vectors of a mesh of the box, without the mean and without the unpaired shortest waves (weight 0)."""

    def __init__(self, box):
        self.points = list(box)  # spacing 1
        self.k = np.meshgrid(*(2 * np.pi * np.fft.fftfreq(n, length / n) for n, length in zip(self.points, box)),
                             indexing="ij", sparse=True)
        self.k2 = sum(k * k for k in self.k)
        self.weight = np.ones(self.points)
        for axis, n in enumerate(self.points):
            np.moveaxis(self.weight, axis, 0)[n // 2] = 0
        self.weight[0, 0, 0] = 0
        self.k2_or_1 = np.where(self.k2 == 0, 1, self.k2)
        self.volume = np.prod(box)

    def phase(self, x):
        """e^{ik.x}, as a product over axes"""
        return np.exp(1j * self.k[0] * x[0]) * np.exp(1j * self.k[1] * x[1]) * np.exp(1j * self.k[2] * x[2])


class Theory:
    def __init__(self, period):
        self.w = 2 * np.pi / period
        self.stiffness, self.amplitude = 0.0347 * 2000 / period, 0.2 * 2000 / period
        self.alpha = np.sqrt(1j * self.w * RHO / ETA)
        self.mesh = w = Waves(BOX)
        self.known = {}
        k = np.array(np.broadcast_arrays(*w.k))
        s1, s2 = RADIUS / np.sqrt(np.pi), RADIUS / (6 * np.sqrt(np.pi))**(1 / 3)
        force = w.weight * np.exp(-w.k2 * s1**2 / 2)
        dipole = 1j * w.weight * np.exp(-w.k2 * s2**2 / 2) * RADIUS
        spectra = [np.array([force, 0 * force, 0 * force]), np.array([0 * force, force, 0 * force]),
                   dipole * np.array([k[0], -k[1], 0 * k[2]]) / np.sqrt(2), dipole * np.array([k[0], k[1], -2 * k[2]]) / np.sqrt(6),
                   dipole * np.array([k[1], k[0], 0 * k[2]]) / np.sqrt(2)]
        self.b = np.array([b - k * (k * b).sum(axis=0) / w.k2_or_1 for b in spectra])  # without divergence
        n = len(self.b)
        products = np.array([[(b.conj() * c).sum(axis=0) for c in self.b] for b in self.b]).reshape(n * n, -1) / (ETA * w.volume)
        self.unsteady, self.steady = products / (w.k2 + self.alpha**2).ravel(), products / w.k2_or_1.ravel()
        self.derivatives = [np.ones(products.shape[1])] + [1j * k[c].ravel() for c in range(2)]

    def tensors(self, x):
        beads, n = len(x), len(self.b)
        M, mu = np.zeros((beads, n, beads, n), complex), np.zeros((beads, n, beads, n))
        dR, dS = np.zeros((beads, beads, 2, n, n), complex), np.zeros((beads, beads, 2, n, n), complex)
        for j in range(beads):
            for i in range(beads):
                key = tuple(np.round(x[j] - x[i], 9))
                if key not in self.known:
                    waves = (self.mesh.phase(x[j] - x[i]).ravel() * self.derivatives).T
                    self.known[key] = [(q @ waves).T.reshape(3, n, n) for q in (self.unsteady, self.steady)]
                u, s = self.known[key]
                M[j, :, i], dR[j, i], mu[j, :, i], dS[j, i] = u[0], u[1:], s[0].real, s[1:]
        return M, mu, dR, dS

    def without_strain(self, M):
        """Mobility of beads with stresslets, and these stresslets [bead, n, bead, (x, y)] per force"""
        beads, n = M.shape[:2]
        force = (np.arange(beads)[:, None] * n + [0, 1]).ravel()
        rest = np.setdiff1d(np.arange(beads * n), force)
        M = M.reshape(beads * n, -1)
        all_per_force = np.zeros((beads * n, len(force)), M.dtype)
        all_per_force[force, np.arange(len(force))] = 1
        all_per_force[rest] = -np.linalg.solve(M[np.ix_(rest, rest)], M[np.ix_(rest, force)])
        return (M @ all_per_force)[force].reshape(beads, 2, beads, 2), all_per_force

    def first_order(self, M, phases):
        """Amplitudes of induced forces f and displacements xi [bead, (x, y)], and the internal forces among them"""
        n = 3 * len(phases)
        drive, K = np.zeros((n, 2), complex), np.zeros((n, 2, n, 2))
        spring = self.stiffness * np.array([[1, -1, 0], [-1, 2, -1], [0, -1, 1]])
        bend = np.array([1, -2, 1]) / ARM
        for s, phase in enumerate(phases):
            own = slice(3 * s, 3 * s + 3)
            drive[own, 0] = self.amplitude * np.exp(1j * phase) * np.array([1, -1 - 1j, 1j])
            K[own, 0, own, 0] = spring
            K[own, 1, own, 1] = ANGULAR_STIFFNESS * np.outer(bend, bend)
        M, K = M.reshape(2 * n, 2 * n), K.reshape(2 * n, 2 * n)
        xi = np.linalg.solve(1j * self.w * np.eye(2 * n) + M @ K, M @ drive.ravel())
        internal = -(K @ xi).reshape(n, 2)
        return drive + internal, xi.reshape(n, 2), internal

    def mean_torque(self, xi, internal):
        """Internal forces exert no torque on a displaced swimmer, hence a mean torque of forces at the mean places (x): y-forces c x/l."""
        forces = np.zeros((len(xi), 2))
        for s in range(len(xi) // 3):
            own = slice(3 * s, 3 * s + 3)
            c = 0.5 * (xi[own, 1].conj() * internal[own, 0] - xi[own, 0].conj() * internal[own, 1]).sum().real / (2 * ARM)
            forces[own, 1] = c * np.array([-1, 0, 1])
        return forces

    def reynolds(self, x, f):
        w, k, size = self.mesh, self.mesh.k, np.prod(self.mesh.points)
        waves = [w.phase(p) for p in x]
        source = np.tensordot(np.array(f).T, np.array(waves).conj(), 1)  # [n, mesh]
        u = (self.b * source[:, None]).sum(axis=0) / (ETA * (w.k2 + self.alpha**2) * w.volume)
        u = [np.fft.ifftn(c) * size for c in u]
        body = [0, 0, 0]
        for a in range(3):
            for b in range(3):
                body[a] = body[a] - 1j * k[b] * np.fft.fftn(RHO / 2 * (u[a] * u[b].conj()).real) / size
        received = (self.b.conj() * np.array(body)).sum(axis=1) / (ETA * w.k2_or_1)
        return np.array([[(r * wave).sum().real for r in received] for wave in waves])

    def rigid(self, mu, x, v):
        """Velocities [swimmer, (x, y)] of rigid swimmers, free of mean force and torque, whose beads alone would drift with v"""
        n, swimmers = len(x), len(x) // 3
        # Unknown: mean forces on beads within each swimmer (2 along x, 1 bend along y), velocity and rate of rotation of each swimmer
        forces, motions = np.zeros((2 * n, 3 * swimmers)), np.zeros((2 * n, 3 * swimmers))
        for s in range(swimmers):
            for c, (axis, pattern) in enumerate([(0, [1, -1, 0]), (0, [0, 1, -1]), (1, [1, -2, 1])]):
                forces[np.arange(3) * 2 + 6 * s + axis, 3 * s + c] = pattern
            for c, (axis, pattern) in enumerate([(0, [1, 1, 1]), (1, [1, 1, 1]), (1, [-1, 0, 1])]):
                motions[np.arange(3) * 2 + 6 * s + axis, 3 * s + c] = pattern
        solution = np.linalg.solve(np.hstack([mu.reshape(2 * n, 2 * n) @ forces, -motions]), -v.ravel())
        return solution[3 * swimmers:].reshape(swimmers, 3)[:, :2]

    def velocities(self, x, phases):
        """Mean velocities [swimmer, (x, y)] by drift and by Reynolds stress of swimmers with middle beads at x[1], x[4], ..."""
        M, mu, dR, dS = self.tensors(x)
        M2, per_force = self.without_strain(M)
        F, xi, internal = self.first_order(M2, phases)
        f = (per_force @ F.ravel()).reshape(len(x), -1)
        mu2, steady_per_force = self.without_strain(mu)
        rates = {"receiver": 0.5 * np.einsum("jc,jicab,ib->ja", xi.conj(), dR, f).real,
                 "source": -0.5 * np.einsum("ic,jicab,ib->ja", xi.conj(), dS, f).real,
                 "reynolds": self.reynolds(x, f)}
        # Mean strain rates vanish by mean stresslets: these add steady_per_force^T applied to the rates (mu is symmetric).
        v = {name: (steady_per_force.T @ r.ravel()).reshape(len(x), 2) for name, r in rates.items()}
        v["torque"] = (mu2.reshape(2 * len(x), -1) @ self.mean_torque(xi, internal).ravel()).reshape(len(x), 2)
        parts = {name: self.rigid(mu2, x, part) for name, part in v.items()}
        drift = parts["receiver"] + parts["source"] + parts["torque"]
        return drift, parts["reynolds"]


def swimmer(y):
    return np.array([[-ARM, y, 0], [0, y, 0], [ARM, y, 0]])


def main():
    period = float(sys.argv[1]) if len(sys.argv) > 1 else 2000
    theory = Theory(period)
    lone = sum(theory.velocities(swimmer(0.3), [0]))[0, 0]
    for distance in 3, 5, 8:
        for phase in 0, np.pi / 2:
            y = distance * RADIUS / 2
            drift, reynolds = (v / lone * [[1, -1], [1, 1]] for v in theory.velocities(np.vstack([swimmer(0.3 - y), swimmer(0.3 + y)]), [0, phase]))
            print(json.dumps({"period": round(period), "distance": distance, "phase": phase, "flags": "theory", "lone": lone,
                              "swimmers": (drift + reynolds).tolist(), "drift": drift[:, 1].tolist(), "reynolds": reynolds[:, 1].tolist()}))


if __name__ == "__main__":
    main()
