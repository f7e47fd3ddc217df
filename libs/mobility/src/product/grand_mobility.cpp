#include "grand_mobility.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "beadswim/mobility/ewald_split.hpp"

namespace beadswim {
namespace {

/// Returns the spheres of the scene with their mirror images.
ImagedSpheres imaged_spheres(const MobilityScene& scene) {
  ImagedSpheres spheres{.order = highest_moment(scene),
                        .viscosity = scene.viscosity,
                        .radii = scene.radii,
                        .lengths = mirrored_lengths(scene.box)};
  if (!has_finite_radii(scene.model)) std::ranges::fill(spheres.radii, 0);
  for (int m = 0; m < mirror_count(scene.box); ++m) {
    const std::vector<double> present = spheres.radii;
    spheres.radii.insert(spheres.radii.end(), present.begin(), present.end());
  }
  return spheres;
}

/// Appends the derivatives of point forces of the mirror images (add_mirror_images()): across the wall, the
/// component of the force and each derivative change their sign.
void add_mirror_sources(const std::optional<Box>& box, int order, std::vector<double>& sources) {
  const int count = derivative_count(order);
  for (int a = 0; a < 3 && box; ++a) {
    if (!box->has_mirrors(a)) continue;
    const std::size_t present = sources.size();
    for (std::size_t k = 0; k < present; ++k) {
      const int d = static_cast<int>(k % count), c = static_cast<int>(k / count % 3);
      const int changes = derivative_table.degree[d][a] + (c == a ? 1 : 0);
      sources.push_back(changes % 2 == 0 ? sources[k] : -sources[k]);
    }
  }
}

/// Replaces numbers by their sum over all ranks. The sum is always evaluated in the order of the ranks, so
/// its bits depend only on the number of ranks. Collective.
void sum_over_ranks(std::span<double> numbers, const Communicator& communicator) {
  const int ranks = communicator.size();
  if (ranks == 1) return;
  const std::size_t each = (numbers.size() + ranks - 1) / ranks;
  std::vector<double> parts(numbers.begin(), numbers.end());
  parts.resize(each * ranks, 0.0);
  std::vector<double> arrived(each * ranks), sums(each, 0.0);
  const int count = static_cast<int>(each);
  MPI_Alltoall(parts.data(), count, MPI_DOUBLE, arrived.data(), count, MPI_DOUBLE, communicator.get());
  for (int r = 0; r < ranks; ++r)
    for (std::size_t k = 0; k < each; ++k) sums[k] += arrived[r * each + k];
  MPI_Allgather(sums.data(), count, MPI_DOUBLE, parts.data(), count, MPI_DOUBLE, communicator.get());
  std::copy_n(parts.begin(), numbers.size(), numbers.begin());
}

/// Returns the factor of the self-mobility that depends on the radius: 1/a for F and Q, 1/a^3 for S.
double self_mobility_scale(int degree, double radius) {
  return degree == 1 ? 1 / (radius * radius * radius) : 1 / radius;
}

}  // namespace

GrandMobility::GrandMobility(const MobilityScene& scene, const std::optional<EwaldPlan>& plan,
                             const Communicator& communicator)
    : box_(scene.box),
      radii_(scene.radii),
      spheres_(imaged_spheres(scene)),
      communicator_(communicator),
      pairs_(spheres_, plan, 2 * *std::ranges::max_element(scene.radii)),
      self_(moment_self_mobility(order(), 1, scene.viscosity)),
      inverse_self_(self_.inverse()) {
  if (scene.half_space) wall_.emplace(spheres_, *scene.half_space, plan);
  const std::optional<FluidMemory> memory = inertial_memory(scene.memory);
  if (plan) mesh_ = std::make_unique<ParticleMesh>(*plan, spheres_, memory, scene.half_space, communicator);
  if (memory) unresolved_.emplace(radii_, order(), scene.viscosity, *memory, mesh_->memory()->cutoff());
  for (std::size_t b = 0; b < radii_.size(); ++b) {
    const double a = spheres_.radii[b];
    self_forces_.push_back(self_mobility(radii_[b], scene.viscosity));
    if (plan) self_forces_.back() -= far_self_mobility(plan->xi, a * a, scene.viscosity);
  }
}

void GrandMobility::set_positions(std::span<const Vec3> positions) {
  std::vector<Vec3> places(positions.begin(), positions.end());
  add_mirror_images(box_, places);
  pairs_.set_positions(places, positions.size());
  if (mesh_) mesh_->set_positions(places, positions.size());
  if (wall_) wall_->set_positions(positions);
}

/// Returns the sources of all spheres and images.
std::vector<double> GrandMobility::sources_of(std::span<const double> moments) const {
  const std::size_t count = moments_per_sphere(), elements = spheres_.elements();
  std::vector<double> sources(elements * radii_.size());
  for (std::size_t b = 0; b < radii_.size(); ++b)
    source_of_moments(order(), radii_[b], &moments[count * b], &sources[elements * b]);
  add_mirror_sources(box_, order(), sources);
  return sources;
}

void GrandMobility::apply(std::span<const double> moments, std::span<double> projections, FlowPart part) {
  const int count = moments_per_sphere();
  const std::size_t elements = spheres_.elements();
  const std::vector<double> sources = sources_of(moments);
  std::vector<double> flows(elements * radii_.size(), 0.0);
  pairs_.add_flows(sources, flows, communicator_);
  if (mesh_ && !(wall_ && wall_->uses_mesh())) mesh_->add_flows(sources, part, flows);
  if (wall_) wall_->add_flows(sources, flows, mesh_.get(), communicator_);
  sum_over_ranks(flows, communicator_);
  if (mesh_ && order() > 0) pairs_.subtract_far_flow(sources, flows);
  for (std::size_t b = 0; b < radii_.size(); ++b) {
    project_flow(order(), radii_[b], &flows[elements * b], &projections[count * b]);
    if (order() == 0) {
      for (int c = 0; c < 3; ++c) projections[3 * b + c] += self_forces_[b] * moments[3 * b + c];
      continue;
    }
    for (int m = 0; m < count; ++m)
      for (int k = 0; k < count; ++k)
        projections[count * b + m] +=
            self_mobility_scale(degree_of_moment(m), radii_[b]) * self_(m, k) * moments[count * b + k];
  }
  if (unresolved_) unresolved_->add_projections(moments, part, projections);
}

std::vector<double> GrandMobility::precondition(std::span<const double> projections) const {
  const int count = moments_per_sphere();
  std::vector<double> moments(projections.size(), 0.0);
  for (std::size_t b = 0; count * b < projections.size(); ++b)
    for (int m = 3; m < count; ++m)
      for (int k = 3; k < count; ++k)
        moments[count * b + m] += inverse_self_(m, k) / self_mobility_scale(degree_of_moment(m), radii_[b]) *
                                  projections[count * b + k];
  return moments;
}

void GrandMobility::start(std::span<const double> moments) {
  mesh_->read_sources(sources_of(moments));
  modes().start();
  unresolved_->start(moments);
}

void GrandMobility::end_step(std::span<const double> moments, const Vec3& mean_flow) {
  mesh_->read_sources(sources_of(moments));
  modes().end_step(mean_flow);
  unresolved_->end_step(moments);
}

}  // namespace beadswim
