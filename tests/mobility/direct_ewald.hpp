#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "beadswim/core/box.hpp"

// Velocities of spheres of any radii in Stokes flow, by sums that hide nothing: every pair in open fluid, and
// in a box every pair with every image near enough, and every wavevector small enough.
//
//   U_i = sum_j M_ij F_j,    M_ij = (1/(8 pi eta)) (identity I + dyad rr),    r unit vector, [1/(eta length)]
//
//   Oseen         M_ii = 1/(6 pi eta a_i),   M_ij = (I + rr)/(8 pi eta r)
//   Rotne-Prager  M_ij = the Oseen tensor averaged over both surfaces, whatever their places: its transform
//                 is sin(k a_i)/(k a_i) sin(k a_j)/(k a_j) (I - kk)/(eta k^2). With s = (a_i^2 + a_j^2)/6 it
//                 is (1 + s laplacian) oseen for spheres apart, (1 - s k^2) (I - kk)/(eta k^2);
//                 spheres that cut each other and spheres of which one holds the other as in
//                 Wajnryb, Mizerski, Zuk & Szymczak, J. Fluid Mech. 731, R3 (2013), and
//                 Zuk, Wajnryb, Mizerski & Szymczak, J. Fluid Mech. 741, R5 (2014).
//
// In a periodic box: Beenakker, J. Chem. Phys. 85, 1581 (1986), with s for his a^2/3. The transform, times
//
//   chi = (1 + u^2 + 2 u^4) exp(-u^2),    u = k/(2 xi)
//
// is summed over wavevectors, the rest over images. 1 - chi falls as k^4 for small k, so that the sum over
// images has no mean; wavevector 0 is left out: the volume flux through the box is zero. Spheres nearer than
// touching differ from (1 + s laplacian) oseen in the sum over images alone.

namespace beadswim::direct {

using Vectors = std::vector<Eigen::Vector3d>;

enum class Law { oseen, rotne_prager };

struct Spheres {
  Vectors places;             ///< centres, also outside the box [length]
  std::vector<double> radii;  ///< radii [length]
  Vectors forces;             ///< forces on the fluid [mass length/time^2]
};

/// Tensor identity I + dyad rr, in units of 1/(8 pi eta) [1/length]. r: unit vector between two spheres.
struct Tensor {
  double identity, dyad;

