#include "beadswim/coupling/close_beads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

CloseBead close_bead(const BeadOnLattice& bead) {
  return {.radius = bead.body.radius,
          .mass = mass(bead.body),
          .inertia = moment_of_inertia(bead.body),
          .velocity = bead.predicted.linear,
          .angular_velocity = bead.predicted.angular,
          .pairs = std::max(1.0, bead.firmness)};
}

void hand_over(BeadOnLattice& bead, const Vec3& linear, const Vec3& angular, double firmness) {
  for (int a = 0; a < 3; ++a) {
    bead.impulse.close_linear[a].add(linear[a]);
    bead.impulse.close_angular[a].add(angular[a]);
  }
  bead.impulse.firmness.add(firmness);
}

/// Whether a point in the unwrapped coordinates of an image lies in the block's own cells.
bool is_own(const Coverage& coverage, const BeadImage& image, const Vec3& point) {
  const Index3 cell = point.array().floor().cast<int>() - image.shift;
  return coverage.is_own(cell[0], cell[1], cell[2]);
}

}  // namespace

LubricationRange lubrication_range(BeadScheme scheme) {
  switch (scheme) {
    case BeadScheme::staircase:
    case BeadScheme::cli:
      return {.normal = 0.65, .tangential = 0.6};
    case BeadScheme::mr:
      return {.normal = 0.6, .tangential = 0.5};
    case BeadScheme::psm:
      return {.normal = 0.6, .tangential = 0.2};
  }
  throw SolverError("unknown bead boundary");
}

NearContactLaw near_contact_law(const CoupledScene& scene) {
  constexpr double collision_steps = 5;  // the least that an implicit step follows
  constexpr double roughness = 1e-3;     // [smallest radius]
  double smallest = std::numeric_limits<double>::infinity();
  for (const SwimmerType& type : scene.types) {
    for (const Bead& bead : type.beads) smallest = std::min(smallest, bead.radius);
  }
  NearContactLaw law{.viscosity = lattice_viscosity(scene.relaxation_time),
                     .range = {},
                     .stiffness_rate = std::numbers::pi / collision_steps,
                     .damping_ratio = 0.5,
                     .friction = scene.friction};
  if (scene.lubrication) {
    law.range = lubrication_range(scene.bead_boundary);
    law.range.smallest = roughness * smallest;
  }
  return law;
}

CloseBeads push_close_beads(const NearContactLaw& law, const Coverage& coverage,
                            std::span<BeadOnLattice> beads) {
  const std::vector<CoveredImage>& images = coverage.images().images;
  const double range = std::max({law.range.normal, law.range.tangential, 0.0});
  CloseBeads found;
  for (const ImagePair& pair : coverage.images().close_pairs) {
    const CoveredImage &a = images[pair.first], &b = images[pair.second];
    BeadOnLattice &first = beads[a.bead], &second = beads[b.bead];
    // Whole numbers between images: the same bits whichever block asks.
    const Vec3 between = (a.image.shift - b.image.shift).cast<double>().matrix();
    const Vec3 separation = second.motion.position - first.motion.position + between;
    const double distance = separation.norm();
    const double gap = distance - first.body.radius - second.body.radius;
    if (!(gap < range)) continue;
    const double to_middle = (first.body.radius + 0.5 * gap) / distance;
    if (!is_own(coverage, a.image, first.motion.position + to_middle * separation)) continue;

    found.smallest_gap = std::min(found.smallest_gap, gap);
    const double smaller = std::min(first.body.radius, second.body.radius);
    const bool is_first = !found.overlap || std::pair(first.name, second.name) <
                                                std::pair(found.overlap->bead, found.overlap->other);
    if (-gap > deepest_overlap * smaller && is_first) {
      found.overlap = Fault{.kind = FaultKind::overlap,
                            .bead = first.name,
                            .other = second.name,
                            .position = first.motion.position,
                            .value = -gap / smaller};
    }
    const PairImpulse impulse =
        near_contact_impulse(law, close_bead(first), close_bead(second), separation, 1);
    hand_over(first, -impulse.linear, impulse.first_angular, impulse.firmness);
    hand_over(second, impulse.linear, impulse.second_angular, impulse.firmness);
  }
  return found;
}

}  // namespace beadswim
