#include "beadswim/compare/diffusion.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

constexpr std::size_t fewest_windows = 10;  // of a diffusion

/// Returns value(path, first, last) of all windows of `length` intervals of all paths.
template <class Value>
auto of_windows(std::span<const SwimmerPath> paths, std::size_t length, const Value& value) {
  std::vector<decltype(value(paths[0], 0, 0))> values;
  for (const SwimmerPath& path : paths)
    for (std::size_t last = length; last < path.places.size(); last += length)
      values.push_back(value(path, last - length, last));
  return values;
}

MeanAndError<double> turning(std::span<const SwimmerPath> paths, std::size_t length) {
  return mean_with_error(
      of_windows(paths, length, [](const SwimmerPath& path, std::size_t first, std::size_t last) {
        return path.axes[first].dot(path.axes[last]);
      }));
}

}  // namespace

void SwimmerPath::append(const SwimmerType& type, std::span<const Vec3> beads,
                         const Eigen::Matrix3d& initial_orientation) {
  places.emplace_back(columns_of_beads(beads).rowwise().mean());
  axes.push_back(axis_of(type, beads, initial_orientation));
}

MeanAndError<double> mean_with_error(std::span<const double> numbers) {
  const auto count = static_cast<double>(numbers.size());
  double mean = 0, square = 0;
  for (const double number : numbers) mean += number / count;
  for (const double number : numbers) square += (number - mean) * (number - mean);
  return {.mean = mean, .standard_error = std::sqrt(square / (count * (count - 1)))};
}

DisplacementStatistics displacement_statistics(std::span<const SwimmerPath> paths, std::size_t intervals) {
  const auto square = [](const SwimmerPath& path, std::size_t first, std::size_t last) {
    return (path.places[last] - path.places[first]).squaredNorm();
  };
  return {.square = mean_with_error(of_windows(paths, intervals, square)),
          .cosine = turning(paths, intervals)};
}

namespace {

/// Sets rotational diffusion and persistence time, where they are known.
void add_turning(std::span<const SwimmerPath> paths, std::size_t intervals, double interval,
                 DiffusionStatistics& result) {
  constexpr std::size_t windows = 1000;
  constexpr double least = 0.5;
  std::size_t lag = std::clamp<std::size_t>(intervals * paths.size() / windows, 1, intervals / 2);
  while (lag > 1 && turning(paths, 2 * lag).mean < least) lag /= 2;
  if (paths.size() * (intervals / (2 * lag)) < fewest_windows) return;
  const MeanAndError<double> once = turning(paths, lag), twice = turning(paths, 2 * lag);
  if (!(twice.mean > least)) return;
  const double time = 2 * static_cast<double>(lag) * interval;
  const double rate = std::log(once.mean / twice.mean) / time,
               error = std::hypot(once.standard_error / once.mean, twice.standard_error / twice.mean) / time;
  result.rotational_diffusion = {.mean = rate, .standard_error = error};
  if (rate > 3 * error)
    result.persistence_time = {.mean = 1 / (2 * rate), .standard_error = error / (2 * rate * rate)};
}

}  // namespace

DiffusionStatistics diffusion_statistics(std::span<const SwimmerPath> paths, double interval) {
  constexpr std::size_t wanted_windows = 20;
  constexpr double persistence_times = 10;
  const std::size_t intervals = paths.empty() || paths[0].places.empty() ? 0 : paths[0].places.size() - 1;
  std::size_t length = std::clamp<std::size_t>(intervals * paths.size() / wanted_windows, 1,
                                               std::max<std::size_t>(1, intervals));
  DiffusionStatistics result;
  if (intervals < 2) return result;
  add_turning(paths, intervals, interval, result);
  if (result.persistence_time)
    length = std::min(length, static_cast<std::size_t>(
                                  std::ceil(persistence_times * result.persistence_time->mean / interval)));
  const double lag = static_cast<double>(length) * interval;
  const auto displacement = [](const SwimmerPath& path, std::size_t first, std::size_t last) -> Vec3 {
    return path.places[last] - path.places[first];
  };
  std::vector<double> squares;
  std::array<std::vector<double>, 3> velocities;
  for (const Vec3& moved : of_windows(paths, length, displacement)) {
    squares.push_back(moved.squaredNorm() / (6 * lag));
    for (int a = 0; a < 3; ++a) velocities[a].push_back(moved[a] / lag);
  }
  if (squares.size() >= fewest_windows) result.effective_diffusion = mean_with_error(squares);
  result.lag = lag;
  result.mean_velocity.emplace();
  for (int a = 0; a < 3; ++a) {
    const auto [mean, error] = mean_with_error(velocities[a]);
    result.mean_velocity->mean[a] = mean;
    result.mean_velocity->standard_error[a] = error;
  }
  return result;
}

}  // namespace beadswim
