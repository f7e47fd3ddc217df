#include "beadswim/scene/gallery.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns value i of a list with one value for all, one value for each, or none.
double nth(const std::vector<double>& list, std::size_t i, double if_none) {
  return list.empty() ? if_none : list.size() == 1 ? list[0] : list[i];
}

double largest_radius(const GallerySwimmer& swimmer) {
  return std::ranges::max(swimmer.radius);
}

constexpr double wide_arm = 5, close_arm = 2.5;  // default distances of centres, divided by the radius
constexpr double swing_over_arm = 0.2;           // default amplitude of a driven length, divided by the arm

double arm_of(const std::optional<double>& arm, double over_radius, const GallerySwimmer& swimmer) {
  return arm.value_or(over_radius * largest_radius(swimmer));
}

double angular_frequency(const GallerySwimmer& swimmer) {
  return 2 * pi / swimmer.period;
}

/// Returns the beads at rest, without bonds.
SwimmerType beads_at(const std::vector<Vec3>& places, const GallerySwimmer& swimmer, const Fluid& fluid) {
  SwimmerType type;
  for (std::size_t b = 0; b < places.size(); ++b)
    type.beads.push_back(
        {{nth(swimmer.radius, b, 0), swimmer.bead_density.value_or(fluid.density)}, places[b]});
  type.driving.period = swimmer.period;
  return type;
}

/// Returns the stiffness of a stiff bond [mass/time^2].
double stiff_bond(const GallerySwimmer& swimmer, const Fluid& fluid) {
  constexpr double ratio = 1000;
  const double drag = 6 * pi * fluid.dynamic_viscosity() * largest_radius(swimmer);
  return ratio * drag * angular_frequency(swimmer);
}

/// Returns the angular stiffness of chains of the length that stay straight [energy].
double stiff_angle(const GallerySwimmer& swimmer, double length, const Fluid& fluid) {
  return stiff_bond(swimmer, fluid) * length * length;
}

void add_bond(SwimmerType& type, int i, int j, double arm, const BondedSwimmer& swimmer, const Fluid& fluid) {
  const double stiffness = swimmer.stiffness.value_or(stiff_bond(swimmer, fluid));
  type.bonds.push_back({{stiffness, arm, swimmer.damping}, {i, j}});
}

/// Drives the rest length of the last bond.
void drive_length(SwimmerType& type, double amplitude, double phase) {
  type.driving.bonds.push_back({.bond = static_cast<int>(type.bonds.size()) - 1,
                                .quantity = BondQuantity::rest_length,
                                .harmonics = {{.amplitude = amplitude, .phase = phase}}});
}

/// Returns beads at these places, with bonds between neighbours and straight angular springs at inner beads.
SwimmerType chain_at(const std::vector<Vec3>& places, double arm, double angular_stiffness,
                     const BondedSwimmer& swimmer, const Fluid& fluid) {
  SwimmerType type = beads_at(places, swimmer, fluid);
  const int beads = static_cast<int>(places.size());
  for (int b = 0; b + 1 < beads; ++b) add_bond(type, b, b + 1, arm, swimmer, fluid);
  for (int b = 0; b + 2 < beads; ++b)
    type.angles.push_back({.beads = {b, b + 1, b + 2}, .stiffness = angular_stiffness});
  return type;
}

/// Returns `beads` places on the x axis at equal distances, with their mean at the origin.
std::vector<Vec3> places_in_line(int beads, double distance) {
  std::vector<Vec3> places;
  for (int b = 0; b < beads; ++b) places.push_back(Vec3((b - (beads - 1) / 2.0) * distance, 0, 0));
  return places;
}

double length_of(const Flagellum& flagellum) {
  return (flagellum.beads - 1) * arm_of(flagellum.arm, close_arm, flagellum);
}

/// Returns 6 pi eta a^2/T for the radius a of a bead, the force that moves it alone by a radius in a period.
double force_of_a_radius(const GallerySwimmer& swimmer, double radius, const Fluid& fluid) {
  return 6 * pi * fluid.dynamic_viscosity() * radius * radius / swimmer.period;
}

}  // namespace

