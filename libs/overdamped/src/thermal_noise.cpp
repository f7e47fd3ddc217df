#include "thermal_noise.hpp"

#include <cmath>

#include "beadswim/core/keyed_random.hpp"

namespace beadswim {
namespace {

enum class NoisePurpose : std::uint64_t { root, divergence };

std::uint64_t seed_of(const OverdampedScene& scene, long step, NoisePurpose purpose) {
  return KeyedRandom(scene.seed, static_cast<std::uint64_t>(step), static_cast<std::uint64_t>(purpose))
      .bits();
}

bool has_divergence(const OverdampedScene& scene) {
  return scene.domain.half_space || mirror_count(scene.domain.box) > 0 ||
         scene.model == MobilityModel::rpy_near || highest_moment(scene) > 0;
}

/// Returns the length d of the random finite differences: products of relative error E are as accurate as
/// differences of second order for d = E^(1/3) times the length over which the mobility changes.
double difference_length(const StepScene& scene, const Beads& positions) {
  double length = scene.smallest_radius;
  for (std::size_t b = 0; b < positions.size() && scene.scene.domain.half_space; ++b)
    length = std::min(length, scene.scene.domain.half_space->height(positions[b]));
  return std::cbrt(scene.scene.tolerance) * length;
}

}  // namespace

ThermalNoise thermal_noise(const StepScene& scene, Mobility& mobility, MobilityRoot& root,
                           const Beads& positions, long steps_done) {
  const OverdampedScene& swarm = scene.scene;
  const std::size_t beads = positions.size();
  ThermalNoise noise;
  if (has_divergence(swarm)) {
    const double d = difference_length(scene, positions);
    const std::uint64_t seed = seed_of(swarm, steps_done, NoisePurpose::divergence);
    Beads W;
    for (std::size_t b = 0; b < beads; ++b) W.push_back(KeyedRandom(seed, b, 0).normal3());
    Beads ahead = positions, behind = positions, fast(beads), slow(beads);
    flat(ahead) += d / 2 * flat(W);
    flat(behind) -= d / 2 * flat(W);
    mobility.set_positions(ahead);
    noise.work.add(mobility.apply(W, fast));
    mobility.set_positions(behind);
    noise.work.add(mobility.apply(W, slow));
    noise.velocities = fast;
    flat(noise.velocities) = swarm.thermal_energy / d * (flat(fast) - flat(slow));
  }
  RootProduct product = root.at(positions, seed_of(swarm, steps_done, NoisePurpose::root));
  flat(product.velocities) *= std::sqrt(2 * swarm.thermal_energy / swarm.step);
  if (!noise.velocities.empty()) flat(product.velocities) += flat(noise.velocities);
  noise.velocities = std::move(product.velocities);
  noise.work.add(product.work);
  noise.error = product.error;
  noise.is_converged = product.is_converged;
  return noise;
}

}  // namespace beadswim
