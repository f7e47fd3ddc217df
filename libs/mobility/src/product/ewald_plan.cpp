#include "beadswim/mobility/ewald_plan.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {
namespace {

// Work relative to a pair of beads, measured (docs/performance.md).
constexpr double work_of_pair = 1;
constexpr double work_of_window_point = 0.1;  ///< of three components, there and back
constexpr double work_of_mesh_point = 2.5;    ///< of six transforms

double work(const EwaldScene& scene, const EwaldPlan& plan) {
  const double volume = scene.lengths[0] * scene.lengths[1] * scene.lengths[2];
  const double neighbours = 4.0 / 3 * std::numbers::pi * std::pow(plan.cut_off, 3) * scene.beads / volume;
  double points = 1;
  for (const double length : scene.lengths) {
    const double along = length / plan.spacing;
    points *= scene.is_periodic ? std::max(along, 2.0) : 2 * (along + plan.window);
  }
  return work_of_pair * scene.beads * neighbours / 2 +
         work_of_window_point * scene.beads * std::pow(plan.window, 3) + work_of_mesh_point * points;
}

/// s = xi cut_off for the tolerance. Of random forces F on spheres of radius a, n in a volume, what lies
/// beyond the cut-off moves a sphere by some
///   F/(6 pi eta a)  3/(2 sqrt(pi)) xi a (1 + 4/3 (xi a s)^2) exp(-s^2) sqrt(pi n s/xi^3)
/// (the near tensor's Gaussians, squared and summed over r > s/xi); waves that are left out do as much. Held
/// to a quarter of the tolerance.
double cut_off_in_splittings(const EwaldScene& scene, double xi) {
  const double density = scene.beads / (scene.lengths[0] * scene.lengths[1] * scene.lengths[2]);
  const double size = xi * scene.typical_radius;
  double s = 3;
  for (int i = 0; i < 20; ++i) {
    const double each = 1.5 / std::sqrt(std::numbers::pi) * size * (1 + 4.0 / 3 * size * size * s * s);
    const double error = 3 * each * std::sqrt(std::numbers::pi * density * s / (xi * xi * xi));
    s = std::sqrt(std::max(4.0, std::log(std::max(error, 0.5) / scene.tolerance)));
  }
  return s;
}

/// The plan of one splitting.
EwaldPlan plan_with(const EwaldScene& scene, double xi) {
  const double s = cut_off_in_splittings(scene, xi);
  // The best shape, and the error it leaves, found by trying (docs/method/mobility-product.md).
  const auto shape = [](int points) { return 0.95 * std::sqrt(std::numbers::pi * points); };
  const double size = xi * s * scene.typical_radius;
  const auto error = [&](int points) {
    return 4 * (1 + 0.6 * size * size * size * size) * std::exp(-1.36 * points);
  };
  int window = 4;
  while (window < 26 && error(window) > scene.tolerance) window += 2;
  // Windows must leave enough of the Gaussian to the kernel, or its samples alias in open space:
  // share = (window pi/(2 s m))^2 <= 0.6.
  const double least = std::numbers::pi * window / shape(window) / (2 * std::sqrt(0.6));
  return {.xi = xi,
          .cut_off = s / xi,
          .spacing = std::numbers::pi / (2 * std::max(s, least) * xi),
          .window = window,
          .window_shape = shape(window)};
}

}  // namespace

EwaldPlan plan_ewald(const EwaldScene& scene) {
  if (!(scene.tolerance >= 1e-12 && scene.tolerance <= 1e-2))
    throw InputError(Setting::tolerance, fmt::format("{} is not between 1e-12 and 1e-2", scene.tolerance));
  const double shortest = scene.lengths.minCoeff();
  const double volume = scene.lengths[0] * scene.lengths[1] * scene.lengths[2];
  // From cut-offs of half the shortest edge, or of all beads, down to that of the nearest neighbours.
  const double longest = scene.is_periodic ? shortest / 2 : std::cbrt(volume);
  const double shortest_cut_off = 2 * scene.typical_radius;  // spheres that overlap are summed as pairs
  if (longest < shortest_cut_off)
    throw InputError(
        "box", fmt::format("its edge of {} is less than four radii of {}; enlarge it, or take none ({})",
                           shortest, scene.typical_radius, Setting::unbounded));
  EwaldPlan best;
  double least = INFINITY;
  constexpr int trials = 60;
  for (int t = 0; t < trials; ++t) {
    const double cut_off = std::max(longest * std::pow(0.9, t), shortest_cut_off);
    double xi = 5 / cut_off;
    for (int i = 0; i < 5; ++i)
      xi *= plan_with(scene, xi).cut_off / cut_off;  // the cut-off hangs on xi a little
    EwaldPlan plan = plan_with(scene, xi);
    plan.cut_off = std::min(plan.cut_off, longest);
    if (const double w = work(scene, plan); w < least) {
      least = w;
      best = plan;
    }
  }
  return best;
}

int good_mesh_size(double at_least) {
  for (int n = std::max(2, static_cast<int>(std::ceil(at_least - 1e-9)));; ++n) {
    int rest = n;
    for (const int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

}  // namespace beadswim
