#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"

// The dimensionless numbers of a scene, and first-order estimates of what its swimmers will do.

namespace beadswim {

/// One type of swimmer, driven as its type is.
struct TypeNumbers {
  double reynolds = 0;           ///< 2 lambda v / nu of the fastest bead, v the amplitude of its velocity
  double penetration_depth = 0;  ///< delta = sqrt(2 nu / omega) [length]
  double radius_over_penetration_depth = 0;  ///< lambda / delta, lambda the largest radius
  std::array<double, 2> arm_over_radius{};   ///< l_i / lambda, lambda the mean radius of the arm's beads
  std::array<double, 2> drag_over_spring{};  ///< gamma omega / k_i, gamma = 6 pi eta lambda
  std::array<double, 2> arm_amplitude{};     ///< d_i to first order in A, B with Rotne-Prager pairs [length]
  std::array<double, 2> arm_gap{};           ///< between the surfaces of the arm's beads at rest [length]
  std::optional<std::array<double, 3>> box_over_length;  ///< box edges over the swimmer's length

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("reynolds_bead", numbers.reynolds);
    visit("penetration_depth", numbers.penetration_depth);
    visit("radius_over_penetration_depth", numbers.radius_over_penetration_depth);
    visit("arm_over_radius", numbers.arm_over_radius);
    visit("drag_over_spring", numbers.drag_over_spring);
    visit("arm_amplitudes", numbers.arm_amplitude);
    visit("arm_gaps", numbers.arm_gap);
    visit("box_over_swimmer_length", numbers.box_over_length, omitted_if_none);
  }
};

/// What the layout's hint means in a resolved run.
struct ResolutionNumbers {
  double cell = 0;                                 ///< [length]
  double time_step = 0;                            ///< (tau - 1/2)/3 cell^2/nu [time]
  std::map<std::string, double> steps_per_period;  ///< of each type
  std::optional<double> cells_in_box;
  double mach = 0;  ///< of the fastest bead of any type: v sqrt(3) time_step / cell

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("cell", numbers.cell);
    visit("time_step", numbers.time_step);
    visit("mach", numbers.mach);
    visit("steps_per_period", numbers.steps_per_period);
    visit("cells_in_box", numbers.cells_in_box, omitted_if_none);
  }
};

struct SceneNumbers {
  std::map<std::string, TypeNumbers> types;
  double smallest_gap = 0;  ///< between any two surfaces at rest: beads, images, walls [length]
  std::optional<ResolutionNumbers> resolution;

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("smallest_gap", numbers.smallest_gap);
    visit("types", numbers.types);
    visit("resolution", numbers.resolution, omitted_if_none);
  }
};

/// Amplitudes of the three beads' velocities to first order, v = mu F, by Rotne-Prager pairs [length/time].
std::array<double, 3> bead_speeds(const CollinearSwimmer& swimmer);

/// The numbers of a layout that check_layout finds no fault with.
SceneNumbers scene_numbers(const Layout& layout);

}  // namespace beadswim
