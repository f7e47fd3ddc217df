#include "beadswim/coupling/close_beads.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

CloseBead close_bead(const Bead& body, const BeadVelocity& velocity, double removed_fraction) {
  return {.radius = body.radius,
          .mass = mass(body),
          .inertia = moment_of_inertia(body),
          .velocity = velocity.linear,
          .angular_velocity = velocity.angular,
          .pairs = std::max(1.0, removed_fraction)};
}
CloseBead close_bead(const BeadOnLattice& bead) {
  return close_bead(bead.body, bead.predicted, bead.removed_fraction);
}

void add_close_impulse(BeadOnLattice& bead, const Vec3& linear, const Vec3& angular,
                       double removed_fraction) {
  bead.impulse.close.add(linear, angular);
  bead.impulse.removed_fraction.add(removed_fraction);
}

/// Returns true if a point, in the unwrapped coordinates of an image, lies in the block.
bool is_own(const Coverage& coverage, const BeadImage& image, const Vec3& point) {
  const Index3 cell = point.array().floor().cast<int>() - image.shift;
  return coverage.is_own(cell[0], cell[1], cell[2]);
}

}  // namespace

LubricationRange lubrication_range(BeadScheme scheme, double smallest_radius) {
  constexpr double roughness = 1e-3;  // height of the roughness, divided by the smallest radius
  struct Cutoffs {
    double normal, tangential;
  };
  constexpr std::array<Cutoffs, 4> of_scheme{{{0.65, 0.6}, {0.65, 0.6}, {0.6, 0.5}, {0.6, 0.2}}};
  const auto [normal, tangential] = of_scheme[static_cast<std::size_t>(scheme)];
  return {.normal = normal, .tangential = tangential, .smallest = roughness * smallest_radius};
}

NearContactLaw near_contact_law(const CoupledScene& scene) {
  // Duration of a collision of two beads [step]. In a shorter collision, an implicit time step would not
  // follow the contact spring.
  constexpr double collision_steps = 2;
  double smallest = std::numeric_limits<double>::infinity();
  for (const SwimmerType& type : scene.types) smallest = std::min(smallest, smallest_radius(type));
  NearContactLaw law{.viscosity = lattice_viscosity(scene.relaxation_time),
                     .range = {},
                     .stiffness_rate = std::numbers::pi / collision_steps,
                     .damping_ratio = 0.5,
                     .friction = scene.friction,
                     .contact_cutoff = 2 * speed_limit};
  if (scene.lubrication) law.range = lubrication_range(scene.bead_boundary, smallest);
  return law;
}

CloseBeads add_contact_impulses(const NearContactLaw& law, const Coverage& coverage,
                                std::span<BeadOnLattice> beads) {
  const std::vector<CoveredImage>& images = coverage.images().images;
  CloseBeads found;
  for (const ImagePair& pair : coverage.images().close_pairs) {
    const CoveredImage &a = images[pair.first], &b = images[pair.second];
    BeadOnLattice &first = beads[a.bead], &second = beads[b.bead];
    // The shift between images is an integer, so that every block gets the same bits.
    const Vec3 between = (a.image.shift - b.image.shift).cast<double>().matrix();
    const Vec3 separation = second.motion.position - first.motion.position + between;
    const double distance = separation.norm();
    const double gap = distance - first.body.radius - second.body.radius;
    if (!(gap < law.cutoff())) continue;
    const double to_middle = distance > 0 ? (first.body.radius + 0.5 * gap) / distance : 0;
    if (!is_own(coverage, a.image, first.motion.position + to_middle * separation)) continue;

    found.smallest_gap = std::min(found.smallest_gap, gap);
    const double smaller_radius = std::min(first.body.radius, second.body.radius);
    if (-gap > max_overlap * smaller_radius) {  // the fault stops the run
      keep_first(found.overlap, {.kind = FaultKind::overlap,
                                 .bead = first.name,
                                 .other = second.name,
                                 .position = first.motion.position,
                                 .value = -gap / smaller_radius});
      continue;
    }
    if (first.name.swimmer == second.name.swimmer && between == Vec3::Zero()) continue;
    const PairImpulse impulse =
        near_contact_impulse(law, close_bead(first), close_bead(second), separation, 1);
    add_close_impulse(first, -impulse.linear, impulse.first_angular, impulse.removed_fraction);
    add_close_impulse(second, impulse.linear, impulse.second_angular, impulse.removed_fraction);
  }
  return found;
}

void add_swimmer_contact_impulses(const NearContactLaw& law, const SwimmerType& type, SwimmerState& swimmer,
                                  SwimmerLoads& impulses) {
  std::vector<CloseBead> beads;
  std::vector<Vec3> positions;
  for (std::size_t b = 0; b < type.beads.size(); ++b) {
    const Bead& body = type.beads[b];
    BeadVelocity velocity = swimmer.predicted[b];
    velocity.linear += impulses[b].force / mass(body);
    velocity.angular += impulses[b].torque / moment_of_inertia(body);
    beads.push_back(close_bead(body, velocity, swimmer.removed_fraction[b]));
    positions.push_back(swimmer.motion[b].position);
  }
  const SwimmerContact contact = swimmer_contact(law, beads, positions, 1);
  for (std::size_t b = 0; b < beads.size(); ++b) {
    impulses[b].force += contact.linear[b];
    impulses[b].torque += contact.angular[b];
    swimmer.removed_fraction[b] += contact.removed_fraction[b];
  }
}

}  // namespace beadswim
