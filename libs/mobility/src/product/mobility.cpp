#include "beadswim/mobility/mobility.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "grand_mobility.hpp"

namespace beadswim {
namespace {

/// Smallest number of spheres for which a mesh is used in open space. For fewer spheres and forces alone, a
/// sum over all pairs takes no longer.
constexpr std::size_t min_spheres_on_mesh = 1000;

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

/// Returns the parameters of the Ewald sum; nullopt if all pairs are summed directly.
std::optional<EwaldPlan> plan_for(const MobilityScene& scene, std::span<const Vec3> positions,
                                  const Communicator& communicator) {
  check(scene);
  if (!scene.box && scene.radii.size() < min_spheres_on_mesh) return std::nullopt;
  EwaldPlan plan = plan_ewald(ewald_scene(scene, positions));
  // Roundoff may differ between processors, so all ranks use the plan of rank 0.
  MPI_Bcast(&plan, sizeof(EwaldPlan), MPI_BYTE, 0, communicator.get());
  return plan;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

void add_velocities(double factor, std::span<const double> flow, std::span<Vec3> velocities) {
  const std::size_t count = flow.size() / velocities.size();
  for (std::size_t b = 0; b < velocities.size(); ++b)
    for (int a = 0; a < 3; ++a) velocities[b][a] += factor * flow[count * b + a];
}

}  // namespace

/// The velocities v of free spheres follow from the forces F on them. The higher moments H of the force on
/// each sphere make its surface move as a rigid body (force_moments.hpp). M is the grand mobility:
///
///   v = M_FF F + M_FH H,   M_HF F + M_HH H = 0
///
/// The method of conjugate gradients finds H, with the self-mobility of each sphere as preconditioner.
struct Mobility::Parts {
  MobilityScene scene;
  const Communicator& communicator;
  std::optional<EwaldPlan> plan;
  GrandMobility matrix{scene, plan, communicator};
  std::optional<NearField> near_field{};
  std::optional<NearMap> near_map{};  ///< map S of the forces at the positions
  std::vector<Vec3> positions{};
  double background_power = 0;           ///< power of the background flow's strain on all spheres, each alone
  std::vector<double> moment_history{};  ///< moments at the end of the last step, and of the step before
  std::vector<double> moments_in_step{};  ///< moments that the last solution with memory has found

