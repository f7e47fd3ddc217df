#include "outside_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "beadswim/core/gauss_legendre.hpp"

namespace beadswim {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// One half of the region of a sphere, on one side of the plane through its centre.
struct HalfRegion {
  double centre, radius;
  int side;      ///< direction of increasing x from the centre: -1 or 1
  double plane;  ///< distance of the plane that ends the region from the centre; infinite if there is none
};

/// Adds the nodes of all points with the given cosines up to the plane.
class RegionNodes {
 public:
  RegionNodes(const HalfRegion& region, const std::vector<double>& shells, int count,
              std::vector<RingNode>& nodes)
      : region_(region), shells_(shells), unit_(gauss_legendre(count, 0, 1)), nodes_(nodes) {}

  /// Adds the rays whose cosines (without sign) are between `low` and `high`, at which the plane is in one
  /// shell.
  void add_cone(double low, double high) {
    for (const auto& [place, weight] : unit_) add_ray(low + (high - low) * place, (high - low) * weight);
  }

 private:
  void add_ray(double cosine, double weight) {
    const double end = region_.plane / cosine;
    double from = shells_.front();
    for (std::size_t k = 1; k < shells_.size() && shells_[k] < end; ++k) {
      add_shell(cosine, weight, from, shells_[k]);
      from = shells_[k];
    }
    if (from == shells_.back()) {
      add_far(cosine, weight, from, end);
    } else {
      add_shell(cosine, weight, from, end);
    }
  }

  void add_shell(double cosine, double weight, double from, double to) {
    for (const auto& [place, share] : unit_)
      add_node(cosine, from + (to - from) * place, weight * share * (to - from));
  }

  /// Adds the nodes from the outermost shell to the plane or to infinity. The variable is t = 1/r, dr =
  /// -dt/t^2.
  void add_far(double cosine, double weight, double from, double to) {
    const double near = 1 / from, far = 1 / to;
    for (const auto& [place, share] : unit_) {
      const double t = far + (near - far) * place;
      add_node(cosine, 1 / t, weight * share * (near - far) / (t * t));
    }
  }

  void add_node(double cosine, double r, double weight) {
    nodes_.push_back({.x = region_.centre + region_.side * r * cosine,
                      .s = r * std::sqrt(1 - cosine * cosine),
                      .weight = 2 * std::numbers::pi * r * r * weight});
  }

  const HalfRegion& region_;
  const std::vector<double>& shells_;
  std::vector<QuadratureNode> unit_;
  std::vector<RingNode>& nodes_;
};

/// Returns the radii of the shells around a sphere, whose thickness doubles outwards.
std::vector<double> shells_of(double radius, double thinnest, double reach) {
  std::vector<double> shells{radius};
  for (double thickness = thinnest; shells.back() < reach; thickness *= 2)
    shells.push_back(radius + thickness);
  return shells;
}

void add_region(const HalfRegion& region, const std::vector<double>& shells, int count,
                std::vector<RingNode>& nodes) {
  RegionNodes rays(region, shells, count, nodes);
  double high = 1;
  for (const double shell : shells) {  // the plane leaves a shell where r = plane/cosine is its radius
    const double cosine = region.plane / shell;
    if (cosine >= 1) continue;
    rays.add_cone(cosine, high);
    high = cosine;
  }
  rays.add_cone(0, high);
}

}  // namespace

std::vector<RingNode> outside_nodes(std::span<const double> radii, std::span<const double> positions,
                                    double depth, int count) {
  const std::size_t spheres = radii.size();
  const auto gap = [&](std::size_t i) { return positions[i + 1] - radii[i + 1] - positions[i] - radii[i]; };
  const double length = positions.back() - positions.front() + *std::max_element(radii.begin(), radii.end());
  const double reach =
      8 * std::clamp(depth, length, 100 * length);  // of the shells; beyond, r^-4 and less matter
  std::vector<RingNode> nodes;
  for (std::size_t i = 0; i < spheres; ++i) {
    const double before = i > 0 ? gap(i - 1) / 2 : infinite, after = i + 1 < spheres ? gap(i) / 2 : infinite;
    constexpr double min_gap_over_radius = 0.01;  // also of beads that touch
    const double nearest = std::max(2 * std::min(before, after), min_gap_over_radius * radii[i]);
    const double thinnest = std::min({radii[i], depth, nearest});
    const std::vector<double> shells = shells_of(radii[i], thinnest, reach);
    add_region({positions[i], radii[i], -1, radii[i] + before}, shells, count, nodes);
    add_region({positions[i], radii[i], 1, radii[i] + after}, shells, count, nodes);
  }
  return nodes;
}

}  // namespace beadswim
