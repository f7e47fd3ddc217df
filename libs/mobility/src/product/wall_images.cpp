#include "wall_images.hpp"

#include <numeric>

#include "beadswim/mobility/wall_mobility.hpp"
#include "moment_radials.hpp"

namespace beadswim {

void WallImages::set_positions(std::span<const Vec3> positions) {
  places_.assign(positions.begin(), positions.end());
  all_.resize(positions.size());
  std::iota(all_.begin(), all_.end(), 0);
  if (uses_mesh()) cells_.emplace(positions, plan_->cutoff, Vec3::Zero());
}

void WallImages::add_flow_at_mirror(std::span<const double> sources, std::span<const int> spheres,
                                    const Vec3& point, MirrorFlow& flow) const {
  const std::size_t elements = spheres_.elements();
  const int highest = 2 * spheres_.order + 4;
  SourceLanes batch{};
  MirrorFlowParts parts;
  for (std::size_t first = 0; first < spheres.size(); first += lanes) {
    const int used = static_cast<int>(std::min<std::size_t>(lanes, spheres.size() - first));
    for (int lane = 0; lane < used; ++lane) {
      const int sphere = spheres[first + lane];
      const Vec3 r = point - places_[sphere];
      set_lane(batch, lane, r,
               uses_mesh() ? near_radials(plan_->xi, r.norm(), spheres_.viscosity, highest)
                           : open_radials(r.norm(), spheres_.viscosity, highest),
               moment_sizes(spheres_.radii[sphere]), sources.subspan(elements * sphere, elements));
    }
    clear_lanes(batch, used);
    best_kernels<MobilityKernels>().mirror_flow(spheres_.order, half_space_.axis, batch, uses_mesh(), parts);
  }
  const auto add = [](double& to, const double* part) {
    for (int lane = 0; lane < lanes; ++lane) to += part[lane];
  };
  for (int d = 0; d < derivative_count(spheres_.order); ++d)
    for (int c = 0; c < 3; ++c) add(flow.velocity[c][d], parts.velocity[c][d]);
  for (int d = 0; d < derivative_count(spheres_.order + 2); ++d) {
    add(flow.across[d], parts.across[d]);
    add(flow.pressure[d], parts.pressure[d]);
  }
}

void WallImages::add_flows(std::span<const double> sources, std::span<double> flows, ParticleMesh* mesh,
                           const Communicator& communicator) const {
  const std::size_t elements = spheres_.elements();
  std::vector<MirrorFlow> at_mirrors(places_.size());
  if (uses_mesh()) mesh->add_flows_and_mirrors(sources, flows, at_mirrors);
  std::vector<int> near;
  for (std::size_t b = communicator.rank(); b < places_.size(); b += communicator.size()) {
    const Vec3 point = half_space_.mirrored(places_[b]);
    if (cells_) {
      near.clear();
      cells_->visit_neighbours(point, [&](std::size_t other) {
        if ((places_[other] - point).norm() < plan_->cutoff) near.push_back(static_cast<int>(other));
        return true;
      });
    }
    add_flow_at_mirror(sources, cells_ ? near : all_, point, at_mirrors[b]);
  }
  for (std::size_t b = 0; b < places_.size(); ++b)
    add_reflected_flow(spheres_.order, half_space_.axis, half_space_.height(places_[b]),
                       moment_sizes(spheres_.radii[b]), at_mirrors[b], &flows[elements * b]);
}

void WallImages::add_flow(std::span<const double> sources, const Vec3& place, double radius,
                          double* flow) const {
  MirrorFlow at_mirror;
  add_flow_at_mirror(sources, all_, half_space_.mirrored(place), at_mirror);
  add_reflected_flow(spheres_.order, half_space_.axis, half_space_.height(place), moment_sizes(radius),
                     at_mirror, flow);
}

void add_wall_mobility(const HalfSpace& half_space, std::span<const double> radii,
                       const Eigen::Matrix3Xd& positions, double viscosity, Eigen::MatrixXd& mobility) {
  for (Eigen::Index j = 0; j < positions.cols(); ++j) {
    const Vec3 source = positions.col(j);
    WallImages images({.viscosity = viscosity, .radii = {radii[j]}}, half_space, {});
    images.set_positions({&source, 1});
    for (int c = 0; c < 3; ++c) {
      const Vec3 force = Vec3::Unit(c);
      for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        Vec3 flow = Vec3::Zero();
        images.add_flow({force.data(), 3}, positions.col(i), radii[i], flow.data());
        mobility.block<3, 1>(3 * i, 3 * j + c) += flow;
      }
    }
  }
}

}  // namespace beadswim
