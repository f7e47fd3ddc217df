#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"

// Dimensionless numbers of a scene, and estimates of the motion of its swimmers to first order in the drives,
// in open space, with the Rotne-Prager mobility.

namespace beadswim {

/// Numbers of one swimmer type, evaluated with the driving of the type. The arms are its bonds.
struct TypeNumbers {
  std::optional<double> phase;               ///< of three beads: alpha, bead 3 ahead of bead 1 [radian]
  std::optional<double> reynolds_bead;       ///< largest 2 lambda v / nu of the beads, v: largest speed
  double penetration_depth = 0;              ///< delta = sqrt(2 nu / omega) [length]
  double radius_over_penetration_depth = 0;  ///< lambda / delta with the largest radius lambda
  std::vector<double> arm_over_radius;       ///< l_i / lambda with the mean radius lambda of the arm's beads
  std::vector<double> drag_over_spring;      ///< gamma omega / k_i with gamma = 6 pi eta lambda
  std::vector<double> arm_amplitudes;        ///< d_i [length]; empty: not known
  std::vector<double> arm_gaps;              ///< distance of the surfaces of the arm's beads at rest [length]
  std::optional<std::array<double, 3>> box_over_swimmer_length;  ///< box edges / swimmer length
  /// Largest distance of a bead at the start from its place at rest, of all swimmers of the type [length];
  /// nullopt if none has a driven shape.
  std::optional<double> start_displacement;
  std::optional<double> strain_per_period;               ///< shear rate G of the background flow x period
  std::optional<double> shear_reynolds;                  ///< G lambda^2 / nu with the largest radius lambda
  // With thermal energy; the Peclet number nullopt where the motion to second order is not known
  std::vector<double> thermal_over_spring{};  ///< kT/(k_i l_i^2)
  /// Time in which momentum spreads around the largest bead, divided by the period: lambda^2/(nu T)
  std::optional<double> momentum_time_over_period{};
  std::optional<double> peclet{};  ///< passive_diffusion.hpp

  BEADSWIM_FIELDS((phase, omitted_if_none), (reynolds_bead, omitted_if_none), penetration_depth,
                  radius_over_penetration_depth, arm_over_radius, drag_over_spring,
                  (arm_amplitudes, omitted_if_none), arm_gaps, (box_over_swimmer_length, omitted_if_none),
                  (start_displacement, omitted_if_none), (strain_per_period, omitted_if_none),
                  (shear_reynolds, omitted_if_none), (thermal_over_spring, omitted_if_none),
                  (momentum_time_over_period, omitted_if_none), (peclet, omitted_if_none))
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

  BEADSWIM_FIELDS(cell, time_step, (mach, omitted_if_none), steps_per_period, (cells_in_box, omitted_if_none))
};

/// Numbers of all types, and numbers of the complete scene.
struct SceneNumbers {
  std::map<std::string, TypeNumbers> types;
  double smallest_gap = 0;  ///< smallest gap at rest of beads, images and walls [length]; infinity: none
  /// Smallest height of a bead's centre over the wall of a half-space, relative to the radius of the bead.
  std::optional<double> smallest_relative_height;
  std::optional<ResolutionNumbers> resolution;

  BEADSWIM_FIELDS((smallest_gap, null_if_infinite), (smallest_relative_height, omitted_if_none), types,
                  (resolution, omitted_if_none))
};

/// Returns the motion of a type in open space by Rotne-Prager mobility; nullopt if theory cannot treat it.
std::optional<FirstOrderMotion> predicted_motion(
    const SwimmerType& type, const Fluid& fluid,
    const Eigen::Matrix3d& orientation = Eigen::Matrix3d::Identity());

/// Returns the numbers of a layout. Requires a layout in which check_layout() finds no fault.
SceneNumbers scene_numbers(const Layout& layout);

}  // namespace beadswim
