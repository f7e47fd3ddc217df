#include "beadswim/mobility/mobility_product.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_split.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "beadswim/mobility/particle_mesh.hpp"
#include "memory_field.hpp"
#include "moment_product.hpp"
#include "near_pairs.hpp"
#include "sum_over_ranks.hpp"
#include "unresolved_memory.hpp"
#include "wall_images.hpp"

namespace beadswim {
namespace {

/// Smallest number of spheres for which a mesh is used in open space. For fewer spheres and forces alone, a
/// sum over all pairs takes no longer.
constexpr std::size_t min_spheres_on_mesh = 1000;

/// Returns a view of the components of all vectors.
auto flat(auto&& vectors) {
  return std::span(vectors[0].data(), 3 * vectors.size());
}

void check(const MobilityScene& scene) {
  if (scene.radii.empty())
    throw InputError("mobility", "the list of radii is empty; give at least one sphere");
  for (const double radius : scene.radii)
    if (!(radius > 0 && std::isfinite(radius)))
      throw InputError(
          "mobility",
          fmt::format("the radius {} of a sphere is invalid; a finite number greater than 0 is needed",
                      radius));
  if (!(scene.viscosity > 0 && std::isfinite(scene.viscosity)))
    throw InputError("mobility",
                     fmt::format("the viscosity {} is invalid; a finite number greater than 0 is needed",
                                 scene.viscosity));
  if (scene.moment_order < 0 || scene.moment_order > max_moment_order)
    throw InputError("mobility", fmt::format("the order {} of the force moments is invalid; give 0, 1 or 2",
                                             scene.moment_order));
  if (scene.memory && !scene.box)
    throw InputError("mobility", "a fluid with memory needs a box; give a box, or leave the memory out");
  if (scene.box && (scene.half_space || !scene.flow.is_zero()))
    throw InputError("mobility",
                     "a half-space or a background flow is incompatible with a box; leave the box out");
  if (!scene.box) return;
  for (const double length : scene.box->lengths)
    if (!(length > 0 && std::isfinite(length)))
      throw InputError(
          "mobility",
          fmt::format("the box edge {} is invalid; a finite number greater than 0 is needed", length));
}

int highest_moment(const MobilityScene& scene) {
  return has_moment_order(scene.model) ? scene.moment_order : 0;
}

EwaldScene ewald_scene(const MobilityScene& scene, std::span<const Vec3> positions) {
  EwaldScene ewald{.lengths = mirrored_lengths(scene.box),
                   .is_periodic = scene.box.has_value(),
                   .beads = std::ldexp(static_cast<double>(scene.radii.size()), mirror_count(scene.box)),
                   .largest_radius = *std::ranges::max_element(scene.radii),
                   .moment_order = highest_moment(scene),
                   .tolerance = scene.tolerance};
  if (scene.memory) ewald.max_spacing = scene.memory->spacing;
  if (scene.box) return ewald;
  const Eigen::AlignedBox3d bounds = bounding_box(positions);
  for (int a = 0; a < 3; ++a) ewald.lengths[a] = bounds.sizes()[a] + 2 * ewald.largest_radius;
  if (const auto& half_space = scene.half_space) {
    ewald.lengths_with_mirror_points = ewald.lengths;
    (*ewald.lengths_with_mirror_points)[half_space->axis] =
        2 * (half_space->height(bounds.max()) + ewald.largest_radius);
  }
  return ewald;
}

}  // namespace

struct MobilityProduct::Parts {
  MobilityScene scene;
  const Communicator& communicator;
  std::optional<EwaldPlan> plan{};
  std::unique_ptr<NearPairs> near_pairs{};  ///< null: all pairs are summed without a mesh
  std::unique_ptr<ParticleMesh> mesh{};
  std::unique_ptr<MomentProduct> moments{};  ///< null: forces are the only moments
  /// Self-mobility of each sphere, minus the part of it that the far part of the Ewald sum contains
  /// [time/mass].
  std::vector<double> self{};
  std::optional<WallImages> wall{};              ///< of forces without moments; nullopt: without half-space
  std::optional<UnresolvedMemory> unresolved{};  ///< of forces without moments; nullopt: without memory
  std::optional<NearField> near_field{};
  std::optional<NearMap> near_map{};  ///< map S of the forces at the positions mapped_places
  std::vector<Vec3> mapped_places{};

