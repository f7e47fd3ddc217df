#include "moment_product.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "memory_field.hpp"
#include "sum_over_ranks.hpp"

namespace beadswim {
namespace {

/// The iteration ends when ProductWork::residual is below this factor times the tolerance.
constexpr double residual_share = 0.3;
constexpr int max_iterations = 100;

/// Returns the radii of all spheres and their mirror images.
std::vector<double> with_images(std::vector<double> radii, const std::optional<Box>& box) {
  for (int m = 0; m < mirror_count(box); ++m) radii.insert(radii.end(), radii.begin(), radii.end());
  return radii;
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

/// Returns the factor of the self-mobility that depends on the radius: 1/a for F and Q, 1/a^3 for S.
double self_mobility_scale(int degree, double radius) {
  return degree == 1 ? 1 / (radius * radius * radius) : 1 / radius;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace

MomentProduct::MomentProduct(const MobilityScene& scene, const std::optional<EwaldPlan>& plan,
                             const Communicator& communicator)
    : scene_(scene),
      communicator_(communicator),
      pairs_({.order = scene.moment_order,
              .viscosity = scene.viscosity,
              .radii = with_images(scene.radii, scene.box),
              .lengths = mirrored_lengths(scene.box),
              .xi = plan ? plan->xi : 0,
              .cutoff = plan ? plan->cutoff : 0}),
      self_(moment_self_mobility(scene.moment_order, 1, scene.viscosity)),
      inverse_self_(self_.inverse()) {
  if (scene.half_space)
    wall_.emplace(WallImages::Law{.order = scene.moment_order,
                                  .viscosity = scene.viscosity,
                                  .half_space = *scene.half_space,
                                  .radii = scene.radii,
                                  .plan = plan});
  // The strain, and so its power, does not depend on the positions.
  const std::vector<double> background =
      projected_background(std::vector<Vec3>(scene.radii.size(), Vec3::Zero()));
  background_power_ = dot(background, precondition(background));
  if (!plan) return;
  ParticleMesh::Beads beads{{}, scene.viscosity, scene.moment_order, inertial_memory(scene.memory)};
  for (const double radius : with_images(scene.radii, scene.box))
    beads.squared_radii.push_back(radius * radius);
  mesh_ = std::make_unique<ParticleMesh>(*plan, mirrored_lengths(scene.box), beads, communicator);
  if (beads.memory)
    unresolved_.emplace(scene.radii, scene.moment_order, scene.viscosity, *beads.memory,
                        mesh_->memory()->cutoff());
}

MomentProduct::Sources MomentProduct::sources_of(std::span<const Vec3> positions,
                                                 std::span<const double> moments) const {
  const int order = scene_.moment_order, count = moment_count(order), numbers = 3 * derivative_count(order);
  Sources all{.places = {positions.begin(), positions.end()},
              .sources = std::vector<double>(numbers * positions.size())};
  add_mirror_images(scene_.box, all.places);
  for (std::size_t b = 0; b < positions.size(); ++b)
    source_of_moments(order, scene_.radii[b], &moments[count * b], &all.sources[numbers * b]);
  add_mirror_sources(scene_.box, order, all.sources);
  return all;
}

void MomentProduct::apply(std::span<const Vec3> positions, std::span<const double> moments,
                          std::span<double> projections, FlowPart part) const {
  const int order = scene_.moment_order, count = moment_count(order), numbers = 3 * derivative_count(order);
  const std::size_t spheres = positions.size();
  const auto [places, sources] = sources_of(positions, moments);
  std::vector<double> flows(numbers * spheres, 0.0);
  pairs_.add_flows(places, sources, flows, communicator_);
  if (wall_) wall_->add_flows(places, sources, flows, mesh_.get(), communicator_);
  if (mesh_ && !(wall_ && wall_->uses_mesh())) mesh_->add_flows(places, sources, part, flows);
  sum_over_ranks(flows, communicator_);
  if (mesh_) pairs_.subtract_far_flow(sources, flows);
  for (std::size_t b = 0; b < spheres; ++b) {
    const double radius = scene_.radii[b];
    project_flow(order, radius, &flows[numbers * b], &projections[count * b]);
    for (int m = 0; m < count; ++m)
      for (int k = 0; k < count; ++k)
        projections[count * b + m] +=
            self_mobility_scale(degree_of_moment(m), radius) * self_(m, k) * moments[count * b + k];
  }
  if (unresolved_) unresolved_->add_projections(moments, part, projections);
  if (has_background(part)) {
    const std::vector<double> background = projected_background(positions);
    for (std::size_t k = 0; k < background.size(); ++k) projections[k] += background[k];
  }
}

std::vector<double> MomentProduct::projected_background(std::span<const Vec3> positions) const {
  const int order = scene_.moment_order, count = moment_count(order), derivatives = derivative_count(order);
  std::vector<double> projections(count * positions.size()), flow(3 * derivatives, 0.0);
  for (std::size_t b = 0; b < positions.size(); ++b) {
    const Vec3 velocity = scene_.flow.at(positions[b]);
    for (int c = 0; c < 3; ++c) {
      flow[c * derivatives] = velocity[c];
      for (int g = 0; g < 3; ++g) flow[c * derivatives + 1 + g] = scene_.flow.velocity_gradient(c, g);
    }
    project_flow(order, scene_.radii[b], flow.data(), &projections[count * b]);
  }
  return projections;
}

std::vector<double> MomentProduct::precondition(std::span<const double> projections) const {
  const int count = moment_count(scene_.moment_order);
  std::vector<double> moments(projections.size(), 0.0);
  for (std::size_t b = 0; count * b < projections.size(); ++b)
    for (int m = 3; m < count; ++m)
      for (int k = 3; k < count; ++k)
        moments[count * b + m] += inverse_self_(m, k) /
                                  self_mobility_scale(degree_of_moment(m), scene_.radii[b]) *
                                  projections[count * b + k];
  return moments;
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

void add_velocities(double factor, std::span<const double> flow, std::span<Vec3> velocities) {
  const std::size_t count = flow.size() / velocities.size();
  for (std::size_t b = 0; b < velocities.size(); ++b)
    for (int a = 0; a < 3; ++a) velocities[b][a] += factor * flow[count * b + a];
}

}  // namespace

/// Returns the power of the forces, to which the residual is compared. With memory of the fluid or background
/// flow, which can oppose the forces, it is the mean of F^2 mu and v^2/mu with the self-mobility mu of each
/// sphere, which is at least as large. v is then relative to the background flow, whose dissipation by each
/// sphere alone is added.
double MomentProduct::power(std::span<const Vec3> positions, std::span<const Vec3> forces,
                            std::span<const Vec3> velocities, FlowPart part) const {
  const bool has_flow = has_background(part);
  double sum = has_flow ? background_power_ : 0;
  for (std::size_t b = 0; b < forces.size(); ++b) {
    if (unresolved_ || has_flow) {
      const double mobility = self_(0, 0) / scene_.radii[b];
      const Vec3 relative = has_flow ? Vec3(velocities[b] - scene_.flow.at(positions[b])) : velocities[b];
      sum += (mobility * forces[b].squaredNorm() + relative.squaredNorm() / mobility) / 2;
    } else {
      sum += forces[b].dot(velocities[b]);
    }
  }
  return sum;
}

ProductWork MomentProduct::solve(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                 std::span<Vec3> velocities, FlowPart part) {
  std::vector<double> moments(moment_count(scene_.moment_order) * positions.size(), 0.0);
  if (part == FlowPart::forces || !unresolved_)
    return solve_from(positions, forces, velocities, part, moments);
  moments_in_step_ = extrapolated_moments(positions.size());
  return solve_from(positions, forces, velocities, part, moments_in_step_);
}

std::vector<double> MomentProduct::extrapolated_moments(std::size_t spheres) const {
  std::vector<double> moments(moment_count(scene_.moment_order) * spheres, 0.0);
  for (std::size_t k = 0; 2 * k < moment_history_.size(); ++k)
    moments[k] = 2 * moment_history_[k] - moment_history_[moments.size() + k];
  return moments;
}

ProductWork MomentProduct::solve_end_of_step(std::span<const Vec3> positions, std::span<const Vec3> forces) {
  std::vector<double> moments = moments_in_step_;
  moments.resize(moment_count(scene_.moment_order) * positions.size(), 0.0);
  std::vector<Vec3> velocities(positions.size());
  const ProductWork work = solve_from(positions, forces, velocities, FlowPart::all, moments);
  const auto [places, sources] = sources_of(positions, moments);
  mesh_->read_sources(places, sources);
  if (moment_history_.empty()) moment_history_ = moments;
  moment_history_.resize(moments.size());
  moment_history_.insert(moment_history_.begin(), moments.begin(), moments.end());
  return work;
}

ProductWork MomentProduct::solve_from(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                      std::span<Vec3> velocities, FlowPart part,
                                      std::vector<double>& moments) const {
  const int count = moment_count(scene_.moment_order);
  // Roundoff may differ between processors, so all ranks use the numbers of rank 0.
  const auto from_root = [&](double value) {
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, communicator_.get());
    return value;
  };
  ConjugateGradients cg;
  for (std::size_t b = 0; b < positions.size(); ++b)
    for (int a = 0; a < 3; ++a) moments[count * b + a] = forces[b][a];
  std::vector<double> flow(moments.size());
  apply(positions, moments, flow, part);
  std::ranges::fill(velocities, Vec3::Zero());
  add_velocities(1, flow, velocities);
  cg.residual = flow;
  for (double& missing : cg.residual) missing = -missing;
  cg.direction = cg.step = precondition(cg.residual);
  cg.square = from_root(dot(cg.residual, cg.step));
  ProductWork work{.products = 1};
  for (;; ++work.iterations) {
    work.residual =
        cg.square == 0 ? 0 : std::sqrt(cg.square / from_root(power(positions, forces, velocities, part)));
    if (!(work.residual > residual_share * scene_.tolerance)) break;  // NaN ends the loop too
    apply(positions, cg.direction, flow);
    const double curvature = from_root(dot(cg.direction, flow));
    work.is_converged = curvature > 0 && work.iterations < max_iterations;
    if (!work.is_converged) break;
    const double length = cg.square / curvature;
    add_velocities(length, flow, velocities);
    for (std::size_t k = 0; k < flow.size(); ++k) {
      cg.residual[k] -= length * flow[k];
      moments[k] += length * cg.direction[k];
    }
    cg.step = precondition(cg.residual);
    const double before = std::exchange(cg.square, from_root(dot(cg.residual, cg.step)));
    for (std::size_t k = 0; k < flow.size(); ++k)
      cg.direction[k] = cg.step[k] + cg.square / before * cg.direction[k];
  }
  MPI_Bcast(velocities[0].data(), static_cast<int>(3 * velocities.size()), MPI_DOUBLE, 0,
            communicator_.get());
  return work;
}

}  // namespace beadswim