  std::size_t size() const { return matrix.moments_per_sphere() * scene.radii.size(); }
  bool has_moments() const { return highest_moment(scene) > 0; }
  /// Returns true if the product contains a background flow.
  bool has_background(FlowPart part) const { return part == FlowPart::all && !scene.flow.is_zero(); }
  std::vector<double> projected_background(std::span<const Vec3> places) const;
  double power(std::span<const Vec3> forces, std::span<const Vec3> velocities, FlowPart part) const;
  void set_forces(std::span<const Vec3> forces, std::vector<double>& moments) const;
  ProductWork solve(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                    std::vector<double>& moments);
  ProductWork iterate(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                      std::vector<double> flow, std::vector<double>& moments);
  std::vector<double> moments_at_end_of_step(std::span<const Vec3> forces, ProductWork& work);
};

Mobility::Mobility(MobilityScene scene, std::span<const Vec3> positions, const Communicator& communicator) {
  const std::optional<EwaldPlan> plan = plan_for(scene, positions, communicator);
  parts_.reset(new Parts{.scene = scene, .communicator = communicator, .plan = plan});
  if (scene.model == MobilityModel::rpy_near)
    parts_->near_field.emplace(scene.radii, scene.lines, scene.box, scene.half_space);
  // The strain, and so its power, does not depend on the positions.
  const std::vector<double> background =
      parts_->projected_background(std::vector<Vec3>(scene.radii.size(), Vec3::Zero()));
  parts_->background_power = dot(background, parts_->matrix.precondition(background));
  set_positions(positions);
}

Mobility::~Mobility() = default;

const std::optional<EwaldPlan>& Mobility::plan() const {
  return parts_->plan;
}

void Mobility::set_positions(std::span<const Vec3> positions) {
  parts_->positions.assign(positions.begin(), positions.end());
  parts_->matrix.set_positions(positions);
  if (parts_->near_field) parts_->near_map = parts_->near_field->at(positions);
}

/// Returns the projections of the background flow on the moments of spheres at `places`.
std::vector<double> Mobility::Parts::projected_background(std::span<const Vec3> places) const {
  const int order = highest_moment(scene), count = moment_count(order), derivatives = derivative_count(order);
  std::vector<double> projections(count * places.size()), flow(3 * derivatives, 0.0);
  for (std::size_t b = 0; b < places.size(); ++b) {
    const Vec3 velocity = scene.flow.at(places[b]);
    for (int c = 0; c < 3; ++c) {
      flow[c * derivatives] = velocity[c];
      for (int g = 0; g < 3 && order > 0; ++g)
        flow[c * derivatives + 1 + g] = scene.flow.velocity_gradient(c, g);
    }
    project_flow(order, scene.radii[b], flow.data(), &projections[count * b]);
  }
  return projections;
}

/// Returns the power of the forces, to which the residual is compared. With memory of the fluid or background
/// flow, which can oppose the forces, it is the mean of F^2 mu and v^2/mu with the self-mobility mu of each
/// sphere, which is at least as large. v is then relative to the background flow, whose dissipation by each
/// sphere alone is added.
double Mobility::Parts::power(std::span<const Vec3> forces, std::span<const Vec3> velocities,
                              FlowPart part) const {
  const bool has_flow = has_background(part);
  double sum = has_flow ? background_power : 0;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    if (matrix.has_memory() || has_flow) {
      const double mobility = self_mobility(1, scene.viscosity) / scene.radii[b];
      const Vec3 relative = has_flow ? Vec3(velocities[b] - scene.flow.at(positions[b])) : velocities[b];
      sum += (mobility * forces[b].squaredNorm() + relative.squaredNorm() / mobility) / 2;
    } else {
      sum += forces[b].dot(velocities[b]);
    }
  }
  return sum;
}

void Mobility::Parts::set_forces(std::span<const Vec3> forces, std::vector<double>& moments) const {
  for (std::size_t b = 0; b < forces.size(); ++b)
    for (int a = 0; a < 3; ++a) moments[matrix.moments_per_sphere() * b + a] = forces[b][a];
}

/// Finds the velocities, beginning with the higher moments in `moments`, and returns all moments there.
ProductWork Mobility::Parts::solve(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                                   std::vector<double>& moments) {
  std::vector<Vec3> mapped(forces.begin(), forces.end());
  if (near_map) near_map->map_forces(mapped);
  set_forces(mapped, moments);
  std::vector<double> flow(moments.size());
  matrix.apply(moments, flow, part);
  std::ranges::fill(velocities, Vec3::Zero());
  add_velocities(1, flow, velocities);
  if (near_map) near_map->map_velocities(velocities);
  if (has_background(part)) {
    const std::vector<double> background = projected_background(positions);
    for (std::size_t k = 0; k < flow.size(); ++k) flow[k] += background[k];
    add_velocities(1, background, velocities);
  }
  ProductWork work{.products = 1};
  if (has_moments()) work = iterate(forces, velocities, part, std::move(flow), moments);
  // Roundoff may differ between processors, so all ranks use the velocities of rank 0.
  if (has_moments() || near_map)
    MPI_Bcast(velocities.data(), static_cast<int>(3 * velocities.size()), MPI_DOUBLE, 0, communicator.get());
  return work;
}

namespace {

/// State of the method of conjugate gradients for M_HH H = -M_HF F. The elements of `direction` and `step`
/// that belong to forces are zero, so those of `residual` have no effect.
struct ConjugateGradients {
  std::vector<double> residual;   ///< -(M_HF F + M_HH H)
  std::vector<double> step;       ///< preconditioned residual
  std::vector<double> direction;  ///< direction of the next change of H
  double square = 0;              ///< residual . step
};

/// The iteration ends when ProductWork::residual is below this factor times the tolerance.
constexpr double residual_share = 0.3;
constexpr int max_iterations = 100;

}  // namespace

/// Finds the higher moments. `flow`: projections of the flow of the forces and of the moments at the
/// beginning.
ProductWork Mobility::Parts::iterate(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                                     std::vector<double> flow, std::vector<double>& moments) {
  // Roundoff may differ between processors, so all ranks use the numbers of rank 0.
  const auto from_root = [&](double value) {
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, communicator.get());
    return value;
  };
  ConjugateGradients cg;
  cg.residual = flow;
  for (double& missing : cg.residual) missing = -missing;
  cg.direction = cg.step = matrix.precondition(cg.residual);
  cg.square = from_root(dot(cg.residual, cg.step));
  ProductWork work{.products = 1};
  for (;; ++work.iterations) {
    work.residual = cg.square == 0 ? 0 : std::sqrt(cg.square / from_root(power(forces, velocities, part)));
    if (!(work.residual > residual_share * scene.tolerance)) break;  // NaN ends the loop too
    matrix.apply(cg.direction, flow, FlowPart::forces);
    const double curvature = from_root(dot(cg.direction, flow));
    work.is_converged = curvature > 0 && work.iterations < max_iterations;
    if (!work.is_converged) break;
    const double length = cg.square / curvature;
    add_velocities(length, flow, velocities);
    for (std::size_t k = 0; k < flow.size(); ++k) {
      cg.residual[k] -= length * flow[k];
      moments[k] += length * cg.direction[k];
    }
    cg.step = matrix.precondition(cg.residual);
    const double before = std::exchange(cg.square, from_root(dot(cg.residual, cg.step)));
    for (std::size_t k = 0; k < flow.size(); ++k)
      cg.direction[k] = cg.step[k] + cg.square / before * cg.direction[k];
  }
  return work;
}