  Tensor operator+(const Tensor& b) const { return {identity + b.identity, dyad + b.dyad}; }
  Tensor operator-(const Tensor& b) const { return {identity - b.identity, dyad - b.dyad}; }
};

inline Tensor lone_sphere(double a) {
  return {4 / (3 * a), 0};
}

/// Returns (1 + s laplacian) oseen: the Rotne-Prager tensor of spheres that do not overlap.
inline Tensor spheres_apart(double s, double r) {
  return {(1 + 2 * s / (r * r)) / r, (1 - 6 * s / (r * r)) / r};
}

inline Tensor spheres_cutting(double a_i, double a_j, double r) {
  const double difference2 = (a_i - a_j) * (a_i - a_j), r3 = r * r * r;
  const double unit = 1 / (24 * a_i * a_j * r3);
  return {unit * (16 * r3 * (a_i + a_j) - std::pow(difference2 + 3 * r * r, 2)),
          unit * 3 * std::pow(difference2 - r * r, 2)};
}

inline Tensor rotne_prager_tensor(double a_i, double a_j, double r) {
  if (r >= a_i + a_j) return spheres_apart((a_i * a_i + a_j * a_j) / 6, r);
  if (r > std::abs(a_i - a_j)) return spheres_cutting(a_i, a_j, r);
  return lone_sphere(std::max(a_i, a_j));
}

/// Returns (1 + s laplacian) oseen multiplied by 1 - chi, without its contribution at r = 0.
inline Tensor screened(double s, double xi, double r) {
  const double t = xi * r, t2 = t * t, q = s / (r * r);
  const double bell = t * std::exp(-t2) * std::numbers::inv_sqrtpi, rest = std::erfc(t);
  const double size_identity = 4 + t2 * (56 + t2 * (-80 + 16 * t2));
  const double size_dyad = -12 + t2 * (-8 + t2 * (64 - 16 * t2));
  return {(rest * (1 + 2 * q) + bell * (-6 + 4 * t2 + q * size_identity)) / r,
          (rest * (1 - 6 * q) + bell * (2 - 4 * t2 + q * size_dyad)) / r};
}

/// Returns (1 + s laplacian) oseen multiplied by chi, which is finite at r = 0, as a power series for xi r <=
/// 1. The series is the integral (4/pi) int chi (1 - s k^2) [I (j_0 - j_1/x) + rr j_2] dk, x = kr, term by
/// term, with int chi u^2n du = (1 + h + 2 h (h + 1)) Gamma(h)/2 at h = n + 1/2.
inline Tensor blurred(double s, double xi, double r) {
  const auto moment = [](double h) { return (1 + h + 2 * h * (h + 1)) * std::tgamma(h) / 2; };
  Tensor sum{0, 0};
  double power = 8 / std::numbers::pi * xi;  // (4/pi) 2 xi (-(2 xi r)^2)^m / (2 m + 3)!
  for (int m = 0; m <= 30; ++m) {
    power /= (2 * m + 2) * (2 * m + 3);
    const double term = power * (moment(m + 0.5) - 4 * xi * xi * s * moment(m + 1.5));
    sum = sum + Tensor{(2 * m + 2) * (2 * m + 2) * term, -(2 * m + 2) * (2 * m) * term};
    power *= -4 * xi * xi * r * r;
  }
  return sum;
}

inline double size_term(Law law, double a_i, double a_j) {
  return law == Law::oseen ? 0 : (a_i * a_i + a_j * a_j) / 6;
}

inline Tensor pair_tensor(Law law, double a_i, double a_j, double r) {
  return law == Law::oseen ? spheres_apart(0, r) : rotne_prager_tensor(a_i, a_j, r);
}

/// Returns the part of a pair's tensor (at r = 0: of a sphere's own tensor) that the sum over wavevectors
/// does not contain.
inline Tensor near_part(const Tensor& whole, double s, double xi, double r) {
  if (xi * r < 1) return whole - blurred(s, xi, r);
  return screened(s, xi, r) + (whole - spheres_apart(s, r));
}

inline Eigen::Vector3d times(const Tensor& tensor, const Eigen::Vector3d& separation,
                             const Eigen::Vector3d& force) {
  const double r = separation.norm();
  if (r == 0) return tensor.identity * force;
  const Eigen::Vector3d unit = separation / r;
  return tensor.identity * force + tensor.dyad * unit.dot(force) * unit;
}

/// Returns the velocities [length/time] in unbounded fluid of dynamic viscosity eta. With Law::oseen no two
/// centres may be equal.
inline Vectors open_velocities(Law law, const Spheres& spheres, double viscosity) {
  Vectors velocities(spheres.places.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    for (std::size_t j = 0; j < velocities.size(); ++j) {
      const Eigen::Vector3d separation = spheres.places[i] - spheres.places[j];
      const Tensor tensor = i == j ? lone_sphere(spheres.radii[i])
                                   : pair_tensor(law, spheres.radii[i], spheres.radii[j], separation.norm());
      velocities[i] += times(tensor, separation, spheres.forces[j]) / (8 * std::numbers::pi * viscosity);
    }
  }
  return velocities;
}

/// Returns the splitting parameter xi [1/length] with which both sums have about equally many terms.
inline double balanced_splitting(const Eigen::Vector3d& lengths) {
  return std::sqrt(std::numbers::pi) / std::cbrt(lengths.prod());
}

/// Range of both sums: they end where exp(-reach^2) is 5e-22.
inline constexpr double reach = 7;

/// Calls visit(n) for all integer vectors n with |n_i| <= last_i.
template <class Visit>
void for_whole_vectors(const Eigen::Vector3d& last, Visit visit) {
  const Eigen::Vector3i end = last.array().floor().cast<int>();
  for (int x = -end[0]; x <= end[0]; ++x) {
    for (int y = -end[1]; y <= end[1]; ++y) {
      for (int z = -end[2]; z <= end[2]; ++z) visit(Eigen::Vector3d(x, y, z));
    }
  }
}

/// Returns the velocity of sphere i caused by sphere j and its images, without the sum over wavevectors,
/// divided by 1/(8 pi eta).
inline Eigen::Vector3d sum_over_images(Law law, const Spheres& spheres, std::size_t i, std::size_t j,
                                       const Eigen::Vector3d& lengths, double xi) {
  const double a_i = spheres.radii[i], a_j = spheres.radii[j], cutoff = std::max(reach / xi, a_i + a_j);
  const Eigen::Array3d apart = spheres.places[i] - spheres.places[j];
  const Eigen::Vector3d nearest = apart - lengths.array() * (apart / lengths.array()).round();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for_whole_vectors(cutoff / lengths.array() + 1, [&](const Eigen::Vector3d& n) {
    const Eigen::Vector3d separation = nearest + lengths.cwiseProduct(n);
    const double r = separation.norm();
    if (r > cutoff) return;
    const bool itself = i == j && n.isZero();
    const Tensor whole = itself ? lone_sphere(a_i) : pair_tensor(law, a_i, a_j, r);
    velocity += times(near_part(whole, size_term(law, a_i, a_j), xi, r), separation, spheres.forces[j]);
  });
  return velocity;
}

/// Adds the contribution of one wavevector to the velocities.
inline void add_wave(Law law, const Spheres& spheres, double viscosity, double volume, double xi,
                     const Eigen::Vector3d& k, Vectors& velocities) {
  const double k2 = k.squaredNorm(), u2 = k2 / (4 * xi * xi);
  const double size = law == Law::oseen ? 0 : k2 / 6;
  Eigen::Vector3cd points = Eigen::Vector3cd::Zero(), sizes = points;
  for (std::size_t j = 0; j < velocities.size(); ++j) {
    const Eigen::Vector3cd wave = std::polar(1., -k.dot(spheres.places[j])) * spheres.forces[j];
    points += wave;
    sizes += size * std::pow(spheres.radii[j], 2) * wave;
  }
  const double factor = (1 + u2 + 2 * u2 * u2) * std::exp(-u2) / (viscosity * k2 * volume);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const Eigen::Vector3cd source = points * (1 - size * std::pow(spheres.radii[i], 2)) - sizes;
    const Eigen::Vector3d wave = (std::polar(factor, k.dot(spheres.places[i])) * source).real();
    velocities[i] += wave - k * (k.dot(wave) / k2);
  }
}

