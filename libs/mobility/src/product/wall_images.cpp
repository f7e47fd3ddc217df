#include "wall_images.hpp"

#include <numbers>

#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/wall_mobility.hpp"
#include "moment_kernels.hpp"

namespace beadswim {

MirrorFlow WallImages::flow_at_mirror(std::span<const Vec3> positions, std::span<const double> sources,
                                      const Vec3& point) const {
  const int numbers = 3 * derivative_count(law_.order), highest = 2 * law_.order + 4;
  MirrorFlow flow;
  PointSources batch{};
  for (std::size_t first = 0; first < positions.size(); first += lanes) {
    for (int lane = 0; lane < lanes; ++lane) {
      const bool is_used = first + lane < positions.size();
      const std::size_t sphere = is_used ? first + lane : first;
      const Vec3 r = point - positions[sphere];
      const double inverse = 1 / r.norm();
      for (int a = 0; a < 3; ++a) batch.r[a][lane] = r[a];
      double value = inverse / (8 * std::numbers::pi * law_.viscosity);  // ((1/r) d/dr)^n (1/r)
      for (int n = 0; n <= highest; ++n) {
        if (n < highest) batch.chi[n + 1][lane] = value;
        batch.laplacian[n][lane] = 2 * value;
        value *= -(2 * n + 1) * inverse * inverse;
      }
      for (int l = 0; l < 3; ++l) batch.size[l][lane] = moment_sizes(law_.radii[sphere])[l];
      for (int k = 0; k < numbers; ++k) batch.source[k][lane] = is_used ? sources[numbers * sphere + k] : 0;
    }
    moment_kernels().mirror_flow(law_.order, law_.half_space.axis, batch, flow);
  }
  return flow;
}

void WallImages::add_flows(std::span<const Vec3> positions, std::span<const double> sources,
                           std::span<double> flows, const Communicator& communicator) const {
  const int numbers = 3 * derivative_count(law_.order);
  for (std::size_t b = communicator.rank(); b < positions.size(); b += communicator.size())
    add_flow(positions, sources, positions[b], law_.radii[b], &flows[numbers * b]);
}

void WallImages::add_flow(std::span<const Vec3> positions, std::span<const double> sources, const Vec3& place,
                          double radius, double* flow) const {
  const MirrorFlow at_mirror = flow_at_mirror(positions, sources, law_.half_space.mirrored(place));
  add_reflected_flow(law_.order, law_.half_space.axis, law_.half_space.height(place), moment_sizes(radius),
                     at_mirror, flow);
}

void add_wall_mobility(const HalfSpace& half_space, std::span<const double> radii,
                       const Eigen::Matrix3Xd& positions, double viscosity, Eigen::MatrixXd& mobility) {
  for (Eigen::Index j = 0; j < positions.cols(); ++j) {
    const WallImages images(
        {.order = 0, .viscosity = viscosity, .half_space = half_space, .radii = {radii[j]}});
    const Vec3 source = positions.col(j);
    for (int c = 0; c < 3; ++c) {
      const Vec3 force = Vec3::Unit(c);
      for (Eigen::Index i = 0; i < positions.cols(); ++i) {
        const Vec3 place = positions.col(i);
        Vec3 flow = Vec3::Zero();
        images.add_flow({&source, 1}, {force.data(), 3}, place, radii[i], flow.data());
        mobility.block<3, 1>(3 * i, 3 * j + c) += flow;
      }
    }
  }
}

}  // namespace beadswim
