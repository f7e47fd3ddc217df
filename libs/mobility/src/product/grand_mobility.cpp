#include "grand_mobility.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ewald_split.hpp"

namespace beadswim {
namespace {

/// Returns the spheres of the scene with their mirror images.
ImagedSpheres imaged_spheres(const MobilityScene& scene) {
  ImagedSpheres spheres{.order = highest_moment(scene),
                        .viscosity = scene.viscosity,
                        .radii = scene.radii,
                        .lengths = mirrored_lengths(scene.domain.box)};
  if (!has_finite_radii(scene.model)) std::ranges::fill(spheres.radii, 0);
  for (int m = 0; m < mirror_count(scene.domain.box); ++m) {
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
  if (ranks > 1)
    MPI_Alltoall(parts.data(), count, MPI_DOUBLE, arrived.data(), count, MPI_DOUBLE, communicator.get());
  else
    arrived = parts;
  for (int r = 0; r < ranks; ++r)
    for (std::size_t k = 0; k < each; ++k) sums[k] += arrived[r * each + k];
  if (ranks > 1)
    MPI_Allgather(sums.data(), count, MPI_DOUBLE, parts.data(), count, MPI_DOUBLE, communicator.get());
  else
    parts = sums;
  std::copy_n(parts.begin(), numbers.size(), numbers.begin());
}

}  // namespace

GrandMobility::GrandMobility(const MobilityScene& scene, const std::optional<EwaldPlan>& plan,
                             const Communicator& communicator)
    : domain_(scene.domain),
      radii_(scene.radii),
      spheres_(imaged_spheres(scene)),
      communicator_(communicator),
      is_for_noise_(plan && plan->is_positive),
      pairs_(spheres_, plan, 2 * *std::ranges::max_element(scene.radii)) {
  if (scene.domain.half_space) wall_.emplace(spheres_, *scene.domain.half_space, plan);
  const std::optional<FluidMemory> memory = inertial_memory(scene.memory);
  if (plan)
    mesh_ = std::make_unique<ParticleMesh>(*plan, spheres_, memory, scene.domain.half_space,
                                           Receivers::spheres, communicator);
  if (memory) unresolved_.emplace(radii_, order(), scene.viscosity, *memory, mesh_->memory()->cutoff());
  std::optional<EwaldSplit> split;
  if (plan) split.emplace(plan->cutoff, plan->shape);
  std::map<double, std::shared_ptr<const SelfMobility>> by_radius;
  for (std::size_t b = 0; b < radii_.size(); ++b) {
    auto& self = by_radius[radii_[b]];
    if (!self) self = std::make_shared<SelfMobility>(self_mobility_of(b, split));
    self_.push_back(self);
  }
}

GrandMobility::SelfMobility GrandMobility::self_mobility_of(std::size_t sphere,
                                                            const std::optional<EwaldSplit>& split) const {
  const Eigen::MatrixXd whole = moment_self_mobility(order(), radii_[sphere], spheres_.viscosity);
  const Eigen::Index higher = moments_per_sphere() - 3;
  SelfMobility self{.beside_mesh = whole, .inverse = whole.inverse().bottomRightCorner(higher, higher)};
  if (!split) return self;
  const double radius = spheres_.radii[sphere];
  if (order() == 0)
    self.beside_mesh.diagonal().array() -=
        far_tensor(*split, 0, spheres_.viscosity)
            .sphere_tensor(
                {.squares = 2 * radius * radius, .product = is_for_noise_ ? std::pow(radius, 4) : 0})
            .isotropic;
  else
    self.beside_mesh -= far_moment_self_mobility(split->far_integrals(), order(), radius, spheres_.viscosity);
  return self;
}

void GrandMobility::set_positions(std::span<const Vec3> positions) {
  std::vector<Vec3> places(positions.begin(), positions.end());
  add_mirror_images(domain_.box, places);
  pairs_.set_positions(places, positions.size());
  if (mesh_) {
    mesh_->set_sources(places, bounding_box(positions));
    mesh_->set_receivers(is_for_noise_ ? places : positions);
  }
  if (wall_) wall_->set_positions(positions);
}

/// Returns the sources of all spheres and images.
std::vector<double> GrandMobility::sources_of(std::span<const double> moments) const {
  const std::size_t count = moments_per_sphere(), elements = spheres_.elements();
  std::vector<double> sources(elements * radii_.size());
  for (std::size_t b = 0; b < radii_.size(); ++b)
    source_of_moments(order(), radii_[b], &moments[count * b], &sources[elements * b]);
  add_mirror_sources(domain_.box, order(), sources);
  return sources;
}

void GrandMobility::apply(std::span<const double> moments, std::span<double> projections, FlowPart part) {
  const int count = moments_per_sphere();
  const std::size_t elements = spheres_.elements();
  const std::vector<double> sources = sources_of(moments);
  std::vector<double> flows(elements * radii_.size(), 0.0);
  std::vector<MirrorFlow> at_mirrors(wall_ ? radii_.size() : 0);
  pairs_.add_flows(sources, flows, communicator_);
  if (mesh_ && part != FlowPart::near) mesh_->add_flows(sources, part, flows, at_mirrors);
  if (wall_) wall_->add_flows(sources, at_mirrors, flows, communicator_);
  sum_over_ranks(flows, communicator_);
  for (std::size_t b = 0; b < radii_.size(); ++b) {
    if (order() == 0) {
      const double own = self_[b]->beside_mesh(0, 0);
      for (int c = 0; c < 3; ++c) projections[3 * b + c] = flows[3 * b + c] + own * moments[3 * b + c];
      continue;
    }
    project_flow(order(), radii_[b], &flows[elements * b], &projections[count * b]);
    Eigen::Map<Eigen::VectorXd>(&projections[count * b], count).noalias() +=
        self_[b]->beside_mesh * Eigen::Map<const Eigen::VectorXd>(&moments[count * b], count);
  }
  if (unresolved_) unresolved_->add_projections(moments, part, projections);
}

// The sum over all images in the doubled box has 2^m times the covariance of the spheres, for m axes with
// mirrors.
void GrandMobility::set_far_noise(std::uint64_t seed, std::span<double> velocities) {
  std::vector<double> flows(3 * spheres_.radii.size(), 0.0);
  mesh_->set_noise(seed);
  mesh_->gather_flows(flows, {});
  for (int a = 2; a >= 0; --a) {
    if (!domain_.box->has_mirrors(a)) continue;
    const std::size_t half = flows.size() / 2;
    for (std::size_t k = 0; k < half; ++k)
      flows[k] = (flows[k] + (static_cast<int>(k % 3) == a ? -1 : 1) * flows[half + k]) / std::numbers::sqrt2;
    flows.resize(half);
  }
  sum_over_ranks(flows, communicator_);
  std::ranges::copy(flows, velocities.begin());
}

void GrandMobility::add_flow_at(std::span<const Vec3> points, std::span<const Vec3> positions,
                                std::span<const double> moments, const std::optional<EwaldPlan>& plan,
                                std::span<const int> spheres, std::span<Vec3> velocities) {
  const std::vector<double> sources = sources_of(moments);
  std::vector<Vec3> places(positions.begin(), positions.end());
  add_mirror_images(domain_.box, places);
  const bool is_mirrored_on_mesh = plan && plan->has_mirror_points;
  SourceSum near(spheres_, Receivers::points, plan),
      mirrors(spheres_, Receivers::points, is_mirrored_on_mesh ? plan : std::nullopt);
  near.set_positions(places);
  mirrors.set_positions(places);
  std::optional<ParticleMesh> mesh;
  if (plan) {
    mesh.emplace(*plan, spheres_, std::nullopt, domain_.half_space, Receivers::points, communicator_);
    mesh->set_sources(places, bounding_box(points));
    mesh->evaluate(sources, FlowPart::forces);
  }
  if (has_memory()) mesh_->evaluate_remainder();
  constexpr std::size_t points_at_once = 1 << 15;  // bounds the memory for the flow at mirror points
  const int axis = domain_.half_space ? domain_.half_space->axis : 2;
  for (std::size_t first = 0; first < points.size(); first += points_at_once) {
    const auto chunk = points.subspan(first, std::min(points_at_once, points.size() - first));
    std::vector<double> flows(3 * chunk.size(), 0.0);
    std::vector<MirrorFlow> at_mirrors(domain_.half_space ? chunk.size() : 0);
    if (mesh) {
      mesh->set_receivers(chunk);
      mesh->gather_flows(flows, at_mirrors);
    }
    if (has_memory()) mesh_->gather_remainder(chunk, flows);
    for (std::size_t p = communicator_.rank(); p < chunk.size(); p += communicator_.size()) {
      if (spheres[first + p] >= 0) continue;
      MirrorFlow flow;
      near.add_flow(sources, chunk[p], axis, flow);
      for (int t = 0; t < 2; ++t) flows[3 * p + (axis + 1 + t) % 3] += flow.along[t][0];
      flows[3 * p + axis] += flow.across[0];
      if (domain_.half_space)
        mirrors.add_flow(sources, domain_.half_space->mirrored(chunk[p]), axis, at_mirrors[p]);
    }
    for (std::size_t p = 0; p < at_mirrors.size(); ++p)
      add_reflected_flow(0, axis, domain_.half_space->height(chunk[p]), {}, at_mirrors[p], &flows[3 * p]);
    sum_over_ranks(flows, communicator_);
    for (std::size_t p = 0; p < chunk.size(); ++p) velocities[first + p] += Vec3::Map(&flows[3 * p]);
  }
}

std::vector<double> GrandMobility::precondition(std::span<const double> projections) const {
  const int count = moments_per_sphere();
  std::vector<double> moments(projections.size(), 0.0);
  for (std::size_t b = 0; b < radii_.size(); ++b)
    Eigen::Map<Eigen::VectorXd>(moments.data() + count * b + 3, count - 3) =
        self_[b]->inverse * Eigen::Map<const Eigen::VectorXd>(projections.data() + count * b + 3, count - 3);
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
