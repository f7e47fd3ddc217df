#pragma once

#include <array>
#include <span>

#include "beadswim/core/vec3.hpp"
#include "ewald_split.hpp"
#include "mobility_kernels.hpp"

// clang-format off
// Radial functions of the flow of force moments (moment_flow.hpp): chi of the Oseen tensor, its Laplacian and its
// second Laplacian, each with its derivatives by (1/r) d/dr. In open space chi = r. An Ewald sum splits chi = near + far
// (ewald_split.hpp).
//
// Spheres that overlap: with moments of the degrees l and m on the spheres, chi is replaced by X(r),
//
//   r X(r) = integral p_l(s) p_m(t) (r + s + t) |r + s + t| ds dt,   p_l(s) proportional to (1 - s^2/a^2)^l on [-a, a]
//
// because the Fourier transform of p_l, whose integral is 1, is the form factor of the moment (force_moments.hpp).
// For overlapping spheres r X is a polynomial of r: one if one sphere contains the other, and another one if the
// surfaces intersect.
// clang-format on

namespace beadswim {

/// Values of ((1/r) d/dr)^n of the functions, divided by 8 pi eta, up to n = `highest`, or `highest` - 2 of
/// the second Laplacian; chi[0] is not set.
struct MomentRadials {
  int highest = highest_of_pairs;
  double chi[highest_of_mirrors + 1]{}, laplacian[highest_of_mirrors + 1]{};
  double bilaplacian[highest_of_mirrors - 1]{};

  MomentRadials reversed() const;  ///< all functions times -1
};

/// Radial functions at the distance r > 0 in open space [length]. viscosity: dynamic.
MomentRadials open_radials(double r, double viscosity, int highest);
/// Near part of an Ewald sum at r > 0, and far part at r >= 0 up to the cutoff, up to `highest`.
MomentRadials near_radials(const EwaldSplit& split, double r, double viscosity);
MomentRadials far_radials(const EwaldSplit& split, double r, double viscosity, int highest);

/// Radial functions of moments of the degrees l and m on two spheres of radii a and b that overlap at the
/// distance r > 0; bilaplacian is not set.
MomentRadials overlap_radials(int l, int m, double a, double b, double r, double viscosity);

/// Sets a lane to a sphere: vector from the sphere to the receiver, c_l a^2 and source.
void set_lane(SourceLanes& spheres, int lane, const Vec3& r, const std::array<double, 3>& sizes,
              std::span<const double> source);
void set_radials(SourceLanes& spheres, int lane, const MomentRadials& radials);
/// Sets the lanes from `used` on to copies of the first one without source.
void clear_lanes(SourceLanes& spheres, int used);

}  // namespace beadswim
