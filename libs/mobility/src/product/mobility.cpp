#include "beadswim/mobility/mobility.hpp"

#include <fmt/core.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "grand_mobility.hpp"

namespace beadswim {
namespace {

/// Smallest number of spheres for which a mesh is used in open space. For fewer spheres and forces alone, a
/// sum over all pairs takes no longer.
constexpr std::size_t min_spheres_on_mesh = 1000;

/// Throws InputError if an array does not have the number of elements that the spheres need.
void check_size(const char* array, std::size_t size, std::size_t needed) {
  if (size != needed)
    throw InputError("mobility", "the list of {} has {} elements; the spheres need {}", array, size, needed);
}

void check(const MobilityScene& scene) {
  if (scene.radii.empty())
    throw InputError("mobility", "the list of radii is empty; give at least one sphere");
  for (const double radius : scene.radii)
    if (!(radius > 0 && std::isfinite(radius)))
      throw InputError("mobility",
                       "the radius {} of a sphere is invalid; a finite number greater than 0 is needed",
                       radius);
  if (!(scene.viscosity > 0 && std::isfinite(scene.viscosity)))
    throw InputError("mobility", "the viscosity {} is invalid; a finite number greater than 0 is needed",
                     scene.viscosity);
  if (scene.moment_order < 0 || scene.moment_order > max_moment_order)
    throw InputError("mobility", "the order {} of the force moments is invalid; give 0, 1 or 2",
                     scene.moment_order);
  if (scene.memory && !scene.domain.box)
    throw InputError("mobility", "a fluid with memory needs a box; give a box, or leave the memory out");
  if (scene.domain.box && (scene.domain.half_space || !scene.flow.is_zero()))
    throw InputError("mobility",
                     "a half-space or a background flow is incompatible with a box; leave the box out");
  for (const int first : scene.lines)
    if (first < 0 || first + 3 > std::ssize(scene.radii))
      throw InputError("mobility",
                       "three spheres on a line from index {} on go beyond the {} spheres; give the index of "
                       "the first of the three",
                       first, scene.radii.size());
  if (!scene.domain.box) return;
  for (const double length : scene.domain.box->lengths)
    if (!(length > 0 && std::isfinite(length)))
      throw InputError("mobility", "the box edge {} is invalid; a finite number greater than 0 is needed",
                       length);
}

EwaldScene ewald_scene(const MobilityScene& scene, std::span<const Vec3> positions) {
  EwaldScene ewald{
      .lengths = mirrored_lengths(scene.domain.box),
      .is_periodic = scene.domain.box.has_value(),
      .beads = std::ldexp(static_cast<double>(scene.radii.size()), mirror_count(scene.domain.box)),
      .largest_radius = *std::ranges::max_element(scene.radii),
      .moment_order = highest_moment(scene),
      .tolerance = scene.tolerance};
  if (scene.memory) ewald.memory_cutoff = memory_cutoff(*scene.memory, ewald.lengths);
  if (scene.domain.box) return ewald;
  const Eigen::AlignedBox3d bounds = bounding_box(positions);
  for (int a = 0; a < 3; ++a) ewald.lengths[a] = bounds.sizes()[a] + 2 * ewald.largest_radius;
  if (const auto& half_space = scene.domain.half_space) {
    ewald.lengths_with_mirror_points = ewald.lengths;
    (*ewald.lengths_with_mirror_points)[half_space->axis] =
        2 * (half_space->height(bounds.max()) + ewald.largest_radius);
  }
  return ewald;
}

/// Returns the parameters of the Ewald sum; nullopt if all pairs are summed directly.
std::optional<EwaldPlan> plan_for(const MobilityScene& scene, std::span<const Vec3> positions,
                                  const Communicator& communicator, bool is_for_root = false) {
  check(scene);
  check_size("positions", positions.size(), scene.radii.size());
  if (!scene.domain.box && scene.radii.size() < min_spheres_on_mesh) return std::nullopt;
  EwaldScene ewald = ewald_scene(scene, positions);
  ewald.is_for_root = is_for_root;
  EwaldPlan plan = plan_ewald(ewald);
  // Roundoff may differ between processors, so all ranks use the plan of rank 0.
  if (communicator.size() > 1) MPI_Bcast(&plan, sizeof(EwaldPlan), MPI_BYTE, 0, communicator.get());
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

/// Returns the index of the sphere that contains each point; -1 if there is none.
std::vector<int> spheres_around(const MobilityScene& scene, std::span<const Vec3> positions,
                                std::span<const Vec3> points) {
  const CellList cells(positions, *std::ranges::max_element(scene.radii), mirrored_lengths(scene.domain.box));
  std::vector<int> spheres(points.size(), -1);
  for (std::size_t p = 0; p < points.size(); ++p) {
    cells.visit_neighbours(points[p], [&](std::size_t sphere) {
      if (nearest_separation(positions[sphere], points[p], scene.domain.box).norm() < scene.radii[sphere])
        spheres[p] = static_cast<int>(sphere);
      return spheres[p] < 0;
    });
  }
  return spheres;
}

}  // namespace

std::optional<EwaldPlan> root_plan(const MobilityScene& scene, std::span<const Vec3> positions,
                                   const Communicator& communicator) {
  const std::optional<EwaldPlan> plan = plan_for(scene, positions, communicator, true);
  return plan && plan->cutoff > 0 ? plan : std::nullopt;
}

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
  std::optional<NearMap> near_map{};  ///< at the positions
  std::optional<EwaldPlan> plan_with_stresslets{};
  std::optional<GrandMobility> matrix_with_stresslets{};  ///< nullopt until forces induce stresslets
  bool has_stresslets = false;  ///< true if forces at the positions induce stresslets
  std::vector<Vec3> positions{};
  double background_power = 0;  ///< power of the background flow's strain on all spheres, each alone
  std::vector<double> applied_moments{};  ///< Mobility::moments()

