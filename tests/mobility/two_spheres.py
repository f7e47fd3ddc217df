#!/usr/bin/env python3
"""Exact Stokes resistance functions of two spheres that move perpendicularly to their line of centres.

Method: Lamb's exterior solution about each centre, azimuthal order m = 1, multipole orders n = 1..N, and
Galerkin projection of the no-slip condition on the vector spherical harmonics of both surfaces (Gauss-
Legendre quadrature in cos(theta)).  Sphere 1 (radius a1) has its centre at z = 0, sphere 2 (radius a2) at
z = R = a1 + a2 + h; viscosity 1.  Forces F are along x, torques T (about each sphere's own centre) and
angular velocities along y, U along x.  All velocities are written by their amplitudes (ur, ut, uf):
      u = (ur cos(phi), ut cos(phi), -uf sin(phi))   in spherical components (r, theta, phi).
With P = P_n^1(cos theta), ' = d/dtheta, Y = P cos(phi), Lamb's three exterior families are
  p_n  (pressure r^-(n+1) Y)      u = r^-n     [ (n+1)/(2(2n-1)) P,  b P',  b P/sin ],  b = (2-n)/(2n(2n-1))
  Phi_n (u = grad r^-(n+1) Y)     u = r^-(n+2) [ -(n+1) P,  P',  P/sin ]
  chi_n (u = grad(chi) x r)       u = r^-(n+1) [ 0,  P/sin,  P' ],                      chi = r^-(n+1) P sin(phi)
For n = 1 and P = sin(theta) a p_1 of coefficient A is a Stokeslet, a chi_1 of coefficient C a rotlet, and
      force on the sphere  F = -4 pi A ,      torque on the sphere  T = -8 pi C .
The output is one JSON line per geometry.  Signs: F and T are the force and torque ON the sphere.
"""
import json
import sys
import numpy as np


def harmonics(N, x):
    """P_n^1, dP_n^1/dtheta, P_n^1/sin(theta), n = 1..N, with int P^2 dx = 1 (P_1^1 > 0); each (N, len(x))."""
    G = np.zeros((N + 1, x.size))                                  # G_n = P_n / sin(theta)
    D = np.zeros_like(G)
    G[1] = np.sqrt(0.75)
    for n in range(2, N + 1):
        G[n] = np.sqrt((4*n*n - 1) / (n*n - 1)) * (x*G[n-1] - np.sqrt(n*(n-2) / (4*(n-1)**2 - 1)) * G[n-2])
    for n in range(1, N + 1):                                      # sin P' = n cos P_n - (n+1) P_{n-1}, normalised
        D[n] = n*x*G[n] - np.sqrt((n*n - 1) * (2*n + 1) / (2*n - 1)) * G[n-1]
    return (G * np.sqrt(1 - x*x))[1:], D[1:], G[1:]


def fields(N, a, r, x):
    """Amplitudes (3N modes, 3 components, points) of Lamb's families of a sphere of radius a at (r, x=cos theta)."""
    P, D, G = harmonics(N, x)
    n = np.arange(1, N + 1)[:, None]
    Z = np.zeros_like(P)
    s = np.exp(-n * np.log(r / a))                                 # (a/r)^n keeps every mode of order one
    b = (2 - n) / (2*n)
    p = np.stack([s * (n+1)/2 * P, s*b*D, s*b*G], 1) * (2 / (n+1))[:, :, None]
    f = np.stack([-(n+1) * P, D, G], 1) * (s * (a/r)**2 / (n+1))[:, None, :]
    c = np.stack([Z, G, D], 1) * (s * (a/r) / (n+1))[:, None, :]
    return np.concatenate([p, f, c])                               # p_n is scaled by 2(2n-1)/(n+1) a^n, etc.


