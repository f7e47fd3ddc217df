#include "beadswim/mobility/ewald_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

// Measured computing times, divided by the computing time per pair of beads (docs/performance.md).
struct Work {
  double pair = 1;
  double window_point = 0.1;  ///< per bead and mesh point of its window, for three components
  double mesh_point = 1.7;    ///< per mesh point, for six Fourier transforms
  /// Over a wall: number of pairs of a bead and a mirror point that take as long as one mesh point.
  double mirror_pairs_per_mesh_point = 2;
};

/// By the highest moment of the forces; with moments, there are two fields of three components.
constexpr std::array<Work, 3> works{
    Work{}, Work{.pair = 15, .window_point = 0.5, .mesh_point = 5, .mirror_pairs_per_mesh_point = 0.6},
    Work{.pair = 60, .window_point = 0.7, .mesh_point = 5, .mirror_pairs_per_mesh_point = 0.2}};

/// Largest xi a of an Ewald sum whose near part must be positive. In dense random systems of equal and
/// unequal spheres its smallest eigenvalue is then 0.03 times the mobility of a sphere, and -0.08 at xi a =
/// 0.9.
constexpr double largest_positive = 0.6;

/// Returns the number of points of a mesh in a box with these edges.
double mesh_points(const EwaldScene& scene, const EwaldPlan& plan, const Vec3& lengths) {
  double points = 1;
  for (const double length : lengths) {
    const double along = length / plan.spacing;
    points *= scene.is_periodic ? std::max(along, 2.0) : 2 * (along + plan.window);
  }
  return points;
}

/// Computing times per pair of a point and a bead, by the highest moment of the forces, and per mesh point of
/// a window, in the same unit.
constexpr std::array work_per_near_point{20.0, 25.0, 35.0}, work_per_direct_point{8.0, 12.0, 20.0};
constexpr double work_per_gathered_point = 0.05;

double work(const EwaldScene& scene, const EwaldPlan& plan) {
  const double volume = scene.lengths[0] * scene.lengths[1] * scene.lengths[2];
  const double neighbours = 4.0 / 3 * std::numbers::pi * std::pow(plan.cutoff, 3) * scene.beads / volume;
  const Work& each = works[scene.moment_order];
  const double on_mesh = each.window_point * scene.beads * std::pow(plan.window, 3) +
                         each.mesh_point * mesh_points(scene, plan, scene.lengths);
  if (scene.points > 0)
    return scene.points * (work_per_near_point[scene.moment_order] * neighbours +
                           work_per_gathered_point * std::pow(plan.window, 3)) +
           on_mesh;
  const double on_pairs = each.pair * scene.beads * neighbours / 2;
  constexpr double near_sums = 8,
                   share_on_mesh = 0.7;  // of a root: noise needs no spreading, but random numbers
  return scene.is_for_root ? near_sums * on_pairs + share_on_mesh * on_mesh : on_pairs + on_mesh;
}

/// Returns true if a mesh that also contains the mirror points takes less time than a sum over all pairs of a
/// bead and a mirror point.
bool has_mirror_points(const EwaldScene& scene, const EwaldPlan& plan) {
  if (!scene.lengths_with_mirror_points) return false;
  const double points =
      mesh_points(scene, plan, *scene.lengths_with_mirror_points) - mesh_points(scene, plan, scene.lengths);
  return works[scene.moment_order].mirror_pairs_per_mesh_point * points <
         scene.beads * (scene.points > 0 ? scene.points : scene.beads);
}

/// Returns s = xi * cutoff for which the error of the velocities is within the tolerance. The estimate
/// assumes random forces F on spheres of radius a with the number density n. The pairs beyond the cutoff
/// contribute to the velocity of a sphere about
///
///   F/(6 pi eta a)  3/(2 sqrt(pi)) xi a (1 + 4/3 (xi a s)^2) exp(-s^2) sqrt(pi n s/xi^3)
///
/// This is the square root of the sum over all spheres at r > s/xi of the squared Gaussians in the near part
/// of the mobility tensor. The neglected wavevectors contribute an error of equal size. Each of the two
/// errors may be at most a third of the tolerance.
double scaled_cutoff(const EwaldScene& scene, double xi) {
  const double density = scene.beads / (scene.lengths[0] * scene.lengths[1] * scene.lengths[2]);
  const double size = xi * scene.largest_radius;
  double s = 3;
  for (int i = 0; i < 20; ++i) {
    const double each = 1.5 / std::sqrt(std::numbers::pi) * size * (1 + 4.0 / 3 * size * size * s * s);
    const double error = 3 * each * std::sqrt(std::numbers::pi * density * s / (xi * xi * xi));
    s = std::sqrt(std::max(4.0, std::log(std::max(error, 0.5) / scene.tolerance)));
  }
  return s;
}