double sperm_number(const Flagellum& flagellum, double angular_stiffness, const Fluid& fluid) {
  const double length = length_of(flagellum);
  const double drag =
      4 * pi * fluid.dynamic_viscosity() / (std::log(length / largest_radius(flagellum)) + 0.5);
  return length * std::pow(drag * angular_frequency(flagellum) /
                               (angular_stiffness * arm_of(flagellum.arm, close_arm, flagellum)),
                           0.25);
}

SwimmerType swimmer_type(const Dumbbell& dumbbell, const Fluid& fluid) {
  const double arm = arm_of(dumbbell.arm, wide_arm, dumbbell);
  SwimmerType type = beads_at(places_in_line(2, arm), dumbbell, fluid);
  add_bond(type, 0, 1, arm, dumbbell, fluid);
  drive_length(type, dumbbell.amplitude.value_or(swing_over_arm * arm), 0);
  return type;
}

SwimmerType swimmer_type(const Triangle& triangle, const Fluid& fluid) {
  const double arm = arm_of(triangle.arm, wide_arm, triangle);
  std::array<double, 3> amplitude{}, side{};  // side k is between beads k and k + 1
  for (int k = 0; k < 3; ++k) {
    amplitude[k] = nth(triangle.amplitude, k, swing_over_arm * arm);
    side[k] = arm - amplitude[k] * std::sin(k * triangle.phase);
  }
  // Place of bead 3 with bead 1 at the origin and bead 2 on the x axis.
  const double x = (side[0] * side[0] + side[2] * side[2] - side[1] * side[1]) / (2 * side[0]);
  const double y = std::sqrt(std::max(side[2] * side[2] - x * x, 0.0));
  const Vec3 mean((side[0] + x) / 3, y / 3, 0);
  SwimmerType type = beads_at({-mean, Vec3(side[0], 0, 0) - mean, Vec3(x, y, 0) - mean}, triangle, fluid);
  for (int k = 0; k < 3; ++k) {
    add_bond(type, k, (k + 1) % 3, arm, triangle, fluid);
    drive_length(type, amplitude[k], -k * triangle.phase);
  }
  return type;
}

SwimmerType swimmer_type(const PrescribedThreeBead& swimmer, const Fluid& fluid) {
  std::array<double, 2> arm{}, amplitude{};
  for (int k = 0; k < 2; ++k) {
    arm[k] = nth(swimmer.arm, k, wide_arm * largest_radius(swimmer));
    amplitude[k] = nth(swimmer.amplitude, k, swing_over_arm * arm[k]);
  }
  const double first = arm[0] + amplitude[0] * std::sin(swimmer.phase);  // length of arm 1 at time 0
  SwimmerType type = beads_at({Vec3(-first, 0, 0), Vec3::Zero(), Vec3(arm[1], 0, 0)}, swimmer, fluid);
  for (int k = 0; k < 2; ++k) {
    add_bond(type, k, k + 1, arm[k], swimmer, fluid);
    drive_length(type, amplitude[k], k == 0 ? swimmer.phase : 0);
  }
  const double straightening = straightening_stiffness(type.bonds[0].stiffness, (arm[0] + arm[1]) / 2);
  type.angles = {{.beads = {0, 1, 2}, .stiffness = swimmer.angular_stiffness.value_or(straightening)}};
  return type;
}

