#include "beadswim/scene/layers.hpp"

#include <algorithm>

namespace beadswim {
namespace {

/// Returns the number of the layer of each coordinate. In sorted order, successive coordinates that differ by
/// at most `thickness` [length] belong to the same layer.
std::vector<int> layers_of(const std::vector<double>& coordinates, double thickness) {
  std::vector<double> sorted = coordinates;
  std::ranges::sort(sorted);
  std::vector<double> starts;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i] - sorted[i - 1] > thickness) starts.push_back(sorted[i]);
  }
  std::vector<int> result;
  for (const double x : coordinates) {
    result.push_back(static_cast<int>(std::ranges::upper_bound(starts, x) - starts.begin()) - 1);
  }
  return result;
}

}  // namespace

std::vector<Layer> swimmer_layers(const Layout& layout) {
  std::vector<Layer> result(layout.swimmers.size());
  for (int a = 0; a < 3; ++a) {
    std::vector<double> coordinates;
    for (const Swimmer& swimmer : layout.swimmers) coordinates.push_back(swimmer.position[a]);
    const std::vector<int> along = layers_of(coordinates, smallest_radius(layout));
    for (std::size_t s = 0; s < result.size(); ++s) result[s][a] = along[s];
  }
  return result;
}

Layer layer_count(std::span<const Layer> layers) {
  Layer count{};
  for (const Layer& layer : layers) {
    for (int a = 0; a < 3; ++a) count[a] = std::max(count[a], layer[a] + 1);
  }
  return count;
}

int block_number(int id, const Layer& layer, std::span<const int> block_swimmers) {
  if (block_swimmers.size() == 1) return id / block_swimmers[0];
  int sum = 0;
  for (int a = 0; a < 3; ++a) sum += layer[a] / block_swimmers[a];
  return sum % 2;
}

}  // namespace beadswim
