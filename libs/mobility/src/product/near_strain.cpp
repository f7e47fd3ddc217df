#include "near_strain.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "beadswim/mobility/wall_map.hpp"
#include "moment_radials.hpp"
#include "wall_images.hpp"

namespace beadswim {
namespace {

constexpr int moments = moment_count(1), elements = 3 * derivative_count(1);

using Strain = Eigen::Matrix<double, 5, 3>;

/// Returns p and q of near_strain.hpp, of a sphere of radius a by the force on a sphere of radius b at the
/// distance r.
std::pair<double, double> strain_by_force(double r, double a, double b, double viscosity) {
  if (r < a + b) {
    const MomentRadials f = overlap_radials(1, 0, a, b, r, viscosity);
    return {r * (f.laplacian[1] / 2 - f.chi[2]), -r * r * r * f.chi[3]};
  }
  const double c = moment_sizes(a)[1] + moment_sizes(b)[0];
  const double inverse_square = 1 / (r * r), oseen = inverse_square / (8 * std::numbers::pi * viscosity);
  return {-6 * c * inverse_square * oseen, (30 * c * inverse_square - 3) * oseen};
}

}  // namespace

NearStrains::NearStrains(std::span<const double> radii, double viscosity,
                         const std::optional<HalfSpace>& half_space, std::span<const Vec3> positions,
                         NearLinks& links)
    : radii_(radii),
      viscosity_(viscosity),
      half_space_(half_space),
      positions_(positions.begin(), positions.end()),
      links_(links) {
  for (int b = 0; b < std::ssize(radii_); ++b) {
    links_.resistances.emplace_back(Eigen::Matrix<double, 5, 5>::Identity() *
                                    (20 * std::numbers::pi / 3 * viscosity * std::pow(radii_[b], 3)));
    if (half_space_) add_over_wall(b);
  }
}

/// Returns the projections on bead i of the flow that the wall adds to the flow of each of the first `count`
/// moments of bead j.
Eigen::Matrix<double, moments, Eigen::Dynamic> NearStrains::reflected_flow(int i, int j, int count) const {
  WallImages images({.order = 1, .viscosity = viscosity_, .radii = {radii_[j]}}, *half_space_, {});
  images.set_positions({&positions_[j], 1});
  Eigen::Matrix<double, moments, Eigen::Dynamic> result(moments, count);
  for (int m = 0; m < count; ++m) {
    double moment[moments]{}, source[elements], flow[elements]{};
    moment[m] = 1;
    source_of_moments(1, radii_[j], moment, source);
    images.add_flow(source, positions_[i], radii_[i], flow);
    project_flow(1, radii_[i], flow, result.col(m).data());
  }
  return result;
}

void NearStrains::add_over_wall(int bead) {
  const int axis = half_space_->axis;
  double& z = positions_[bead][axis];
  z = std::max(z, min_wall_height * radii_[bead]);
  const double height = z / radii_[bead], weight = pair_weight(height);
  double mobility = rotne_prager_towards_wall(height);
  Eigen::Matrix<double, 5, 5>& resistance = links_.resistances[bead];
  if (weight != 0) {
    const auto reflected = reflected_flow(bead, bead, moments);
    const Strain by_force = reflected.bottomLeftCorner<5, 3>();
    const Eigen::Matrix<double, 5, 5> by_wall = reflected.bottomRightCorner<5, 5>(),
                                      strain = resistance.inverse() + by_wall;
    resistance = (strain - (1 - weight) * by_wall).inverse();
    links_.wall_strains.push_back({bead, bead, weight * by_force});
    const Eigen::Matrix<double, 5, 1> across = weight * resistance * by_force.col(axis);
    mobility -=
        across.dot(2 * by_force.col(axis) - strain * across) / self_mobility(radii_[bead], viscosity_);
  }
  const double log = log_wall_map(height, mobility);
  if (log != 0) links_.walls.push_back({bead, Vec3::Unit(axis), log});
}

void NearStrains::add(int bead, int partner, const Vec3& separation, bool is_image, const Vec3& mirror,
                      double weight) {
  const double a = radii_[bead], b = radii_[partner], r = std::max(separation.norm(), 1e-6 * a);
  const auto [p, q] = strain_by_force(r, a, b, viscosity_);
  const auto [p_partner, q_partner] = a == b ? std::pair(p, q) : strain_by_force(r, b, a, viscosity_);
  links_.strains.push_back({.bead = bead,
                            .partner = partner,
                            .is_image = is_image,
                            .mirror = mirror,
                            .axis = separation / r,
                            .p = {weight * p, weight * p_partner},
                            .q = {weight * q, weight * q_partner}});
  if (!half_space_) return;
  add_reflected(bead, partner, weight);
  add_reflected(partner, bead, weight);
}

void NearStrains::add_reflected(int strained, int forced, double weight) {
  const double to_mirror_point = (half_space_->mirrored(positions_[forced]) - positions_[strained]).norm();
  const double share = weight * pair_weight(to_mirror_point / (radii_[strained] + radii_[forced]));
  if (share != 0)
    links_.wall_strains.push_back(
        {strained, forced, share * reflected_flow(strained, forced, 3).bottomRows<5>()});
}

}  // namespace beadswim