def resistance(a1, a2, h, N):
    """4x4 matrix K: (F1, F2, T1, T2) on the spheres = -K (U1, U2, w1, w2)."""
    R, a = a1 + a2 + h, (a1, a2)
    x, w = np.polynomial.legendre.leggauss(2*N + 20)
    s = np.sqrt(1 - x*x)
    P, D, G = harmonics(N, x)
    q = 1 / np.arange(2, N + 2)[:, None]
    Z = np.zeros_like(P)
    test = np.concatenate([np.stack([P, Z, Z], 1), np.stack([Z, q*D, q*G], 1), np.stack([Z, q*G, q*D], 1)]) * w
    test = test.reshape(3*N, -1)                                   # vector harmonics, orthogonal on the sphere
    M = np.zeros((6*N, 6*N))
    rhs = np.zeros((6*N, 4))
    for i in (0, 1):                                               # no slip on sphere i ...
        row = slice(3*N*i, 3*N*(i+1))
        M[row, row] = test @ fields(N, a[i], np.full_like(x, a[i]), x).reshape(3*N, -1).T
        j = 1 - i                                                  # ... of its own field plus that of sphere j
        rho, z = a[i]*s, a[i]*x + (R if i else -R)                 # points of sphere i seen from centre j
        r = np.hypot(rho, z)
        u = fields(N, a[j], r, z / r)
        cd, sd = (z*x + rho*s) / r, (rho*x - z*s) / r              # cos, sin of (theta_j - theta_i)
        u = np.stack([u[:, 0]*cd - u[:, 1]*sd, u[:, 0]*sd + u[:, 1]*cd, u[:, 2]], 1)
        M[row, 3*N*j:3*N*(j+1)] = test @ u.reshape(3*N, -1).T
        rhs[row, i] = test @ np.concatenate([s, x, np.ones_like(x)])          # U = e_x
        rhs[row, 2+i] = test @ np.concatenate([0*x, a[i]*np.ones_like(x), a[i]*x])  # e_y x r
    c = np.linalg.solve(M, rhs)
    g = np.sqrt(0.75)                                              # normalised P_1 = g sin(theta)
    K = [4*np.pi * g * a[i] * c[3*N*i] for i in (0, 1)]            # scale of p_1: 2/(n+1) a^n = a
    K += [8*np.pi * g * a[i]**2 / 2 * c[3*N*i + 2*N] for i in (0, 1)]  # scale of chi_1: a^(n+1)/(n+1)
    return np.array(K)


def orders(xi, digits):
    """Multipole coefficients decay as exp(-alpha n), cosh(alpha) = 1 + xi/2: orders for that many e-folds."""
    return int(np.ceil(digits / np.arccosh(1 + xi/2))) + 8


if __name__ == "__main__":
    efold = float(sys.argv[1]) if len(sys.argv) > 1 else 20.
    pi = np.pi
    for xi in (0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0):   # equal spheres, a = 1
        N = orders(xi, efold)
        K = resistance(1., 1., xi, N)
        A, Bt, C = K[:2, :2] / (6*pi), K[2:, :2] / (8*pi), K[2:, 2:] / (8*pi)
        Bf = K[:2, 2:] / (6*pi)
        row = dict(
            xi=xi, N=N,
            slide_torque=C[0, 0] + C[0, 1],        # w, w:   T1 = T2 = -8 pi a^3 w * this      (YC11 + YC12)
            slide_force=-(Bf[0, 0] + Bf[0, 1]),    # w, w:   F1 = -F2 = 6 pi a^2 w * this
            roll_torque=C[0, 0] - C[0, 1],         # w, -w:  T1 = -T2 = -8 pi a^3 w * this     (YC11 - YC12)
            roll_force=-(Bf[0, 0] - Bf[0, 1]),     # w, -w:  F1 = F2 = 6 pi a^2 w * this
            anti_force=A[0, 0] - A[0, 1],          # U, -U:  F1 = -F2 = -6 pi a U * this       (YA11 - YA12)
            anti_torque=-(Bt[0, 0] - Bt[0, 1]),    # U, -U:  T1 = T2 = 8 pi a^2 U * this
            with_force=A[0, 0] + A[0, 1],          # U, U:   F1 = F2 = -6 pi a U * this        (YA11 + YA12)
            with_torque=-(Bt[0, 0] + Bt[0, 1]))    # U, U:   T1 = -T2 = 8 pi a^2 U * this
        print(json.dumps({k: v if k in ("xi", "N") else round(v, 8) for k, v in row.items()}))
    for xi in (0.002, 0.005, 0.02, 0.1):                         # a1 = 1, a2 = 2, xi = 2h/(a1+a2), both rotating at w
        N = orders(8/9 * xi, efold)
        K = resistance(1., 2., 1.5*xi, N)
        row = dict(ratio=2, xi=xi, N=N,
                   slide_torque_1=(K[2, 2] + K[2, 3]) / (8*pi),        # T1 = -8 pi a1^3 w * this
                   slide_torque_2=(K[3, 2] + K[3, 3]) / (8*pi * 8),    # T2 = -8 pi a2^3 w * this
                   slide_force_1=-(K[0, 2] + K[0, 3]) / (6*pi),        # F1 = 6 pi a1^2 w * this
                   slide_force_2=-(K[1, 2] + K[1, 3]) / (6*pi * 4))    # F2 = 6 pi a2^2 w * this
        print(json.dumps({k: v if k in ("ratio", "xi", "N") else round(v, 8) for k, v in row.items()}))
