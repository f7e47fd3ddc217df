#include "multipole_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim::multipole {

namespace {

/// Returns the bispherical coordinate xi of sphere i relative to sphere j. With the distance R of the centres
/// and the radii a_i and a_j:
///
///   cosh xi     = (R^2 + a_i^2 - a_j^2) / (2 R a_i)
///   cosh xi - 1 = (R - a_i - a_j) (R - a_i + a_j) / (2 R a_i)
///
/// The second form avoids loss of significance near contact.
double bispherical_coordinate(const Line& line, int i, int j) {
  const double a_i = line.radius[i], a_j = line.radius[j];
  const double distance = std::abs(line.position[i] - line.position[j]);
  const double gap = std::max(0.0, distance - a_i - a_j);
  const double excess = gap * (distance - a_i + a_j) / (2 * distance * a_i);
  return std::log1p(excess + std::sqrt(excess * (2 + excess)));
}

/// Estimates the highest multipole order of sphere i that its neighbour j makes necessary. The multipoles of
/// order n contribute about C exp(-2 n xi) to the mobility, where xi is the bispherical coordinate of sphere
/// i. The estimate is therefore log(C/tolerance)/(2 xi). Numerical experiments give C near 8000 for distant
/// spheres and near 8000/x^6 for close spheres, where x is the mean of xi of both spheres. The estimate is an
/// initial guess; multipole_mobility() determines the actual error from the solution.
double needed_order(const Line& line, int i, int j, double log_tolerance) {
  const double xi = bispherical_coordinate(line, i, j);
  const double mean_xi = (xi + bispherical_coordinate(line, j, i)) / 2;
  const double log_size = std::log(8000.0) - 6 * std::min(0.0, std::log(mean_xi));
  return (log_size - log_tolerance) / (2 * xi);
}

int needed_order(const Line& line, int i, double log_tolerance) {
  double order = 4;
  for (int j = 0; j < line.size(); ++j) {
    if (j != i) order = std::max(order, needed_order(line, i, j, log_tolerance));
  }
  if (order > max_multipole_order) {
    throw InputError(fmt::format("sphere {}", i + 1),
                     fmt::format("the sphere is too close to its neighbour and needs multipoles of order "
                                 "{:.0f}, above the limit of {}; increase the gap or the tolerance",
                                 order, max_multipole_order));
  }
  return static_cast<int>(std::ceil(order));
}

}  // namespace

int Line::largest_order() const {
  const auto lower = [](const Sphere& a, const Sphere& b) { return a.order() < b.order(); };
  return std::max_element(sphere.begin(), sphere.end(), lower)->order();
}

Pair Line::pair(int receiver, int source) const {
  return {.receiver_radius = radius[receiver],
          .source_radius = radius[source],
          .offset = position[receiver] - position[source],
          .receiver_order = sphere[receiver].order(),
          .source_order = sphere[source].order()};
}

Line make_line(std::span<const double> radii, std::span<const double> positions, double log_tolerance) {
  Line line{.radius = radii, .position = positions, .sphere = {}, .start = {0}};
  for (int i = 0; i < line.size(); ++i) {
    line.sphere.emplace_back(needed_order(line, i, log_tolerance));
    line.start.push_back(line.start.back() + line.sphere[i].unknowns());
  }
  return line;
}

double nearest_bispherical_coordinate(const Line& line, int i) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int j = 0; j < line.size(); ++j) {
    if (j != i) nearest = std::min(nearest, bispherical_coordinate(line, i, j));
  }
  return nearest;
}

}  // namespace beadswim::multipole
