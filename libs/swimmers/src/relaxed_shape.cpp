#include "beadswim/swimmers/swimmer_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/dense_systems.hpp"
#include "beadswim/swimmers/hinges.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"

namespace beadswim {
namespace {

double length_of(const Bond& bond, const BeadVectors& beads) {
  return (beads.col(bond.beads[1]) - beads.col(bond.beads[0])).norm();
}

/// Returns the type with the rest lengths and rest angles of time 0, without drives.
SwimmerType springs_at_start(SwimmerType type) {
  for (std::size_t k = 0; k < type.bonds.size(); ++k) type.bonds[k].rest_length = rest_length(type, k, 0);
  for (std::size_t k = 0; k < type.angles.size(); ++k) type.angles[k].rest = rest_angle(type, k, 0);
  type.driving = {};
  return type;
}

double energy_of(const SwimmerType& springs, const BeadVectors& beads) {
  double energy = 0;
  for (const Bond& bond : springs.bonds)
    energy += bond.stiffness / 2 * std::pow(length_of(bond, beads) - bond.rest_length, 2);
  for (std::size_t k = 0; k < springs.angles.size(); ++k)
    energy += springs.angles[k].stiffness / 2 * std::pow(bending_of(springs, k, 0, beads), 2);
  return energy;
}

/// Bonds whose tension the stiffness contains. With compressed bonds it might have negative eigenvalues.
enum class LoadedBonds { none, stretched };

/// Returns the smallest displacement of the beads that balances the forces to first order. Without loaded
/// bonds this is the method of Gauss and Newton.
template <int Size>
BeadVectors balancing_displacement(const SwimmerType& springs, const BeadVectors& beads, LoadedBonds loaded) {
  SwimmerType resisting = springs;
  for (Bond& bond : resisting.bonds) {
    const double length = length_of(bond, beads);
    bond.rest_length = loaded == LoadedBonds::none ? length : std::min(length, bond.rest_length);
  }
  const Eigen::MatrixXd displacement =
      least_squares(own_stiffness<Size>(resisting, 0, beads), own_forces<Size>(springs, 0, beads));
  return Eigen::Map<const Eigen::Matrix3Xd>(displacement.data(), 3, beads.cols());
}

double largest_displacement(const BeadVectors& displacement) {
  return displacement.colwise().norm().maxCoeff();
}

/// Returns beads that are moved to the mean position and turned to the orientation of those at rest. Beads on
/// an axis or in a plane of the type's frame stay there without rounding.
BeadVectors placed_as_at_rest(const SwimmerType& type, const BeadVectors& at, const BeadVectors& beads) {
  const Eigen::Matrix3d fit = fitted_orientation(type, beads, Eigen::Matrix3d::Identity());
  const Vec3 from = beads.rowwise().mean(), to = at.rowwise().mean();
  BeadVectors placed = (fit.transpose() * (beads.colwise() - from)).colwise() + to;
  for (int a = 0; a < 3; ++a)
    if (at.row(a).isZero(0)) placed.row(a).setZero();
  return placed;
}

}  // namespace

bool has_driven_shape(const Driving& driving) {
  return !driving.angles.empty() ||
         std::ranges::count(driving.bonds, BondQuantity::rest_length, &BondDrive::quantity) > 0;
}

RelaxedShape relaxed_shape(const SwimmerType& given) {
  const SwimmerType type = at_rest_angles(given, 0);
  const BeadVectors at = columns_of_beads(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  if (type.bonds.empty()) return {.beads = at, .is_converged = true};
  const SwimmerType springs = springs_at_start(type);
  const auto step_from = type.beads.size() == 3 ? balancing_displacement<size_of_three_beads>
                                                : balancing_displacement<Eigen::Dynamic>;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Bond& bond : springs.bonds)
    shortest = std::min({shortest, length_of(bond, at), bond.rest_length});
  const double size = largest_displacement(at.colwise() - Vec3(at.rowwise().mean()));
  // Displacements, divided by the size: at the end, and from where on roundoff may increase the energy.
  constexpr double converged = 1e-13, small = 1e-7;
  // Springs that do not fit together need more steps, with the stiffness of tensions.
  constexpr int fitting_steps = 50, max_steps = 200;
  constexpr double longest = 0.25;  // step, divided by the shortest bond: the shape changes gradually
  RelaxedShape shape{.beads = at};
  double energy = energy_of(springs, at);
  for (int step = 0; step < max_steps && !shape.is_converged; ++step) {
    BeadVectors change =
        step_from(springs, shape.beads, step < fitting_steps ? LoadedBonds::none : LoadedBonds::stretched);
    change *= std::min(1.0, longest * shortest / largest_displacement(change));
    while (largest_displacement(change) > small * size && !(energy_of(springs, shape.beads + change) < energy))
      change /= 2;
    shape.beads += change;
    energy = energy_of(springs, shape.beads);
    shape.is_converged = largest_displacement(change) <= converged * size;
  }
  shape.beads = placed_as_at_rest(type, at, shape.beads);
  return shape;
}

SwimmerType at_start(SwimmerType type) {
  if (!has_driven_shape(type.driving)) return type;
  const BeadVectors beads = relaxed_shape(type).beads;
  const BeadVectors at = columns_of_beads(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  constexpr double roundoff = 1e-9;
  if (largest_displacement(beads - at) <= roundoff * largest_displacement(at.colwise() - Vec3(at.rowwise().mean()))) return type;
  for (std::size_t b = 0; b < type.beads.size(); ++b) type.beads[b].at = beads.col(b);
  return type;
}

}  // namespace beadswim
