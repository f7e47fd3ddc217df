#include "visible_stretches.hpp"

#include <cmath>

namespace beadswim {
namespace {

struct Band {
  double top = 0, bottom = 0;

  bool contains(const svg::Point& point) const { return point.y >= top && point.y <= bottom; }
};

bool is_finite(const svg::Point& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

/// Returns the point at which the line from `inside` to `outside` leaves the band.
svg::Point exit_point(const svg::Point& inside, const svg::Point& outside, const Band& band) {
  const double y = outside.y < band.top ? band.top : band.bottom;
  const double part = (y - inside.y) / (outside.y - inside.y);
  return {inside.x + part * (outside.x - inside.x), y};
}

}  // namespace

std::vector<Stretch> visible_stretches(const std::vector<svg::Point>& points, double top, double bottom) {
  const Band band{top, bottom};
  std::vector<Stretch> stretches;
  const svg::Point* last = nullptr;  // nullptr after an interruption
  for (const svg::Point& point : points) {
    const bool inside = is_finite(point) && band.contains(point);
    const bool was_inside = last != nullptr && band.contains(*last);
    if (inside && !was_inside) stretches.emplace_back();
    if (inside && last != nullptr && !was_inside) stretches.back().push_back(exit_point(point, *last, band));
    if (inside) stretches.back().push_back(point);
    if (was_inside && !inside && is_finite(point)) {
      stretches.back().push_back(exit_point(*last, point, band));
    }
    last = is_finite(point) ? &point : nullptr;
  }
  return stretches;
}

}  // namespace beadswim