ProductWork Mobility::apply(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part) {
  std::vector<double> moments(parts_->size(), 0.0);
  if (part == FlowPart::forces || !parts_->matrix.has_memory())
    return parts_->solve(forces, velocities, part, moments);
  const std::vector<double>& history = parts_->moment_history;
  for (std::size_t k = 0; 2 * k < history.size(); ++k)  // extrapolated from earlier steps
    moments[k] = 2 * history[k] - history[moments.size() + k];
  parts_->moments_in_step = std::move(moments);
  return parts_->solve(forces, velocities, part, parts_->moments_in_step);
}

void Mobility::project_flow_of(std::span<const double> moments, std::span<double> projections) {
  parts_->matrix.apply(moments, projections, FlowPart::forces);
}

/// Solves for the moments at the end of a time step. Returns them, and adds the work to `work`.
std::vector<double> Mobility::Parts::moments_at_end_of_step(std::span<const Vec3> forces, ProductWork& work) {
  std::vector<double> moments = moments_in_step;
  moments.resize(size(), 0.0);
  if (!has_moments()) {
    set_forces(forces, moments);
    return moments;
  }
  std::vector<Vec3> velocities(forces.size());
  work.add(solve(forces, velocities, FlowPart::all, moments));
  if (moment_history.empty()) moment_history = moments;
  moment_history.resize(moments.size());
  moment_history.insert(moment_history.begin(), moments.begin(), moments.end());
  return moments;
}

ProductWork Mobility::start(std::span<const Vec3> forces) {
  ProductWork work;
  if (parts_->matrix.has_memory()) parts_->matrix.start(parts_->moments_at_end_of_step(forces, work));
  return work;
}

ProductWork Mobility::end_step(std::span<const Vec3> forces, const Vec3& mean_flow) {
  ProductWork work;
  if (parts_->matrix.has_memory())
    parts_->matrix.end_step(parts_->moments_at_end_of_step(forces, work), mean_flow);
  return work;
}

MemoryState Mobility::memory_state() const {
  if (!parts_->matrix.has_memory()) return {};
  return {.modes = parts_->matrix.modes().state(),
          .unresolved = parts_->matrix.unresolved().state(),
          .moments = parts_->moment_history};
}

void Mobility::restore(const MemoryState& state) {
  if (!parts_->matrix.has_memory()) return;
  parts_->matrix.modes().restore(state.modes);
  parts_->matrix.unresolved().restore(state.unresolved);
  parts_->moment_history = state.moments;
}

}  // namespace beadswim
