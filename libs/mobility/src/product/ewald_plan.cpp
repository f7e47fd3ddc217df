#include "beadswim/mobility/ewald_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/core/gauss_legendre.hpp"
#include "beadswim/core/setting.hpp"
#include "ewald_split.hpp"
#include "window_table.hpp"

namespace beadswim {
namespace {

// Measured computing times, divided by the computing time per pair of beads (docs/performance.md).
struct Work {
  double pair = 1;
  double window_point = 0.075;  ///< per bead and mesh point of its window, for three components
  double mesh_point = 1.1;      ///< per mesh point, for six Fourier transforms
  /// Over a wall: number of pairs of a bead and a mirror point that take as long as one mesh point.
  double mirror_pairs_per_mesh_point = 2;
};

/// By the highest moment of the forces; with moments, there are two fields of three components.
constexpr std::array<Work, 3> works{
    Work{}, Work{.pair = 6, .window_point = 0.19, .mesh_point = 2, .mirror_pairs_per_mesh_point = 0.6},
    Work{.pair = 23, .window_point = 0.29, .mesh_point = 2, .mirror_pairs_per_mesh_point = 0.2}};
/// Of mesh points in open space, where most lines of values are not transformed.
constexpr double open_share = 0.65;

/// Largest xi a of an Ewald sum whose near part must be positive, where the splitting function decreases as
/// exp(-xi^2 r^2) near r = 0. In dense random systems of equal and unequal spheres its smallest eigenvalue is
/// then 0.03 times the mobility of a sphere, and -0.08 at xi a = 0.9.
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
  const int row = (plan.window + 3) / 4 * 4;  // of a window, which consists of whole vectors
  const double in_window = plan.window * plan.window * row;
  const double on_mesh =
      each.window_point * scene.beads * in_window +
      each.mesh_point * (scene.is_periodic ? 1 : open_share) * mesh_points(scene, plan, scene.lengths);
  if (scene.points > 0)
    return scene.points *
               (work_per_near_point[scene.moment_order] * neighbours + work_per_gathered_point * in_window) +
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

// clang-format off
// Errors of the velocities of random forces F on spheres of radius a with the number density n, divided by the velocity
// F/(6 pi eta a) of a sphere. G = s(k) p(k)/(eta k^2) is the far part of the mobility; p contains the sizes of the spheres
// and the orders of the moments. <> is the mean over the directions of k.
//
//   truncation of the wavevectors     n 2/3 integral of G^2 d^3k/(2 pi)^3 over k from k_m = pi/h to 1.5 k_m,
//                                     and of each sphere at itself   2/3 integral of G d^3k/(2 pi)^3
//   aliases of the windows W          n 4 integral of G^2 <q^2> d^3k/(2 pi)^3 below k_m, q = W(k_x + 2 pi m/h)/W(k_x),
//                                     and of each sphere at itself   24 (2/3 integral of G <q> d^3k/(2 pi)^3)^2
//
// The first line of each and the last line are mean squares. The integral over aliases is a sum for the longest waves,
// whose aliases are relative to velocities that contain the flow of these waves. Beyond 1.5 k_m, s(k) belongs to the edge
// of the near part alone. Measured errors: docs/method/mobility-product.md.
// clang-format on

/// Shape of the splitting function minus k_m times the cutoff; the truncation error is within 30 % of its
/// minimum.
constexpr double extra_shape = 0.7;
/// Shape of a window, divided by its number of points.
constexpr double window_shape = 1.9;
/// In open space, the mesh has wavevectors beyond k_m, where the filter of the kernel may be inaccurate
/// (particle_mesh.cpp).
constexpr double open_oversampling(int window) {
  return window > 12 ? 1.15 : window > 8 ? 1.1 : 1.05;
}
constexpr int min_window = 4;

/// Aliases of the windows at the wavenumber k = x pi/h: waves that differ by 2 pi m/h. With force moments
/// they decrease slowly with m, because derivatives of a window have jumps at its edges.
struct Aliases {
  static constexpr int max_order = 3;  ///< largest m
  using ByPoints = std::array<double, WindowTable::max_points + 1>;
  struct Node {
    double x, weight;
    std::array<ByPoints, max_order> square, own;  ///< mean square and half the mean, by m - 1
  };
  std::vector<Node> nodes;

