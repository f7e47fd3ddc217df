#include "moment_product.hpp"

#include <Eigen/LU>
#include <cmath>

#include "sum_over_ranks.hpp"

namespace beadswim {
namespace {

/// Largest residual of S, in the norm of the dissipation, relative to the power of the forces and to the
/// tolerance of the product.
constexpr double residual_share = 0.3;
constexpr int max_iterations = 100;

int mirrors(const std::optional<Box>& box) {
  int count = 0;
  for (int a = 0; a < 3 && box; ++a) count += box->has_mirrors(a) ? 1 : 0;
  return count;
}

std::vector<double> with_images(std::vector<double> radii, const std::optional<Box>& box) {
  for (int m = 0; m < mirrors(box); ++m) radii.insert(radii.end(), radii.begin(), radii.end());
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
      const int changes = derivatives[d][a] + (c == a ? 1 : 0);
      sources.push_back(changes % 2 == 0 ? sources[k] : -sources[k]);
    }
  }
}

/// Returns the degree of moment m of a sphere.
int degree_of(int m) {
  return m < 3 ? 0 : (m < 8 ? 1 : 2);
}

/// Returns the exponent of the radius in the self-mobility of a degree: 1/a for F and Q, 1/a^3 for S.
double scale(int degree, double radius) {
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
  inverse_self_.topLeftCorner<3, 3>().setZero();
  if (!plan) return;
  ParticleMesh::Beads beads{{}, scene.viscosity, scene.moment_order};
  for (const double radius : with_images(scene.radii, scene.box))
    beads.squared_radii.push_back(radius * radius);
  mesh_ = std::make_unique<ParticleMesh>(*plan, mirrored_lengths(scene.box), beads, communicator);
}

void MomentProduct::apply(std::span<const Vec3> positions, std::span<const double> moments,
                          std::span<double> projections) const {
  const int order = scene_.moment_order, count = moment_count(order), numbers = 3 * derivative_count(order);
  const std::size_t spheres = positions.size();
  std::vector<Vec3> places(positions.begin(), positions.end());
  add_mirror_images(scene_.box, places);
  std::vector<double> sources(numbers * spheres), flows(numbers * spheres, 0.0);
  for (std::size_t b = 0; b < spheres; ++b)
    derivatives_of_moments(order, scene_.radii[b], &moments[count * b], &sources[numbers * b]);
  add_mirror_sources(scene_.box, order, sources);
  pairs_.add_flows(places, sources, flows, communicator_);
  if (mesh_) mesh_->add_flows(places, sources, flows);
  sum_over_ranks(flows, communicator_);
  if (mesh_) pairs_.subtract_far_flow(sources, flows);
  for (std::size_t b = 0; b < spheres; ++b) {
    const double radius = scene_.radii[b];
    moments_of_derivatives(order, radius, &flows[numbers * b], &projections[count * b]);
    for (int m = 0; m < count; ++m)
      for (int k = 0; k < count; ++k)
        projections[count * b + m] += scale(degree_of(m), radius) * self_(m, k) * moments[count * b + k];
  }
}

std::vector<double> MomentProduct::precondition(std::span<const double> projections) const {
  const int count = moment_count(scene_.moment_order);
  std::vector<double> moments(projections.size(), 0.0);
  for (std::size_t b = 0; count * b < projections.size(); ++b)
    for (int m = 3; m < count; ++m)
      for (int k = 3; k < count; ++k)
        moments[count * b + m] +=
            inverse_self_(m, k) / scale(degree_of(m), scene_.radii[b]) * projections[count * b + k];
  return moments;
}

ProductWork MomentProduct::solve(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                 std::span<Vec3> velocities) const {
  const int count = moment_count(scene_.moment_order);
  const std::size_t spheres = positions.size();
  std::vector<double> moments(count * spheres, 0.0), flow(count * spheres);
  for (std::size_t b = 0; b < spheres; ++b)
    for (int a = 0; a < 3; ++a) moments[count * b + a] = forces[b][a];
  apply(positions, moments, flow);
  const auto add_velocities = [&](double factor) {
    for (std::size_t b = 0; b < spheres; ++b)
      for (int a = 0; a < 3; ++a) {
        velocities[b][a] += factor * flow[count * b + a];
        flow[count * b + a] = 0;
      }
  };
  std::ranges::fill(velocities, Vec3::Zero());
  add_velocities(1);
  const auto power = [&] {
    double sum = 0;
    for (std::size_t b = 0; b < spheres; ++b) sum += forces[b].dot(velocities[b]);
    return sum;
  };
  std::vector<double> residual(flow.size());
  for (std::size_t k = 0; k < flow.size(); ++k) residual[k] = -flow[k];
  std::vector<double> step = precondition(residual), direction = step;
  ProductWork work;
  // Roundoff may differ between processors, so all ranks use the numbers of rank 0.
  const auto of_root = [&](double value) {
    MPI_Bcast(&value, 1, MPI_DOUBLE, 0, communicator_.get());
    return value;
  };
  double square = of_root(dot(residual, step));
  for (;; ++work.iterations) {
    const double available = of_root(power());
    work.residual = square > 0 ? std::sqrt(square / available) : 0;
    if (!(work.residual > residual_share * scene_.tolerance) || work.iterations == max_iterations) break;
    apply(positions, direction, flow);
    const double length = square / of_root(dot(direction, flow));
    add_velocities(length);
    for (std::size_t k = 0; k < residual.size(); ++k) residual[k] -= length * flow[k];
    step = precondition(residual);
    const double next = of_root(dot(residual, step));
    for (std::size_t k = 0; k < direction.size(); ++k) direction[k] = step[k] + next / square * direction[k];
    square = next;
  }
  return work;
}

}  // namespace beadswim
