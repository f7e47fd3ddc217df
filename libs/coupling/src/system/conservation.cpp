#include "beadswim/coupling/conservation.hpp"

#include <algorithm>

#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {
namespace {

/// Largest permitted changes of the momentum, divided by the momentum of all beads at their largest speed,
/// and of the mass, divided by the mass of the fluid.
struct Limits {
  double momentum, mass;
};
constexpr Limits limits(Precision precision) {
  return precision == Precision::fp64 ? Limits{.momentum = 1e-6, .mass = 1e-9}
                                      : Limits{.momentum = 0.05, .mass = 1e-5};
}

double mass_of_beads(const CoupledScene& scene) {
  double sum = 0;
  for (const PlacedSwimmer& swimmer : scene.swimmers) {
    for (const Bead& bead : scene.type_of(swimmer).beads) sum += mass(bead);
  }
  return sum;
}

}  // namespace

std::optional<Fault> conservation_fault(const CoupledScene& scene, const SceneTotals& first,
                                        const SceneTotals& now, double bead_speed) {
  const Limits limit = limits(scene.precision);
  const double lost_mass = std::abs(now.mass_excess - first.mass_excess);
  if (!(lost_mass <= limit.mass)) return Fault{.kind = FaultKind::mass, .value = lost_mass};

  const bool periodic =
      std::ranges::all_of(scene.boundary, [](Boundary ends) { return ends == Boundary::periodic; });
  constexpr double slowest = 1e-9;  // lower bound; avoids a division by zero for beads at rest [cell/step]
  const double scale = mass_of_beads(scene) * std::max(bead_speed, slowest);
  const double gained = (now.momentum - first.momentum).norm() / scale;
  if (periodic && !(gained <= limit.momentum)) return Fault{.kind = FaultKind::momentum, .value = gained};
  return std::nullopt;
}

}  // namespace beadswim