/// Returns the cutoff and the mesh of an Ewald sum with the splitting parameter xi [1/length] whose estimated
/// error is within the tolerance.
EwaldPlan plan_with(const EwaldScene& scene, double xi) {
  const double s = scaled_cutoff(scene, xi);
  // For a window of P points per axis, numerical experiments gave the smallest error, 4 exp(-1.36 P) for
  // small beads, with the window shape m = 0.95 sqrt(pi P) (docs/method/mobility-product.md).
  const auto shape = [](int points) { return 0.95 * std::sqrt(std::numbers::pi * points); };
  const double size = xi * s * scene.largest_radius;
  const auto error = [&](int points) {
    return 4 * (1 + 0.6 * size * size * size * size) * std::exp(-1.36 * points);
  };
  int window = 6;
  while (window < 26 && error(window) > scene.tolerance) window += 2;
  // The windows may apply at most the share 0.6 of the exponent of the far part's Gaussian:
  // share = (window pi/(2 s m))^2 <= 0.6. Otherwise the remaining kernel of open space is too narrow for the
  // mesh, and its samples alias.
  const double minimum = std::numbers::pi * window / shape(window) / (2 * std::sqrt(0.6));
  return {.xi = xi,
          .cutoff = s / xi,
          .spacing = std::min(std::numbers::pi / (2 * std::max(s, minimum) * xi), scene.max_spacing),
          .window = window,
          .window_shape = shape(window)};
}

}  // namespace

EwaldPlan plan_ewald(const EwaldScene& asked) {
  if (!(asked.tolerance >= 1e-12 && asked.tolerance <= 1e-2))
    throw InputError(Setting::tolerance,
                     fmt::format("the tolerance {} is not between 1e-12 and 1e-2; give a value in this range",
                                 asked.tolerance));
  EwaldScene scene = asked;
  // Derivatives of the flow have larger relative errors than the flow: up to 2.3 times the tolerance was
  // measured for random moments in a small box. A factor of 8 leaves a margin.
  if (scene.moment_order > 0) scene.tolerance /= 8;
  // The flow that the wall adds contains derivatives of two higher orders. Without this factor, errors of up
  // to 2.2 times the tolerance were measured for forces alone, and 0.9 times for moments.
  if (scene.lengths_with_mirror_points) scene.tolerance /= scene.moment_order > 0 ? 2 : 4;
  const double shortest = scene.lengths.minCoeff();
  const double volume = scene.lengths[0] * scene.lengths[1] * scene.lengths[2];
  // The trial cutoffs decrease to the largest bead diameter. The first one is half the shortest edge of a
  // periodic box, or V^(1/3) in open space, where V is the volume of the box around all beads.
  const double max_cutoff = scene.is_periodic ? shortest / 2 : std::cbrt(volume);
  const double min_cutoff = 2 * scene.largest_radius;  // the sum over pairs must include overlapping beads
  // The near part is positive for small xi a only.
  const double max_xi = scene.is_for_root ? largest_positive / scene.largest_radius : INFINITY;
  if (max_cutoff < min_cutoff)
    throw InputError("box", fmt::format("the shortest box edge {} is less than four times the largest bead "
                                        "radius {}; enlarge the box or use open space ({})",
                                        shortest, scene.largest_radius, Setting::unbounded));
  EwaldPlan best;
  double minimum = INFINITY;
  constexpr int trials = 60;
  for (int t = 0; t < trials; ++t) {
    const double cutoff = std::max(max_cutoff * std::pow(0.9, t), min_cutoff);
    double xi = 5 / cutoff;
    for (int i = 0; i < 5; ++i)
      xi *= plan_with(scene, xi).cutoff / cutoff;  // xi * cutoff depends weakly on xi
    EwaldPlan plan = plan_with(scene, std::min(xi, max_xi));
    if (scene.is_for_root && plan.cutoff > max_cutoff) continue;
    plan.cutoff = std::min(plan.cutoff, max_cutoff);
    if (const double w = work(scene, plan); w < minimum) {
      minimum = w;
      best = plan;
    }
  }
  if (best.xi == 0) return best;  // no positive parts in so narrow a box
  best.has_mirror_points = has_mirror_points(scene, best);
  best.is_positive = scene.is_for_root;
  constexpr double max_points = 1e9;
  if (const double points = mesh_points(scene, best, scene.lengths); points > max_points)
    throw InputError("box",
                     fmt::format("the mesh needs {:.3g} points, above the limit of {:g}; use a smaller "
                                 "box, or one with less different edges, or open space ({})",
                                 points, max_points, Setting::unbounded));
  return best;
}

std::optional<EwaldPlan> plan_flow(const EwaldScene& scene) {
  const double direct = scene.points * scene.beads * work_per_direct_point[scene.moment_order];
  // A mesh that is too large for its points takes more time than the direct sum, which needs no plan.
  constexpr double min_pairs_on_mesh = 1e6;
  if (!scene.is_periodic && scene.points * scene.beads < min_pairs_on_mesh) return std::nullopt;
  try {
    const EwaldPlan plan = plan_ewald(scene);
    return scene.is_periodic || work(scene, plan) < direct ? std::optional(plan) : std::nullopt;
  } catch (const InputError&) {
    if (scene.is_periodic) throw;
    return std::nullopt;  // the mesh would have too many points
  }
}

int next_fft_size(double min_size) {
  for (int n = std::max(2, static_cast<int>(std::ceil(min_size - 1e-9)));; ++n) {
    int rest = n;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

}  // namespace beadswim
