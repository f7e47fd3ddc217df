#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"

// Dimensionless numbers of a scene, and first-order estimates of the motion of its swimmers.

namespace beadswim {

/// Numbers of one swimmer type, evaluated with the driving of the type. The arms are its bonds. Numbers of
/// the motion are known for the paper's three-bead swimmer only.
struct TypeNumbers {
  std::optional<double> phase;               ///< driving phase alpha, bead 3 ahead of bead 1 [radian]
  std::optional<double> reynolds;            ///< largest 2 lambda v / nu of the beads, v: velocity amplitude
  double penetration_depth = 0;              ///< delta = sqrt(2 nu / omega) [length]
  double radius_over_penetration_depth = 0;  ///< lambda / delta with the largest radius lambda
  std::vector<double> arm_over_radius;       ///< l_i / lambda with the mean radius lambda of the arm's beads
  std::vector<double> drag_over_spring;      ///< gamma omega / k_i with gamma = 6 pi eta lambda
  std::vector<double> arm_amplitude;         ///< d_i to first order with Rotne-Prager mobility [length]
  std::vector<double> arm_gap;               ///< distance of the surfaces of the arm's beads at rest [length]
  std::optional<std::array<double, 3>> box_over_length;  ///< box edges / swimmer length
  /// Largest distance of a bead at the start from its place at rest, of all swimmers of the type [length];
  /// nullopt if none has a driven shape.
  std::optional<double> start_displacement;
  std::optional<double> strain_per_period;               ///< shear rate G of the background flow x period
  std::optional<double> shear_reynolds;                  ///< G lambda^2 / nu with the largest radius lambda

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("phase", numbers.phase, omitted_if_none);
    visit("reynolds_bead", numbers.reynolds, omitted_if_none);
    visit("penetration_depth", numbers.penetration_depth);
    visit("radius_over_penetration_depth", numbers.radius_over_penetration_depth);
    visit("arm_over_radius", numbers.arm_over_radius);
    visit("drag_over_spring", numbers.drag_over_spring);
    visit("arm_amplitudes", numbers.arm_amplitude, omitted_if_none);
    visit("arm_gaps", numbers.arm_gap);
    visit("box_over_swimmer_length", numbers.box_over_length, omitted_if_none);
    visit("start_displacement", numbers.start_displacement, omitted_if_none);
    visit("strain_per_period", numbers.strain_per_period, omitted_if_none);
    visit("shear_reynolds", numbers.shear_reynolds, omitted_if_none);
  }
};

/// Numbers of a resolved run (lattice simulation) with the cells per radius and the relaxation time that the
/// layout suggests.
struct ResolutionNumbers {
  double cell = 0;                                 ///< edge of a cell [length]
  double time_step = 0;                            ///< (tau - 1/2)/3 cell^2/nu [time]
  std::map<std::string, double> steps_per_period;  ///< for each type
  std::optional<double> cells_in_box;
  /// sqrt(3) v time_step / cell, v: speed of the fastest bead of all types; nullopt where a type's is not
  /// known
  std::optional<double> mach;

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("cell", numbers.cell);
    visit("time_step", numbers.time_step);
    visit("mach", numbers.mach, omitted_if_none);
    visit("steps_per_period", numbers.steps_per_period);
    visit("cells_in_box", numbers.cells_in_box, omitted_if_none);
  }
};

/// Numbers of all types, and numbers of the complete scene.
struct SceneNumbers {
  std::map<std::string, TypeNumbers> types;
  double smallest_gap = 0;  ///< smallest gap at rest of beads, images and walls [length]; infinity: none
  /// Smallest height of a bead's centre over the wall of a half-space, relative to the radius of the bead.
  std::optional<double> smallest_relative_height;
  std::optional<ResolutionNumbers> resolution;

  static void visit_fields(auto&& visit, auto& numbers) {
    visit("smallest_gap", numbers.smallest_gap, null_if_infinite);
    visit("smallest_relative_height", numbers.smallest_relative_height, omitted_if_none);
    visit("types", numbers.types);
    visit("resolution", numbers.resolution, omitted_if_none);
  }
};

/// Returns the velocity amplitudes of the three beads to first order in the driving amplitude, with the
/// Rotne-Prager mobility [length/time].
std::array<double, 3> bead_speeds(const CollinearSwimmer& swimmer);

/// Returns the numbers of a layout. Requires a layout in which check_layout() finds no fault.
SceneNumbers scene_numbers(const Layout& layout);

}  // namespace beadswim