  Aliases() {
    for (const auto& [x, weight] : gauss_legendre(16, 0, 1)) {
      Node node{.x = x, .weight = weight, .square = {}, .own = {}};
      for (int points = min_window; points <= WindowTable::max_points; ++points) {
        const double square = std::pow(window_shape * points, 2);
        const auto transform = [&](double k) { return sinh_ratio(square - std::pow(k * points / 2, 2)); };
        for (const auto& [along, share] : gauss_legendre(8, 0, 1)) {
          const double k = std::numbers::pi * x * along, own = transform(k);
          for (int m = -max_order; m <= max_order; ++m) {
            if (m == 0) continue;
            const double alias = transform(k + 2 * std::numbers::pi * m) / own;
            node.square[std::abs(m) - 1][points] += 3 * share * alias * alias;
            node.own[std::abs(m) - 1][points] += share * alias / 2;
          }
        }
      }
      nodes.push_back(node);
    }
  }
};

/// Waves of a periodic box up to the wavenumber of its shortest edge. In a narrow box they are too few for an
/// integral.
struct LongWaves {
  double max_wavenumber = 0;
  double sum = 0;  ///< 2 pi^2/V times the sum of 1/k^4, in place of the integral of 1/k^2 dk [length]

  explicit LongWaves(const Vec3& lengths) {
    constexpr double roundoff = 1e-9;
    constexpr double max_index = 16;  // shorter waves along an edge add less than 1 % to the sum
    const double circle = 2 * std::numbers::pi, volume = lengths.prod();
    max_wavenumber = (1 + roundoff) * circle / lengths.minCoeff();
    std::array<int, 3> most{};
    for (int a = 0; a < 3; ++a)
      most[a] = static_cast<int>(std::min(max_index, max_wavenumber / circle * lengths[a]));
    for (int x = -most[0]; x <= most[0]; ++x)
      for (int y = -most[1]; y <= most[1]; ++y)
        for (int z = -most[2]; z <= most[2]; ++z) {
          const double square = (circle * Vec3(x, y, z).cwiseQuotient(lengths)).squaredNorm();
          if (square > 0 && square < max_wavenumber * max_wavenumber)
            sum += circle * std::numbers::pi / volume / (square * square);
        }
  }
};

/// Mean square errors of an Ewald sum.
struct Errors {
  double truncation = 0;
  Aliases::ByPoints of_window{};
};

/// Returns the errors for the cutoff c, if the largest wavenumber is k_m = z/c.
Errors errors(const EwaldScene& scene, const Aliases& aliases, const LongWaves& long_waves, double cutoff,
              double z) {
  const double largest = z / cutoff, a2 = scene.largest_radius * scene.largest_radius;
  const double density = scene.beads / (scene.lengths[0] * scene.lengths[1] * scene.lengths[2]);
  const double square = std::pow(z + extra_shape, 2), whole = sinh_ratio(square);
  const auto moments = [&](double k) {
    const double size = a2 * k * k;
    return scene.moment_order == 0 ? 1
                                   : std::sqrt(1 + size + (scene.moment_order == 1 ? 0 : size * size / 60));
  };
  const auto far_part = [&](double k, bool is_at_cutoff) {
    const double waves = k * k * cutoff * cutoff, size = a2 * k * k;
    // The terms of the sizes of two spheres nearly cancel at some wavenumber, but not their errors at the
    // cutoff.
    const double second = scene.is_for_root ? size * size / 36 : 0;
    const double sizes = is_at_cutoff ? std::hypot(1, size / 3, second) : 1 - size / 3 + second;
    const double share = (sinh_ratio(square - waves) + waves * sinh_ratio_slope(square - waves)) / whole;
    return (k < scene.memory_cutoff ? 1 : share) * sizes * moments(k);
  };
  // With the weight 4 pi k^2/(2 pi)^3, in the unit 1/(6 pi a).
  const double unit = 3 * scene.largest_radius / std::numbers::pi;
  Errors result;
  double own = 0;
  for (const auto& [k, weight] : gauss_legendre(16, largest, 1.5 * largest)) {
    const double far = far_part(k, true) * moments(k);
    result.truncation += weight * far * far / (k * k);
    own += weight * far;
  }
  const double pairs = unit * unit * 2.0 / 3 * density * 2 * std::numbers::pi * std::numbers::pi;
  result.truncation = pairs * result.truncation + std::pow(2.0 / 3 * unit * own / 2, 2);
  Aliases::ByPoints own_alias{};
  for (int m = 1; m <= Aliases::max_order; ++m) {
    const auto add = [&](const Aliases::Node& node, double share, double far) {
      for (int points = min_window; points <= WindowTable::max_points; ++points)
        result.of_window[points] += 2 * pairs * share * far * far * node.square[m - 1][points];
    };
    for (const Aliases::Node& node : aliases.nodes) {
      const double k = node.x * largest, far = far_part(k, false) * moments(2 * m * largest - k / 2);
      if (k > long_waves.max_wavenumber) add(node, node.weight * largest / (k * k), far);
      for (int points = min_window; points <= WindowTable::max_points; ++points)
        own_alias[points] += node.weight * largest * far * node.own[m - 1][points];
    }
    add(aliases.nodes.front(), long_waves.sum / (1 + pairs * long_waves.sum), moments(2 * m * largest));
  }
  for (int points = min_window; points <= WindowTable::max_points; ++points)
    result.of_window[points] += 24 * std::pow(2.0 / 3 * unit * own_alias[points], 2);
  return result;
}

/// Returns the parameters of Ewald sums with this cutoff whose estimated error is within the tolerance: for
/// each number of points of the window, those with the coarsest mesh.
std::vector<EwaldPlan> plans_with(const EwaldScene& scene, const Aliases& aliases,
                                  const LongWaves& long_waves, double cutoff) {
  // Safety factors on the estimated error, by the highest moment. With them, the largest measured error was
  // 0.81 times the tolerance.
  constexpr std::array safety_in_box{1.15, 1.6, 1.4}, safety_in_open_space{1.6, 1.6, 1.4};
  constexpr double min_z = 4, max_z = 80, factor = 1.04;
  const double safety = (scene.is_periodic ? safety_in_box : safety_in_open_space)[scene.moment_order];
  const double allowed = std::pow(scene.tolerance / safety, 2);
  std::vector<EwaldPlan> plans;
  int points = WindowTable::max_points;
  constexpr double memory_share = 0.95;  // of the largest wavenumber
  const double of_memory = scene.memory_cutoff * cutoff / memory_share;
  for (double z = std::max(min_z, of_memory); z < std::max(max_z, 1.5 * of_memory) && points >= min_window;
       z *= factor) {
    const Errors error = errors(scene, aliases, long_waves, cutoff, z);
    for (; points >= min_window && error.truncation + error.of_window[points] <= allowed; --points)
      plans.push_back(
          {.cutoff = cutoff,
           .shape = z + extra_shape,
           .spacing = std::numbers::pi * cutoff / z / (scene.is_periodic ? 1 : open_oversampling(points)),
           .window = points,
           .window_shape = window_shape * points});
  }
  return plans;
}

}  // namespace

EwaldPlan plan_ewald(const EwaldScene& asked) {
  if (!(asked.tolerance >= 1e-12 && asked.tolerance <= 1e-2))
    throw InputError(Setting::tolerance,
                     "the tolerance {} is not between 1e-12 and 1e-2; give a value in this range",
                     asked.tolerance);
  EwaldScene scene = asked;
  // The flow that the wall adds contains derivatives of two higher orders. Without these factors, errors of
  // up to 12 times the tolerance were measured for forces alone, and 45 times for moments.
  if (scene.lengths_with_mirror_points) scene.tolerance /= scene.moment_order > 0 ? 64 : 32;
  const double shortest = scene.lengths.minCoeff();
  const double volume = scene.lengths[0] * scene.lengths[1] * scene.lengths[2];
  // The trial cutoffs decrease to the largest bead diameter. The first one is half the shortest edge of a
  // periodic box, or V^(1/3) in open space, where V is the volume of the box around all beads.
  const double max_cutoff = scene.is_periodic ? shortest / 2 : std::cbrt(volume);
  const double min_cutoff = 2 * scene.largest_radius;  // the sum over pairs must include overlapping beads
  if (max_cutoff < min_cutoff)
    throw InputError("box",
                     "the shortest box edge {} is less than four times the largest bead radius {}; enlarge "
                     "the box or use open space ({})",
                     shortest, scene.largest_radius, Setting::unbounded);
  const Aliases aliases;
  const LongWaves long_waves(scene.lengths);
  EwaldPlan best;
  double minimum = INFINITY;
  constexpr int trials = 60;
  for (int t = 0; t < trials; ++t) {
    const double cutoff = std::max(max_cutoff * std::pow(0.9, t), min_cutoff);
    for (const EwaldPlan& plan : plans_with(scene, aliases, long_waves, cutoff)) {
      if (scene.is_for_root && std::sqrt(plan.shape / 2) * scene.largest_radius > largest_positive * cutoff)
        continue;
      if (const double w = work(scene, plan); w < minimum) {
        minimum = w;
        best = plan;
      }
    }
    if (cutoff == min_cutoff) break;
  }
  if (best.cutoff == 0 && !scene.is_for_root)
    throw InputError(Setting::tolerance,
                     "the tolerance {} cannot be met in a box whose shortest edge is {}; increase the "
                     "tolerance or enlarge the box",
                     asked.tolerance, shortest);
  if (best.cutoff == 0) return best;  // no positive parts in so narrow a box
  best.has_mirror_points = has_mirror_points(scene, best);
  best.is_positive = scene.is_for_root;
  constexpr double max_points = 1e9;
  if (const double points = mesh_points(scene, best, scene.lengths); points > max_points)
    throw InputError("box",
                     "the mesh needs {:.3g} points, above the limit of {:g}; use a smaller box, or one with "
                     "less different edges, or open space ({})",
                     points, max_points, Setting::unbounded);
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
