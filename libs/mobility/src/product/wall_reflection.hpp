#pragma once

#include <array>

#include "beadswim/mobility/derivative_table.hpp"

// clang-format off
// Flow w that a plane no-slip wall at z = 0 adds to a flow v of forces in the fluid above it. Lorentz's reflection
// gives it from v in open space and its pressure p, at the mirror point Jx of x:
//
//   w(x) = -v(Jx) + 2 z grad phi + z^2 grad q,   phi(x) = v_z(Jx),   q(x) = p(Jx)/eta
//   laplacian w = grad (q + 2 z d_z q + 4 d_z phi)
//
// Derivatives of products with powers of z, and the pressure of derivatives of point forces (moment_flow.hpp):
//
//   D^e (z f)   = z D^e f + k D^(e - z) f
//   D^e (z^2 f) = z^2 D^e f + 2 k z D^(e - z) f + k (k - 1) D^(e - 2z) f
//   q           = - sum_d sum_b A_b^d D^(d + e_b) L/(8 pi eta)
//
//   z         height of x above the wall [length]
//   J         mirror at the wall
//   eta       dynamic viscosity [mass/(length time)]
//   k         order of the derivative e along z;  e - z: the derivative of one order less along z
//
// At z = 0, w = -v. w and its pressure fulfil the Stokes equations, because phi and q do: laplacian q = 0,
// laplacian phi = -d_z q.
//
// Lorentz, Abh. Theor. Phys. 1 (1907) 23; Kim & Karrila, Microhydrodynamics (1991). The flow of
// one point force is that of Blake, Proc. Camb. Phil. Soc. 70 (1971) 303. Page: docs/method/half-space.md.
// clang-format on

namespace beadswim {

/// What feels a flow: spheres that also exert it, or points without size on which no force acts.
enum class Receivers { spheres, points };

/// Flow of forces at the mirror point of a sphere: derivatives of the velocity along the wall up to the order
/// n of the moments, and of its component across the wall and of p/eta up to the order n + 2. With the normal
/// of the wall along the axis a, the components along the wall belong to the axes a + 1 and a + 2 modulo 3.
/// At a point, and at the mirror point of a point: the velocity along the wall, and the others up to order 1.
struct MirrorFlow {
  static constexpr int max_count = derivative_count(4);
  double along[2][derivative_count(2)]{};
  double across[max_count]{}, pressure[max_count]{};
};

/// Adds the flow w at a sphere, with the factors P_l (force_moments.hpp), to `flow`.
///   order    of the moments
///   axis     of the wall's normal
///   height   z of the sphere [length]
///   sizes    c_l a^2 of the sphere [length^2]
void add_reflected_flow(int order, int axis, double height, const std::array<double, 3>& sizes,
                        const MirrorFlow& at_mirror, double* flow);

}  // namespace beadswim
