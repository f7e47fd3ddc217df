#include "wall_images.hpp"

#include <numeric>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/wall_mobility.hpp"
#include "moment_kernels.hpp"
#include "moment_radials.hpp"

namespace beadswim {

void WallImages::add_flow_at_mirror(std::span<const Vec3> positions, std::span<const double> sources,
                                    std::span<const int> spheres, const Vec3& point, MirrorFlow& flow) const {
  const int numbers = 3 * derivative_count(law_.order), highest = 2 * law_.order + 4;
  PointSources batch{};
  MirrorFlowParts parts;
  batch.has_bilaplacian = uses_mesh();
  for (std::size_t first = 0; first < spheres.size(); first += lanes) {
    for (int lane = 0; lane < lanes; ++lane) {
      const bool is_used = first + lane < spheres.size();
      const int sphere = spheres[is_used ? first + lane : first];
      const Vec3 r = point - positions[sphere];
      const MomentRadials radials = uses_mesh()
                                        ? near_radials(law_.plan->xi, r.norm(), law_.viscosity, highest)
                                        : open_radials(r.norm(), law_.viscosity, highest);
      for (int a = 0; a < 3; ++a) batch.r[a][lane] = r[a];
      for (int n = 0; n <= highest; ++n) {
        batch.chi[n][lane] = radials.chi[n];
        batch.laplacian[n][lane] = radials.laplacian[n];
        if (n <= highest - 2) batch.bilaplacian[n][lane] = radials.bilaplacian[n];
      }
      const std::array<double, 3> sizes = moment_sizes(law_.radii[sphere]);
      for (int l = 0; l < 3; ++l) batch.size[l][lane] = sizes[l];
      for (int k = 0; k < numbers; ++k) batch.source[k][lane] = is_used ? sources[numbers * sphere + k] : 0;
    }
    best_kernels<MomentKernels>().mirror_flow(law_.order, law_.half_space.axis, batch, parts);
  }
  const auto add = [](double& to, const double* part) {
    for (int lane = 0; lane < lanes; ++lane) to += part[lane];
  };
  for (int d = 0; d < derivative_count(law_.order); ++d)
    for (int c = 0; c < 3; ++c) add(flow.velocity[c][d], parts.velocity[c][d]);
  for (int d = 0; d < derivative_count(law_.order + 2); ++d) {
    add(flow.across[d], parts.across[d]);
    add(flow.pressure[d], parts.pressure[d]);
  }
}

void WallImages::add_flows(std::span<const Vec3> positions, std::span<const double> sources,
                           std::span<double> flows, ParticleMesh* mesh,
                           const Communicator& communicator) const {
  const std::size_t numbers = 3 * derivative_count(law_.order);
  std::vector<MirrorFlow> at_mirrors(positions.size());
  if (uses_mesh()) mesh->add_flows_and_mirrors(law_.half_space, positions, sources, flows, at_mirrors);
  std::vector<int> spheres(positions.size());
  std::iota(spheres.begin(), spheres.end(), 0);
  std::optional<CellList> cells;
  if (uses_mesh()) cells.emplace(positions, law_.plan->cutoff, Vec3::Zero());
  for (std::size_t b = communicator.rank(); b < positions.size(); b += communicator.size()) {
    const Vec3 point = law_.half_space.mirrored(positions[b]);
    if (cells) {
      spheres.clear();
      cells->visit_neighbours(point, [&](std::size_t other) {
        if ((positions[other] - point).norm() < law_.plan->cutoff) spheres.push_back(static_cast<int>(other));
        return true;
      });
    }
    add_flow_at_mirror(positions, sources, spheres, point, at_mirrors[b]);
  }
  for (std::size_t b = 0; b < positions.size(); ++b)
    add_reflected_flow(law_.order, law_.half_space.axis, law_.half_space.height(positions[b]),
                       moment_sizes(law_.radii[b]), at_mirrors[b], &flows[numbers * b]);
}

void WallImages::add_flow(std::span<const Vec3> positions, std::span<const double> sources, const Vec3& place,
                          double radius, double* flow) const {
  MirrorFlow at_mirror;
  std::vector<int> spheres(positions.size());
  std::iota(spheres.begin(), spheres.end(), 0);
  add_flow_at_mirror(positions, sources, spheres, law_.half_space.mirrored(place), at_mirror);
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