/// Returns the velocities [length/time] in a periodic box. They do not depend on the splitting parameter xi
/// [1/length]. With Law::oseen no two centres may be equal.
inline Vectors periodic_velocities(Law law, const Spheres& spheres, double viscosity,
                                   const Eigen::Vector3d& lengths, double xi) {
  Vectors velocities(spheres.places.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    for (std::size_t j = 0; j < velocities.size(); ++j) {
      velocities[i] += sum_over_images(law, spheres, i, j, lengths, xi) / (8 * std::numbers::pi * viscosity);
    }
  }
  const double cutoff = 2 * xi * reach;
  const Eigen::Array3d first = 2 * std::numbers::pi / lengths.array();
  for_whole_vectors(cutoff / first, [&](const Eigen::Vector3d& n) {
    const Eigen::Vector3d k = first * n.array();
    if (n.isZero() || k.norm() > cutoff) return;
    add_wave(law, spheres, viscosity, lengths.prod(), xi, k, velocities);
  });
  return velocities;
}

inline Vectors periodic_velocities(Law law, const Spheres& spheres, double viscosity,
                                   const Eigen::Vector3d& lengths) {
  return periodic_velocities(law, spheres, viscosity, lengths, balanced_splitting(lengths));
}

/// Returns the spheres, followed by their mirror images behind a wall at 0 across the axis, with the reversed
/// force component along the axis.
inline Spheres with_mirror(Spheres spheres, int axis) {
  const std::size_t count = spheres.places.size();
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d place = spheres.places[i], force = spheres.forces[i];
    place[axis] *= -1;
    force[axis] *= -1;
    spheres.places.push_back(place);
    spheres.radii.push_back(spheres.radii[i]);
    spheres.forces.push_back(force);
  }
  return spheres;
}

/// Returns the velocities [length/time] in a box. Each axis is periodic or has free-slip walls at 0 and at
/// its length.
inline Vectors box_velocities(Law law, Spheres spheres, double viscosity, const Box& box) {
  const std::size_t count = spheres.places.size();
  for (int axis = 0; axis < 3; ++axis) {
    if (box.boundary[axis] == Boundary::free_slip) spheres = with_mirror(std::move(spheres), axis);
  }
  Vectors velocities = periodic_velocities(law, spheres, viscosity, mirrored_lengths(box));
  velocities.resize(count);
  return velocities;
}

/// Returns the mobility matrix [time/mass] that a sum gives, with row and column index 3 i + axis.
/// velocities_of(spheres): returns the velocities for unit forces.
template <class VelocitiesOf>
Eigen::MatrixXd mobility_matrix(Spheres spheres, VelocitiesOf velocities_of) {
  const std::size_t count = spheres.places.size();
  Eigen::MatrixXd matrix(3 * count, 3 * count);
  for (std::size_t column = 0; column < 3 * count; ++column) {
    spheres.forces.assign(count, Eigen::Vector3d::Zero());
    spheres.forces[column / 3][column % 3] = 1;
    const Vectors velocities = velocities_of(spheres);
    for (std::size_t i = 0; i < count; ++i) matrix.block<3, 1>(3 * i, column) = velocities[i];
  }
  return matrix;
}

}  // namespace beadswim::direct