  const NearMap& near_map_at(std::span<const Vec3> positions);
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces, FlowPart part,
                      std::span<Vec3> velocities) const;
  void add_corrected_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                std::span<Vec3> velocities);
  MemoryField* modes() const { return moments ? moments->memory() : mesh ? mesh->memory() : nullptr; }
  UnresolvedMemory& unresolved_memory() { return moments ? *moments->unresolved() : *unresolved; }
  std::vector<double> moments_at_end_of_step(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                             ProductWork& work);
};

MobilityProduct::MobilityProduct(MobilityScene scene, std::span<const Vec3> positions,
                                 const Communicator& communicator) {
  check(scene);
  const Vec3 lengths = mirrored_lengths(scene.box);
  std::vector<double> radii = scene.radii;
  for (int m = 0; m < mirror_count(scene.box); ++m) radii.insert(radii.end(), radii.begin(), radii.end());
  parts_.reset(new Parts{.scene = scene, .communicator = communicator});
  if (scene.model == MobilityModel::rpy_near)
    parts_->near_field.emplace(scene.radii, scene.lines, scene.box, scene.half_space);
  if (scene.box || scene.radii.size() >= min_spheres_on_mesh)
    parts_->plan = plan_ewald(ewald_scene(scene, positions));
  // Roundoff may differ between processors, so all ranks use the plan of rank 0.
  if (parts_->plan) MPI_Bcast(&*parts_->plan, sizeof(EwaldPlan), MPI_BYTE, 0, communicator.get());
  if (highest_moment(scene) > 0) {
    parts_->moments = std::make_unique<MomentProduct>(scene, parts_->plan, communicator);
    return;
  }
  for (const double radius : scene.radii) parts_->self.push_back(self_mobility(radius, scene.viscosity));
  const bool is_sphere = has_finite_radii(scene.model);
  if (scene.half_space)
    parts_->wall.emplace(
        WallImages::Law{.order = 0,
                        .viscosity = scene.viscosity,
                        .half_space = *scene.half_space,
                        .radii = is_sphere ? scene.radii : std::vector<double>(scene.radii.size(), 0.0),
                        .plan = parts_->plan});
  if (!parts_->plan) return;
  const EwaldPlan& plan = *parts_->plan;
  parts_->near_pairs = std::make_unique<NearPairs>(NearPairs::Law{.model = scene.model,
                                                                  .viscosity = scene.viscosity,
                                                                  .radii = radii,
                                                                  .lengths = lengths,
                                                                  .xi = plan.xi,
                                                                  .cutoff = plan.cutoff});
  ParticleMesh::Beads beads{{}, scene.viscosity, 0, inertial_memory(scene.memory)};
  if (is_sphere)
    for (const double radius : radii) beads.squared_radii.push_back(radius * radius);
  parts_->mesh = std::make_unique<ParticleMesh>(plan, lengths, beads, communicator);
  for (std::size_t b = 0; b < scene.radii.size(); ++b)
    parts_->self[b] -= far_self_mobility(plan.xi, is_sphere ? radii[b] * radii[b] : 0, scene.viscosity);
  if (beads.memory)
    parts_->unresolved.emplace(scene.radii, 0, scene.viscosity, *beads.memory,
                               parts_->mesh->memory()->cutoff());
}

MobilityProduct::~MobilityProduct() = default;

const std::optional<EwaldPlan>& MobilityProduct::plan() const {
  return parts_->plan;
}

/// Returns the map S of the forces (near_map.hpp) at the positions. All products of a time step have the same
/// positions and use the same map.
const NearMap& MobilityProduct::Parts::near_map_at(std::span<const Vec3> positions) {
  if (!near_map || !std::ranges::equal(positions, mapped_places)) {
    near_map = near_field->at(positions);
    mapped_places.assign(positions.begin(), positions.end());
  }
  return *near_map;
}