  std::size_t size() const { return matrix.moments_per_sphere() * scene.radii.size(); }
  bool has_moments() const { return highest_moment(scene) > 0; }
  GrandMobility& present_matrix() { return has_stresslets ? *matrix_with_stresslets : matrix; }
  void add_corrections();
  /// Returns true if the product contains a background flow.
  bool has_background(FlowPart part) const { return part == FlowPart::all && !scene.flow.is_zero(); }
  std::vector<double> projected_background(std::span<const Vec3> places) const;
  double power(std::span<const Vec3> forces, std::span<const Vec3> velocities, FlowPart part) const;
  void set_forces(std::span<const Vec3> forces, std::vector<double>& moments) const;
  ProductWork solve(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                    std::vector<double>& moments, double tolerance_factor = 1);
  ProductWork iterate(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                      std::vector<double> flow, std::vector<double>& moments, double tolerance_factor = 1);
};

Mobility::Mobility(MobilityScene scene, std::span<const Vec3> positions, const Communicator& communicator) {
  const std::optional<EwaldPlan> plan = plan_for(scene, positions, communicator);
  parts_.reset(new Parts{.scene = scene, .communicator = communicator, .plan = plan});
  if (scene.model == MobilityModel::rpy_near)
    parts_->near_field.emplace(scene.radii, scene.lines, scene.viscosity, scene.domain);
  // The strain, and so its power, does not depend on the positions.
  const std::vector<double> background =
      parts_->projected_background(std::vector<Vec3>(scene.radii.size(), Vec3::Zero()));
  parts_->background_power = dot(background, parts_->matrix.precondition(background));
  set_positions(positions);
}

Mobility::~Mobility() = default;

const std::optional<EwaldPlan>& Mobility::plan() const {
  return parts_->has_stresslets ? parts_->plan_with_stresslets : parts_->plan;
}

void Mobility::set_positions(std::span<const Vec3> positions) {
  check_size("positions", positions.size(), parts_->scene.radii.size());
  parts_->positions.assign(positions.begin(), positions.end());
  if (parts_->near_field) parts_->add_corrections();
  parts_->present_matrix().set_positions(positions);
}

/// Sets the near map, and makes the sum over stresslets if forces induce some for the first time.
void Mobility::Parts::add_corrections() {
  near_map = near_field->at(positions);
  has_stresslets = near_map->moment_order() > 0;
  if (!has_stresslets || matrix_with_stresslets) return;
  MobilityScene with_stresslets = scene;
  with_stresslets.model = MobilityModel::multipole;
  with_stresslets.moment_order = 1;
  plan_with_stresslets = plan_for(with_stresslets, positions, communicator);
  matrix_with_stresslets.emplace(with_stresslets, plan_with_stresslets, communicator);
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
/// sphere alone is added. The same without forces, whose flow is given, and for moments of a guess that oppose
/// the forces.
double Mobility::Parts::power(std::span<const Vec3> forces, std::span<const Vec3> velocities,
                              FlowPart part) const {
  const bool has_flow = has_background(part);
  double sum = 0;
  if (!matrix.has_memory() && !has_flow)
    for (std::size_t b = 0; b < forces.size(); ++b) sum += forces[b].dot(velocities[b]);
  if (sum > 0) return sum;
  sum = has_flow ? background_power : 0;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    const double mobility = self_mobility(1, scene.viscosity) / scene.radii[b];
    const Vec3 relative = has_flow ? Vec3(velocities[b] - scene.flow.at(positions[b])) : velocities[b];
    sum += (mobility * forces[b].squaredNorm() + relative.squaredNorm() / mobility) / 2;
  }
  return sum;
}

void Mobility::Parts::set_forces(std::span<const Vec3> forces, std::vector<double>& moments) const {
  for (std::size_t b = 0; b < forces.size(); ++b)
    for (int a = 0; a < 3; ++a) moments[matrix.moments_per_sphere() * b + a] = forces[b][a];
}

/// Finds the velocities, beginning with the higher moments in `moments`, and returns all moments there.
ProductWork Mobility::Parts::solve(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                                   std::vector<double>& moments, double tolerance_factor) {
  if (near_map)
    moments = near_map->moments_of(forces);
  else
    set_forces(forces, moments);
  std::vector<double> flow(moments.size());
  present_matrix().apply(moments, flow, part);
  std::ranges::fill(velocities, Vec3::Zero());
  if (near_map)
    near_map->set_velocities(moments, flow, velocities);
  else
    add_velocities(1, flow, velocities);
  if (has_background(part)) {
    const std::vector<double> background = projected_background(positions);
    for (std::size_t k = 0; k < background.size(); ++k) flow[k] += background[k];
    add_velocities(1, background, velocities);
  }
  ProductWork work{.products = 1};
  if (has_moments()) work = iterate(forces, velocities, part, std::move(flow), moments, tolerance_factor);
  // Roundoff may differ between processors, so all ranks use the velocities of rank 0.
  if (has_moments() || near_map)
    broadcast_doubles(velocities.data()->data(), 3 * velocities.size(), communicator);
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
                                     std::vector<double> flow, std::vector<double>& moments,
                                     double tolerance_factor) {
  // Roundoff may differ between processors, so all ranks use the numbers of rank 0.
  const auto from_root = [&](double value) {
    broadcast_doubles(&value, 1, communicator);
    return value;
  };
  ConjugateGradients cg;
  cg.residual = flow;
  for (double& missing : cg.residual) missing = -missing;
  cg.direction = cg.step = matrix.precondition(cg.residual);
  cg.square = from_root(dot(cg.residual, cg.step));
  ProductWork work{.products = 1};
  for (;; ++work.iterations) {
    work.residual =
        cg.square == 0 ? 0
                       : std::sqrt(cg.square / from_root(power(forces, velocities, part))) / tolerance_factor;
    if (!(work.residual > residual_share * scene.tolerance)) {
      work.is_converged = !std::isnan(work.residual);
      break;
    }
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

ProductWork Mobility::apply(std::span<const Vec3> forces, std::span<Vec3> velocities, FlowPart part,
                            const MomentGuess& guess) {
  check_size("forces", forces.size(), parts_->scene.radii.size());
  check_size("velocities", velocities.size(), parts_->scene.radii.size());
  std::vector<double> moments(parts_->size(), 0.0);
  if (guess.moments.size() == moments.size()) std::ranges::copy(guess.moments, moments.begin());
  const ProductWork work = parts_->solve(forces, velocities, part, moments, guess.tolerance_factor);
  parts_->applied_moments = std::move(moments);
  return work;
}

ProductWork Mobility::move_in_flow(std::span<const double> projections, std::span<Vec3> velocities) {
  std::vector<double> moments(parts_->size(), 0.0), flow(projections.begin(), projections.end());
  std::ranges::fill(velocities, Vec3::Zero());
  add_velocities(1, flow, velocities);
  const std::vector<Vec3> no_forces(velocities.size(), Vec3::Zero());
  const ProductWork work = parts_->iterate(no_forces, velocities, FlowPart::forces, std::move(flow), moments);
  broadcast_doubles(velocities.data()->data(), 3 * velocities.size(), parts_->communicator);
  return work;
}

std::span<const double> Mobility::moments() const {
  return parts_->applied_moments;
}

FlowAtPoints Mobility::flow_at(std::span<const Vec3> points, const MovingSpheres& spheres) {
  const MobilityScene& scene = parts_->scene;
  const std::size_t count = scene.radii.size();
  const bool has_stresslets = parts_->near_field && spheres.moments.size() > 3 * count;
  GrandMobility& matrix = has_stresslets ? *parts_->matrix_with_stresslets : parts_->matrix;
  check_size("positions", spheres.positions.size(), count);
  check_size("velocities", spheres.velocities.size(), count);
  check_size("moments", spheres.moments.size(), matrix.moments_per_sphere() * count);
  FlowAtPoints flow{.velocities = std::vector<Vec3>(points.size(), Vec3::Zero()),
                    .spheres = spheres_around(scene, spheres.positions, points)};
  if (points.empty()) return flow;
  std::vector<Vec3> all(spheres.positions.begin(), spheres.positions.end());
  const Eigen::AlignedBox3d bounds = bounding_box(points);
  all.insert(all.end(), {bounds.min(), bounds.max()});
  EwaldScene ewald = ewald_scene(scene, all);
  ewald.moment_order = has_stresslets ? 1 : highest_moment(scene);
  ewald.points = static_cast<double>(points.size());
  std::optional<EwaldPlan> plan = plan_flow(ewald);
  // Roundoff may differ between processors, so all ranks use the plan of rank 0.
  if (parts_->communicator.size() > 1)
    MPI_Bcast(&plan, sizeof(plan), MPI_BYTE, 0, parts_->communicator.get());
  matrix.add_flow_at(points, spheres.positions, spheres.moments, plan, flow.spheres, flow.velocities);
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (flow.spheres[p] >= 0)
      flow.velocities[p] = spheres.velocities[flow.spheres[p]];
    else if (!scene.flow.is_zero())
      flow.velocities[p] += scene.flow.at(points[p]);
  }
  return flow;
}

void Mobility::project_flow_of(std::span<const double> moments, std::span<double> projections) {
  check_size("moments", moments.size(), parts_->size());
  check_size("projections", projections.size(), parts_->size());
  parts_->matrix.apply(moments, projections, FlowPart::forces);
}

ProductWork Mobility::start(std::span<const Vec3> forces) {
  if (!parts_->matrix.has_memory()) return {};
  std::vector<Vec3> velocities(forces.size());
  const ProductWork work = apply(forces, velocities, FlowPart::all);
  parts_->matrix.start(parts_->applied_moments);
  return work;
}

void Mobility::end_step(std::span<const double> moments, const Vec3& mean_flow) {
  check_size("moments", moments.size(), parts_->size());
  if (parts_->matrix.has_memory()) parts_->matrix.end_step(moments, mean_flow);
}

namespace {

/// Returns how many of the numbers of the Fourier modes each rank has.
std::vector<int> counts_by_rank(const std::vector<double>& own_modes, const Communicator& communicator) {
  std::vector<int> counts(communicator.size());
  const int count = static_cast<int>(own_modes.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator.get());
  return counts;
}

}  // namespace

// The memory is a list of the modes of all ranks, and of the flow that the mesh does not resolve, which all
// ranks have.
std::vector<double> Mobility::gather_memory() const {
  const Communicator& communicator = parts_->communicator;
  const std::vector<double> modes = parts_->matrix.modes().state();
  const std::vector<int> counts = counts_by_rank(modes, communicator);
  std::vector<int> starts(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  std::vector<double> memory(communicator.is_root() ? starts.back() + counts.back() : 0);
  MPI_Gatherv(modes.data(), static_cast<int>(modes.size()), MPI_DOUBLE, memory.data(), counts.data(),
              starts.data(), MPI_DOUBLE, 0, communicator.get());
  if (!communicator.is_root()) return {};
  const std::vector<double>& unresolved = parts_->matrix.unresolved().state();
  memory.insert(memory.end(), unresolved.begin(), unresolved.end());
  return memory;
}

void Mobility::restore_memory(std::span<const double> memory) {
  const std::vector<int> counts = counts_by_rank(parts_->matrix.modes().state(), parts_->communicator);
  const auto own = counts.begin() + parts_->communicator.rank();
  const std::size_t start = std::reduce(counts.begin(), own), end = std::reduce(counts.begin(), counts.end());
  const std::size_t spheres = parts_->matrix.unresolved().state().size();
  if (memory.size() != end + spheres)
    throw SolverError(
        fmt::format("the memory of the fluid in the checkpoint differs in size from that of the scene; begin "
                    "without {}",
                    Setting::restart));
  parts_->matrix.modes().restore(memory.subspan(start, *own));
  const auto unresolved = memory.subspan(end);
  parts_->matrix.unresolved().restore({unresolved.begin(), unresolved.end()});
}

}  // namespace beadswim
