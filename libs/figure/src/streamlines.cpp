#include "beadswim/figure/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace beadswim {
namespace {

constexpr int steps_per_distance = 10;
constexpr double min_seed_distance = 0.95;  // of a seed from other lines, relative to `distance`
constexpr double min_line_distance = 0.5;   // of a line from other lines, relative to `distance`
constexpr double min_length = 2.5;          // of a line, relative to `distance`
constexpr double max_turning = 1.01 * 2 * std::numbers::pi;
constexpr int max_steps = 20000;

/// Points of all lines, in square cells, so that those near a place are found fast.
class PlacedPoints {
 public:
  PlacedPoints(const Eigen::AlignedBox2d& region, double distance)
      : low_(region.min()),
        distance_(distance),
        cells_((region.sizes() / distance).array().floor().cast<int>() + 1),
        points_(cells_.prod()) {}

  void add(const Streamline& line) {
    for (const PlanePoint& point : line) points_[index(cell(point))].push_back(point);
  }

  /// Returns true if a point is nearer than `limit` times the distance, which is at most 1.
  bool has_near(const PlanePoint& place, double limit) const {
    const double square = std::pow(limit * distance_, 2);
    const auto is_near = [&](const PlanePoint& point) { return (point - place).squaredNorm() < square; };
    const Eigen::Array2i at = cell(place), from = (at - 1).max(0), to = (at + 1).min(cells_ - 1);
    for (int y = from.y(); y <= to.y(); ++y)
      for (int x = from.x(); x <= to.x(); ++x)
        if (std::ranges::any_of(points_[index({x, y})], is_near)) return true;
    return false;
  }

 private:
  /// Returns the cell that contains a place, or the nearest one.
  Eigen::Array2i cell(const PlanePoint& place) const {
    return ((place - low_) / distance_).array().floor().cast<int>().max(0).min(cells_ - 1);
  }
  std::size_t index(const Eigen::Array2i& cell) const {
    return static_cast<std::size_t>(cell.y()) * cells_.x() + cell.x();
  }

  PlanePoint low_;
  double distance_;
  Eigen::Array2i cells_;
  std::vector<std::vector<PlanePoint>> points_;
};

class StreamlineTracer {
 public:
  StreamlineTracer(const PlaneVelocity& velocity, const Eigen::AlignedBox2d& region, double distance)
      : velocity_(velocity),
        region_(region),
        distance_(distance),
        step_(distance / steps_per_distance),
        placed_(region, distance) {}

  /// Traces the line through a seed, and then lines beside it and beside each other, if there is room.
  void fill_from(const PlanePoint& seed) {
    std::size_t next = lines_.size();
    add_line_through(seed);
    for (; next < lines_.size(); ++next) {
      for (const PlanePoint& place : places_beside(lines_[next])) add_line_through(place);
    }
  }

  std::vector<Streamline> lines() && { return std::move(lines_); }

 private:
  /// Returns the direction of the flow, times `sign`; nullopt where there is no flow.
  std::optional<PlanePoint> direction(const PlanePoint& place, double sign) const {
    const PlanePoint velocity = velocity_(place);
    const double speed = velocity.stableNorm();
    return speed > 0 ? std::optional<PlanePoint>(sign * velocity / speed) : std::nullopt;
  }

  /// Takes a step along the flow (sign 1) or against it (-1); nullopt at a stagnation point.
  std::optional<PlanePoint> stepped(const PlanePoint& from, double sign) const {
    PlanePoint sum = PlanePoint::Zero(), last = PlanePoint::Zero();
    constexpr std::array<double, 4> nodes{0, 0.5, 0.5, 1}, weights{1, 2, 2, 1};
    for (int stage = 0; stage < 4; ++stage) {
      const auto along = direction(from + nodes[stage] * step_ * last, sign);
      if (!along) return std::nullopt;
      last = *along;
      sum += weights[stage] / 6 * last;
    }
    if (sum.norm() < 0.5) return std::nullopt;  // the direction changes within the step
    return from + step_ * sum;
  }

  /// Returns the part of the line on one side of its seed. Adds to `turning` the angle by which the part
  /// turns in the direction of the flow [rad].
  Streamline half_line(const PlanePoint& seed, double sign, double& turning) const {
    Streamline line{seed};
    for (int n = 0; n < max_steps && std::abs(turning) < max_turning; ++n) {
      const auto next = stepped(line.back(), sign);
      if (!next || placed_.has_near(*next, min_line_distance)) break;
      const PlanePoint along = *next - line.back();
      if (n > 0) {
        const PlanePoint before = line.back() - line[line.size() - 2];
        turning += sign * std::atan2(before.x() * along.y() - before.y() * along.x(), before.dot(along));
      }
      if (n > 3 && (*next - seed).norm() < 0.75 * step_ && along.dot(line[1] - seed) > 0) {
        if ((seed - *next).dot(along) > 0) line.push_back(*next);
        line.push_back(seed);
        break;
      }
      line.push_back(*next);
      if (!region_.contains(*next)) break;
    }
    return line;
  }

  void add_line_through(const PlanePoint& seed) {
    if (!region_.contains(seed) || placed_.has_near(seed, min_seed_distance)) return;
    double turning = 0;
    Streamline line = half_line(seed, 1, turning);
    const bool is_closed = line.size() > 1 && line.back() == seed;
    if (!is_closed) {
      Streamline before = half_line(seed, -1, turning);
      std::ranges::reverse(before);
      line.insert(line.begin(), before.begin(), before.end() - 1);
    }
    if (static_cast<double>(line.size()) < min_length * steps_per_distance) return;
    placed_.add(line);
    lines_.push_back(std::move(line));
  }

  /// Returns places at the distance of new lines from a line, on both sides of it.
  std::vector<PlanePoint> places_beside(const Streamline& line) const {
    std::vector<PlanePoint> places;
    for (std::size_t n = 1; n < line.size(); n += steps_per_distance) {
      const PlanePoint along = (line[n] - line[n - 1]).normalized(), across(-along.y(), along.x());
      for (const double side : {1.0, -1.0}) places.emplace_back(line[n] + side * distance_ * across);
    }
    return places;
  }

  const PlaneVelocity& velocity_;
  Eigen::AlignedBox2d region_;
  double distance_, step_;
  PlacedPoints placed_;
  std::vector<Streamline> lines_;
};

}  // namespace

std::vector<Streamline> streamlines(const PlaneVelocity& velocity, const Eigen::AlignedBox2d& region,
                                    double distance) {
  StreamlineTracer tracer(velocity, region, distance);
  tracer.fill_from(region.center());
  const Eigen::Array2i places = (region.sizes() / distance).array().floor().cast<int>() + 1;
  for (int y = 0; y < places.y(); ++y)  // parts of the region that the lines so far have not reached
    for (int x = 0; x < places.x(); ++x)
      tracer.fill_from(region.min() + distance * PlanePoint(x + 0.5, y + 0.5));
  return std::move(tracer).lines();
}

}  // namespace beadswim
