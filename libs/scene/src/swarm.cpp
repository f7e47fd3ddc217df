#include "beadswim/scene/swarm.hpp"

#include <algorithm>

#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Returns the distances along x, y and z between the origins of neighbouring swimmers in one block [length].
Vec3 pitch(const SwarmPlan& plan, const SwimmerType& type) {
  return plan.core_gap + reach_of_centres(type, 0).length() * Vec3::UnitX();
}

/// Calls visit(Vec3(i, j, k)) for each cell of a grid, i fastest.
template <typename Visit>
void for_each_place(const Index3& grid, Visit&& visit) {
  for (int k = 0; k < grid[2]; ++k) {
    for (int j = 0; j < grid[1]; ++j) {
      for (int i = 0; i < grid[0]; ++i) visit(Vec3(i, j, k));
    }
  }
}

}  // namespace

Vec3 block_lengths(const SwarmPlan& plan, const SwimmerType& type) {
  // Along each axis, n swimmers have n - 1 distances within the block, and one distance to the next block.
  const Vec3 last = (plan.block_swimmers - 1).cast<double>().matrix().cwiseProduct(pitch(plan, type));
  return last + reach_of_centres(type, 0).length() * Vec3::UnitX() + plan.block_gap;
}

Box swarm_box(const SwarmPlan& plan, const SwimmerType& type) {
  return {.lengths = block_lengths(plan, type).cwiseProduct(plan.blocks.cast<double>().matrix()),
          .boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
}

std::vector<Swimmer> swarm_swimmers(const SwarmPlan& plan, const SwimmerType& type,
                                    const std::string& type_name) {
  const Vec3 block = block_lengths(plan, type), apart = pitch(plan, type);
  const Vec3 first = plan.block_gap / 2 + reach_of_centres(type, 0).behind * Vec3::UnitX();
  std::vector<Swimmer> swimmers;
  for_each_place(plan.blocks, [&](const Vec3& in_swarm) {
    for_each_place(plan.block_swimmers, [&](const Vec3& in_block) {
      swimmers.push_back({.id = static_cast<int>(swimmers.size()),
                          .type = type_name,
                          .position = block.cwiseProduct(in_swarm) + first + apart.cwiseProduct(in_block)});
    });
  });
  return swimmers;
}

std::vector<Layer> swimmer_layers(const Layout& layout) {
  std::vector<Layer> layers(layout.swimmers.size());
  const double thickness = smallest_radius(layout);
  for (int a = 0; a < 3; ++a) {
    std::vector<double> sorted, starts;  // coordinates; those at which a layer begins
    for (const Swimmer& swimmer : layout.swimmers) sorted.push_back(swimmer.position[a]);
    std::ranges::sort(sorted);
    for (std::size_t i = 0; i < sorted.size(); ++i)
      if (i == 0 || sorted[i] - sorted[i - 1] > thickness) starts.push_back(sorted[i]);
    for (std::size_t s = 0; s < layers.size(); ++s) {
      const auto next = std::ranges::upper_bound(starts, layout.swimmers[s].position[a]);
      layers[s][a] = static_cast<int>(next - starts.begin()) - 1;
    }
  }
  return layers;
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