SwimmerType swimmer_type(const PurcellChain& chain, const Fluid& fluid) {
  const int outer_steps = chain.beads_per_link.front() - 1;  // bonds of a link
  const int steps = chain.beads_per_link.back() - 1;
  const double arm = arm_of(chain.arm, close_arm, chain), link = std::max(outer_steps, steps) * arm;
  const bool passes_straight = chain.amplitude >= chain.rest_angle;
  const std::array<double, 2> phase{0, chain.phase};
  std::array<Vec3, 2> outer;  // directions of the outer links at time 0; straight if hinges pass straight
  for (int k = 0; k < 2; ++k) {
    const double bend = passes_straight ? 0 : chain.rest_angle + chain.amplitude * std::sin(phase[k]);
    outer[k] = Vec3(std::cos(bend), std::sin(bend), 0);
  }
  std::vector<Vec3> places;
  for (int b = -outer_steps; b <= steps + outer_steps; ++b) {
    const Vec3 along((std::clamp(b, 0, steps) - steps / 2.0) * arm, 0, 0);
    places.push_back(along + std::min(b, 0) * arm * outer[0] + std::max(b - steps, 0) * arm * outer[1]);
  }
  const double angular_stiffness = chain.angular_stiffness.value_or(stiff_angle(chain, link, fluid));
  SwimmerType type = chain_at(places, arm, angular_stiffness, chain, fluid);
  for (int k = 0; k < 2; ++k) {
    const int angle = outer_steps + k * steps - 1;
    type.angles[angle].rest = chain.rest_angle;
    if (passes_straight) type.angles[angle].normal = k == 0 ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
    type.driving.angles.push_back(
        {.angle = angle, .harmonics = {{.amplitude = chain.amplitude, .phase = phase[k]}}});
  }
  return type;
}

SwimmerType swimmer_type(const Flagellum& flagellum, const Fluid& fluid) {
  const double arm = arm_of(flagellum.arm, close_arm, flagellum);
  // S = S_1/K_A^(1/4), where S_1 is the sperm number for K_A = 1.
  const double ratio = sperm_number(flagellum, 1, fluid) / flagellum.sperm_number;
  const double angular_stiffness = flagellum.angular_stiffness.value_or(std::pow(ratio, 4));
  const double sperm = sperm_number(flagellum, angular_stiffness, fluid);
  // Forces that bend a flexible flagellum would turn a stiff one by about 6/S^3 radian.
  const double reduction = std::min(1.0, std::pow(sperm / 2, 3));
  const double amplitude =
      flagellum.amplitude.value_or(reduction * sperm * angular_stiffness / (2 * length_of(flagellum)));
  constexpr double stretch = 0.01;  // of a bond by the driving forces along it
  BondedSwimmer bonded = flagellum;
  bonded.stiffness =
      flagellum.stiffness.value_or(std::max(stiff_bond(flagellum, fluid), amplitude / (stretch * arm)));
  SwimmerType type = chain_at(places_in_line(flagellum.beads, arm), arm, angular_stiffness, bonded, fluid);
  type.driving.frame = flagellum.frame;
  for (const int end : {1, 2}) {
    type.driving.forces.push_back({.bead = flagellum.beads - end,
                                   .direction = Vec3::UnitY(),
                                   .harmonics = {{.amplitude = end == 1 ? amplitude : -amplitude}}});
  }
  return type;
}

SwimmerType swimmer_type(const TowedSphere& sphere, const Fluid& fluid) {
  SwimmerType type = beads_at({Vec3::Zero()}, sphere, fluid);
  const double force = sphere.force.value_or(force_of_a_radius(sphere, sphere.radius[0], fluid));
  type.driving.forces = {{.bead = 0, .direction = sphere.direction, .constant = force}};
  if (sphere.amplitude != 0) type.driving.forces[0].harmonics = {{.amplitude = sphere.amplitude}};
  type.driving.net_force = NetForce::allowed;
  return type;
}

SwimmerType swimmer_type(const TowedChain& chain, const Fluid& fluid) {
  const double arm = arm_of(chain.arm, close_arm, chain), length = (chain.beads - 1) * arm;
  SwimmerType type =
      chain_at(places_in_line(chain.beads, arm), arm,
               chain.angular_stiffness.value_or(stiff_angle(chain, length, fluid)), chain, fluid);
  const double force = chain.force.value_or(force_of_a_radius(chain, largest_radius(chain), fluid));
  for (int b = 0; b < chain.beads; ++b)
    type.driving.forces.push_back({.bead = b, .direction = chain.direction, .constant = force});
  type.driving.net_force = NetForce::allowed;
  return type;
}

}  // namespace beadswim
