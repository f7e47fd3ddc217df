#include "shape_flow.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"

namespace beadswim {

SwimmerType with_drives_scaled(SwimmerType type, double factor) {
  for_each_harmonic(type.driving, [factor](Harmonic& harmonic) { harmonic.amplitude *= factor; });
  for (ForceDrive& drive : type.driving.forces) drive.constant *= factor;
  return type;
}

int highest_multiple(const Driving& driving) {
  int highest = 1;
  for_each_harmonic(driving,
                    [&](const Harmonic& harmonic) { highest = std::max(highest, harmonic.multiple); });
  return highest;
}

std::vector<Vec3> rotation_axes(const BeadVectors& shape) {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const auto& x : shape.colwise())
    inertia += x.squaredNorm() * Eigen::Matrix3d::Identity() - x * x.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  constexpr double negligible = 1e-12;
  std::vector<Vec3> axes;
  for (int a = 0; a < 3; ++a) {
    if (principal.eigenvalues()[a] > negligible * principal.eigenvalues()[2])
      axes.push_back(principal.eigenvectors().col(a));
  }
  return axes;
}

Eigen::MatrixXd rigid_motions(const BeadVectors& shape, const std::vector<Vec3>& axes) {
  Eigen::MatrixXd motions(shape.size(), 3 + std::ssize(axes));
  for (int a = 0; a < 3; ++a) motions.col(a) = Vec3::Unit(a).eval().replicate(shape.cols(), 1);
  for (std::size_t r = 0; r < axes.size(); ++r) {
    for (int b = 0; b < shape.cols(); ++b)
      motions.col(3 + r).segment<3>(3 * b) = axes[r].cross(Vec3(shape.col(b)));
  }
  return motions;
}

double smallest_gap(const ShapedSwimmer& swimmer, const BeadVectors& beads) {
  const SwimmerType& type = swimmer.type;
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < beads.cols() && swimmer.domain.half_space; ++i)
    smallest = std::min(
        smallest, swimmer.domain.half_space->height(beads.col(i) + swimmer.place) - type.beads[i].radius);
  for (int i = 0; i < beads.cols(); ++i)
    for (int j = 0; j < i; ++j)
      smallest = std::min(smallest, (beads.col(i) - beads.col(j)).norm() - contact_distance(type, i, j));
  if (!swimmer.domain.box) return smallest;
  std::vector<PlacedBead> placed;
  for (int i = 0; i < beads.cols(); ++i)
    placed.push_back({.centre = beads.col(i) + swimmer.place, .radius = type.beads[i].radius});
  return std::min(smallest, smallest_gap(placed, {.box = swimmer.domain.box}));
}

Eigen::VectorXd bond_lengths(const SwimmerType& type, const BeadVectors& beads) {
  Eigen::VectorXd lengths(std::ssize(type.bonds));
  for (std::size_t k = 0; k < type.bonds.size(); ++k)
    lengths[k] = (beads.col(type.bonds[k].beads[1]) - beads.col(type.bonds[k].beads[0])).norm();
  return lengths;
}

BeadVectors centred(const BeadVectors& beads) {
  return beads.colwise() - Vec3(beads.rowwise().mean());
}

Eigen::Matrix3d best_rotation(const BeadVectors& from, const BeadVectors& to) {
  SwimmerType shape;
  for (const auto& place : from.colwise()) shape.beads.push_back({{}, place});
  return fitted_orientation(shape, to, Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d dipole_of_beads(const ShapedSwimmer& swimmer, const ShapeMobility& mobility,
                                const BeadVectors& beads, const BeadVectors& forces) {
  Eigen::Matrix3d dipole = dipole_of_forces(beads, forces);
  if (mobility.stresslets) dipole += mobility.stresslets(beads, forces);
  const Eigen::Matrix3d frame = fitted_orientation(swimmer.type, beads, swimmer.orientation);
  return frame.transpose() * dipole * frame;
}

ShapeFlow::ShapeFlow(const ShapedSwimmer& swimmer, const ShapeMobility& mobility)
    : swimmer_(swimmer),
      mobility_(mobility),
      is_damped_(std::ranges::any_of(swimmer.type.bonds, [](const Bond& bond) { return bond.damping > 0; })) {
}

void ShapeFlow::require_positive_mobility(const BeadVectors& beads) const {
  if (!mobility_.may_be_indefinite || cholesky_factor(mobility_.matrix(beads))) return;
  throw InputError("stroke",
                   "the mobility by the Oseen tensor is not positive definite: forces would move beads "
                   "backwards, because beads are too close to each other or to the wall; use a method with "
                   "Rotne-Prager pairs");
}

Eigen::MatrixXd ShapeFlow::damping(const BeadVectors& beads) const {
  if (!is_damped_) return Eigen::MatrixXd::Zero(beads.size(), beads.size());
  return own_damping<Eigen::Dynamic>(swimmer_.type, beads);
}

Eigen::VectorXd ShapeFlow::forces(const BeadVectors& beads, double time) const {
  const BeadVectors driving = driving_forces(swimmer_.type, time, beads, swimmer_.orientation);
  return own_forces<Eigen::Dynamic>(swimmer_.type, time, beads) + as_components(driving);
}

Eigen::VectorXd ShapeFlow::velocities(const BeadVectors& beads, double time) const {
  const Eigen::MatrixXd mu = is_damped_ ? mobility_.matrix(beads) : Eigen::MatrixXd();
  Eigen::VectorXd undamped =
      is_damped_ ? mu * forces(beads, time) : mobility_.apply(beads, forces(beads, time));
  if (!swimmer_.flow.is_zero())
    for (Eigen::Index b = 0; b < beads.cols(); ++b)
      undamped.segment<3>(3 * b) += swimmer_.flow.at(beads.col(b) + swimmer_.place);
  if (!is_damped_) return undamped;
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(mu.rows(), mu.cols());
  return solve(unit + mu * damping(beads), undamped);
}

Eigen::MatrixXd ShapeFlow::relaxation(const BeadVectors& beads, double time) const {
  const Eigen::MatrixXd mu = mobility_.estimate(beads);
  const Eigen::MatrixXd undamped = -mu * own_stiffness<Eigen::Dynamic>(swimmer_.type, time, beads);
  if (!is_damped_) return undamped;
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(mu.rows(), mu.cols());
  return solve(unit + mu * damping(beads), undamped);
}

BeadVectors relaxed_shape(const ShapedSwimmer& swimmer) {
  const RelaxedShape shape = relaxed_shape(swimmer.type);
  if (!shape.is_converged)
    throw InputError("the swimmer's shape at rest",
                     "the springs find no shape in which they exert no forces; give bonds and "
                     "angles rest lengths and rest angles that fit together");
  return swimmer.orientation * centred(shape.beads);
}

double towing_drag(const BeadVectors& shape, const Vec3& axis, const ShapeMobility& mobility) {
  const Eigen::VectorXd along = axis.replicate(shape.cols(), 1);
  return along.dot(solve_definite(mobility.matrix(shape), along));
}

}  // namespace beadswim
