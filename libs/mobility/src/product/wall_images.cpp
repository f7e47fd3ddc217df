#include "wall_images.hpp"

#include <numbers>

#include "beadswim/mobility/wall_mobility.hpp"
#include "moment_radials.hpp"

namespace beadswim {

void SourceSum::set_positions(std::span<const Vec3> positions) {
  places_.assign(positions.begin(), positions.end());
  if (split_) cells_.emplace(positions, split_->cutoff, spheres_.lengths);
}

void SourceSum::add_flow(std::span<const double> sources, const Vec3& place, int axis,
                         MirrorFlow& flow) const {
  const std::size_t elements = spheres_.elements();
  const int order = spheres_.order, highest = highest_radial(order, receivers_);
  const bool is_periodic = spheres_.lengths[0] > 0;
  const auto from = [&](int sphere) {
    Vec3 r = place - places_[sphere];
    if (is_periodic)
      r -= spheres_.lengths.cwiseProduct(r.cwiseQuotient(spheres_.lengths).array().round().matrix());
    return r;
  };
  SourceLanes batch{};
  MirrorFlowParts parts;
  int used = 0;
  const auto flush = [&] {
    clear_lanes(batch, used);
    const MobilityKernels& kernels = best_kernels<MobilityKernels>();
    if (split_) kernels.near_radials(split_->near, 1 / (8 * std::numbers::pi * spheres_.viscosity), batch);
    kernels.mirror_flow(order, receivers_, axis, batch, split_.has_value(), parts);
    used = 0;
  };
  const auto add = [&](int sphere, const Vec3& r) {
    set_lane(batch, used, r, moment_sizes(spheres_.radii[sphere]),
             sources.subspan(elements * sphere, elements));
    if (!split_) set_radials(batch, used, open_radials(r.norm(), spheres_.viscosity, highest));
    if (++used == lanes) flush();
  };
  if (cells_) {
    cells_->visit_neighbours(place, [&](std::size_t other) {
      const Vec3 r = from(static_cast<int>(other));
      if (r.norm() < split_->cutoff) add(static_cast<int>(other), r);
      return true;
    });
  } else {
    for (int sphere = 0; sphere < std::ssize(places_); ++sphere) add(sphere, from(sphere));
  }
  if (used > 0) flush();
  const auto sum_lanes = [](double& to, const double* part) {
    for (int lane = 0; lane < lanes; ++lane) to += part[lane];
  };
  for (int d = 0; d < derivative_count(order); ++d)
    for (int t = 0; t < 2; ++t) sum_lanes(flow.along[t][d], parts.along[t][d]);
  for (int d = 0; d < derivative_count(order + 2); ++d) {
    sum_lanes(flow.across[d], parts.across[d]);
    sum_lanes(flow.pressure[d], parts.pressure[d]);
  }
}

void WallImages::set_positions(std::span<const Vec3> positions) {
  places_.assign(positions.begin(), positions.end());
  sum_.set_positions(positions);
}

void WallImages::add_flows(std::span<const double> sources, std::span<MirrorFlow> at_mirrors,
                           std::span<double> flows, const Communicator& communicator) const {
  const std::size_t elements = spheres_.elements();
  for (std::size_t b = communicator.rank(); b < places_.size(); b += communicator.size())
    sum_.add_flow(sources, half_space_.mirrored(places_[b]), half_space_.axis, at_mirrors[b]);
  for (std::size_t b = 0; b < places_.size(); ++b)
    add_reflected_flow(spheres_.order, half_space_.axis, half_space_.height(places_[b]),
                       moment_sizes(spheres_.radii[b]), at_mirrors[b], &flows[elements * b]);
}

void WallImages::add_flow(std::span<const double> sources, const Vec3& place, double radius,
                          double* flow) const {
  MirrorFlow at_mirror;
  sum_.add_flow(sources, half_space_.mirrored(place), half_space_.axis, at_mirror);
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