/// Adds the velocities of all spheres due to the forces, evaluated with pairs and mesh. `velocities` must be
/// zero on entry.
void MobilityProduct::Parts::add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                            FlowPart part, std::span<Vec3> velocities) const {
  std::vector<Vec3> places(positions.begin(), positions.end()), sources(forces.begin(), forces.end());
  for (auto* vectors : {&places, &sources}) add_mirror_images(scene.box, *vectors);
  if (mesh) {
    near_pairs->add_velocities(places, sources, velocities, communicator);
    if (!(wall && wall->uses_mesh())) mesh->add_velocities(places, sources, part, velocities);
  } else {
    add_all_pairs(scene.model, scene.viscosity, scene.radii, places, sources, velocities, communicator);
  }
  if (wall) wall->add_flows(places, flat(sources), flat(velocities), mesh.get(), communicator);
  sum_over_ranks({velocities[0].data(), 3 * velocities.size()}, communicator);
  for (std::size_t b = 0; b < velocities.size(); ++b) velocities[b] += self[b] * forces[b];
}

ProductWork MobilityProduct::apply(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                   std::span<Vec3> velocities, FlowPart part) const {
  ProductWork work{.products = 1};
  std::ranges::fill(velocities, Vec3::Zero());
  if (parts_->moments) {
    work = parts_->moments->solve(positions, forces, velocities, part);
  } else if (!parts_->near_field) {
    parts_->add_velocities(positions, forces, part, velocities);
    if (parts_->unresolved) parts_->unresolved->add_projections(flat(forces), part, flat(velocities));
  } else {
    parts_->add_corrected_velocities(positions, forces, velocities);
  }
  const BackgroundFlow& flow = parts_->scene.flow;
  if (part == FlowPart::all && !parts_->moments && !flow.is_zero())
    for (std::size_t b = 0; b < velocities.size(); ++b) velocities[b] += flow.at(positions[b]);
  return work;
}

/// Adds the velocities by the model rpy+near.
void MobilityProduct::Parts::add_corrected_velocities(std::span<const Vec3> positions,
                                                      std::span<const Vec3> forces,
                                                      std::span<Vec3> velocities) {
  const NearMap& map = near_map_at(positions);
  std::vector<Vec3> mapped(forces.begin(), forces.end());
  map.map_forces(mapped);
  add_velocities(positions, mapped, FlowPart::forces, velocities);
  map.map_velocities(velocities);
  // Roundoff may differ between processors, so all ranks use the velocities of rank 0.
  MPI_Bcast(velocities.data(), static_cast<int>(3 * velocities.size()), MPI_DOUBLE, 0, communicator.get());
}

/// Solves for the moments at the end of a time step and transforms their sources. Returns the moments, and
/// adds the work to `work`.
std::vector<double> MobilityProduct::Parts::moments_at_end_of_step(std::span<const Vec3> positions,
                                                                   std::span<const Vec3> forces,
                                                                   ProductWork& work) {
  if (moments) {
    work.add(moments->solve_end_of_step(positions, forces));
    return {moments->history().begin(), moments->history().begin() + moments->history().size() / 2};
  }
  std::vector<Vec3> places(positions.begin(), positions.end()), sources(forces.begin(), forces.end());
  for (auto* vectors : {&places, &sources}) add_mirror_images(scene.box, *vectors);
  mesh->read_sources(places, flat(sources));
  return {flat(forces).begin(), flat(forces).end()};
}

ProductWork MobilityProduct::start(std::span<const Vec3> positions, std::span<const Vec3> forces) {
  ProductWork work;
  if (!parts_->modes()) return work;
  const std::vector<double> moments = parts_->moments_at_end_of_step(positions, forces, work);
  parts_->modes()->start();
  parts_->unresolved_memory().start(moments);
  return work;
}

ProductWork MobilityProduct::end_step(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                      const Vec3& mean_flow) {
  ProductWork work;
  if (!parts_->modes()) return work;
  const std::vector<double> moments = parts_->moments_at_end_of_step(positions, forces, work);
  parts_->modes()->end_step(mean_flow);
  parts_->unresolved_memory().end_step(moments);
  return work;
}

MemoryState MobilityProduct::memory_state() const {
  if (!parts_->modes()) return {};
  return {.modes = parts_->modes()->state(),
          .unresolved = parts_->unresolved_memory().state(),
          .moments = parts_->moments ? parts_->moments->history() : std::vector<double>()};
}

void MobilityProduct::restore(const MemoryState& state) {
  if (!parts_->modes()) return;
  parts_->modes()->restore(state.modes);
  parts_->unresolved_memory().restore(state.unresolved);
  if (parts_->moments) parts_->moments->restore(state.moments);
}

}  // namespace beadswim
