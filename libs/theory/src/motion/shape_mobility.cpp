#include <memory>
#include <vector>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/wall_mobility.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_flow.hpp"

namespace beadswim {
namespace {

std::vector<double> radii_of(const ShapedSwimmer& swimmer) {
  std::vector<double> radii;
  for (const Bead& bead : swimmer.type.beads) radii.push_back(bead.radius);
  return radii;
}

/// A mobility on this process alone.
struct LocalMobility {
  Communicator alone{};
  Mobility mobility;

  LocalMobility(const MobilityScene& scene, std::span<const Vec3> positions)
      : mobility(scene, positions, alone) {}
};

std::vector<Vec3> list_of(const BeadVectors& vectors, const Vec3& offset) {
  std::vector<Vec3> list;
  for (const auto& vector : vectors.colwise()) list.emplace_back(vector + offset);
  return list;
}

Eigen::VectorXd velocities_by(Mobility& mobility, const Eigen::VectorXd& forces) {
  const std::vector<Vec3> list = list_of(as_beads(forces), Vec3::Zero());
  std::vector<Vec3> velocities(list.size());
  if (!mobility.apply(list, velocities).is_converged)
    throw SolverError(
        "the force moments on the beads were not found within 100 iterations; move the beads apart, or use a "
        "method with Rotne-Prager pairs");
  return as_components(columns_of_beads(velocities));
}

}  // namespace

ShapeMobility pair_mobility(const ShapedSwimmer& swimmer, PairTensorLaw law) {
  const bool are_points = law == oseen_pairs;
  const auto matrix = [&swimmer, law, are_points](const BeadVectors& beads) {
    auto mu = mobility_matrix<Eigen::MatrixXd>(law, swimmer.type.beads, beads, swimmer.viscosity);
    if (!swimmer.domain.half_space) return mu;
    const std::vector<double> radii = are_points ? std::vector<double>(beads.cols(), 0.0) : radii_of(swimmer);
    add_wall_mobility(*swimmer.domain.half_space, radii, beads.colwise() + swimmer.place, swimmer.viscosity,
                      mu);
    return mu;
  };
  const auto apply = [matrix](const BeadVectors& beads, const Eigen::VectorXd& forces) -> Eigen::VectorXd {
    return matrix(beads) * forces;
  };
  return {.matrix = matrix, .apply = apply, .estimate = matrix, .may_be_indefinite = are_points};
}

ShapeMobility moment_mobility(const ShapedSwimmer& swimmer, int order) {
  constexpr double tolerance_in_box = 1e-10, tolerance_in_open_space = 1e-12;
  const MobilityScene scene{.model = MobilityModel::multipole,
                            .viscosity = swimmer.viscosity,
                            .domain = swimmer.domain,
                            .radii = radii_of(swimmer),
                            .tolerance = swimmer.domain.box ? tolerance_in_box : tolerance_in_open_space,
                            .moment_order = order};
  const auto local = std::make_shared<LocalMobility>(
      scene, rest_positions(swimmer.type, swimmer.place, swimmer.orientation));
  const auto at = [local, &swimmer](const BeadVectors& beads) -> Mobility& {
    local->mobility.set_positions(list_of(beads, swimmer.place));
    return local->mobility;
  };
  const auto matrix = [at](const BeadVectors& beads) {
    Mobility& mobility = at(beads);
    Eigen::MatrixXd mu = Eigen::MatrixXd::Identity(beads.size(), beads.size());
    for (auto column : mu.colwise()) column = velocities_by(mobility, column).eval();
    return mu;
  };
  const auto apply = [at](const BeadVectors& beads, const Eigen::VectorXd& forces) {
    return velocities_by(at(beads), forces);
  };
  const auto stresslets = [at, order](const BeadVectors& beads, const BeadVectors& forces) {
    Mobility& mobility = at(beads);
    velocities_by(mobility, forces.reshaped());
    const std::span<const double> moments = mobility.moments();
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t first = 3; order > 0 && first < moments.size(); first += moment_count(order))
      sum += stresslet_of(&moments[first]);
    return sum;
  };
  return {.matrix = matrix,
          .apply = apply,
          .estimate = pair_mobility(swimmer, rotne_prager_tensor).matrix,
          .stresslets = stresslets};
}

}  // namespace beadswim
