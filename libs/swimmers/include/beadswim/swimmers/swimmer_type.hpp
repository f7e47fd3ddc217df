#pragma once

#include <array>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"

// Parameters of a three-bead swimmer, section 2 of the paper (Pickl et al. 2017). Quantities are in any
// coherent unit system: the units of the layout in layouts and theory, lattice units inside a resolved run.

namespace beadswim {

/// Direction of the driving forces, equation (2.1) of the paper.
enum class DrivingFrame {
  lab,           ///< direction x of the external field, for every orientation of the swimmer
  initial_axis,  ///< axis of each swimmer at the start of the run
  body,          ///< along the present directions of the arms; total force and total torque vanish
};

template <>
inline constexpr auto name_table<DrivingFrame> = std::to_array<NamedValue<DrivingFrame>>(
    {{DrivingFrame::lab, "lab"}, {DrivingFrame::initial_axis, "initial-axis"}, {DrivingFrame::body, "body"}});

struct Bead {
  double radius = 0;   ///< [length]
  double density = 0;  ///< [mass/length^3]

  static void visit_fields(auto&& visit, auto& bead) {
    visit("radius", bead.radius);
    visit("density", bead.density);
  }
};

struct Spring {
  double stiffness = 0;    ///< k [mass/time^2]
  double rest_length = 0;  ///< l, distance of the bead centres [length]
  double damping = 0;      ///< c of the dashpot parallel to the spring [mass/time]; 0: no dashpot

  static void visit_fields(auto&& visit, auto& spring) {
    visit("stiffness", spring.stiffness);
    visit("rest_length", spring.rest_length);
    visit("damping", spring.damping);
  }
};

/// Driving forces on beads 1, 2, 3, equation (2.1) of the paper:
///   F1 = A sin(w t + phi)
///   F2 = -(F1 + F3)
///   F3 = B sin(w t + alpha + phi)
/// t is the time and w the angular frequency. phi is 0 in the paper. In a swarm, phi can differ between
/// swimmers.
struct Driving {
  std::array<double, 2> amplitude{};  ///< A on bead 1, B on bead 3 [mass length/time^2]
  double phase = 0;                   ///< alpha [radian]
  double period = 0;                  ///< T = 2 pi / w [time]
  DrivingFrame frame = DrivingFrame::lab;
  double phase_offset = 0;  ///< phi [radian]

  bool operator==(const Driving&) const = default;

  static void visit_fields(auto&& visit, auto& driving) {
    visit("amplitude", driving.amplitude);
    visit("phase", driving.phase);
    visit("period", driving.period);
    visit("frame", driving.frame);
    visit("phase_offset", driving.phase_offset, omitted_if_zero);
  }
};

/// Beads 1, 2, 3 in a line. springs[0] joins beads 1 and 2, and springs[1] joins beads 2 and 3.
struct SwimmerType {
  std::array<Bead, 3> beads;
  std::array<Spring, 2> springs;
  double angular_stiffness = 0;  ///< K_A of U = K_A theta^2/2, theta: angle between the arms [energy]
  Driving driving;

  static void visit_fields(auto&& visit, auto& type) {
    visit("beads", type.beads);
    visit("springs", type.springs);
    visit("angular_stiffness", type.angular_stiffness);
    visit("driving", type.driving);
  }
};

}  // namespace beadswim
