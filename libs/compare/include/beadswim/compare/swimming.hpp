#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/names.hpp"

// Quantities that are compared between runs and predictions.

namespace beadswim {

enum class ComparedQuantity { velocity, arm_amplitudes, sin_phase_shift, angular_velocity };

template <>
inline constexpr auto name_table<ComparedQuantity> =
    std::to_array<NamedValue<ComparedQuantity>>({{ComparedQuantity::velocity, "velocity"},
                                                 {ComparedQuantity::arm_amplitudes, "arm_amplitudes"},
                                                 {ComparedQuantity::sin_phase_shift, "sin_phase_shift"},
                                                 {ComparedQuantity::angular_velocity, "angular_velocity"}});

/// Quantities that are compared unless others are chosen.
inline constexpr std::array default_quantities{ComparedQuantity::velocity, ComparedQuantity::arm_amplitudes,
                                               ComparedQuantity::sin_phase_shift};

/// Compared quantities of one swimmer, from a run or a prediction. A source may provide only some of them.
///   velocity         { v }         along the swimmer's axis, relative to the mean flow [length/time]
///                    { v, x, y, z }  with its components in the box, if the source knows them
///   arm_amplitudes   { d1, d2, ... }  of equation (4.1) of the paper (Pickl et al. 2017) [length]
///   sin_phase_shift  { sin beta }  beta = delta1 - delta2, the phase of arm 1 ahead of arm 2
///   angular_velocity { |Omega|, x, y, z }  size and components [radian/time]
using ComparedValues = std::map<ComparedQuantity, std::vector<double>>;

/// Returns how many of the numbers of a quantity are compared one by one: all amplitudes, otherwise one.
std::size_t compared_count(ComparedQuantity quantity, const std::vector<double>& values);

/// Returns a number with the vector that it is a component or the size of.
std::vector<double> with_vector(double number, const Vec3& vector);
/// Returns the vector of with_vector(); nullopt for other values.
std::optional<Vec3> vector_of(ComparedQuantity quantity, const std::vector<double>& values);

/// Scales of a swimmer's motion, to which the errors of quantities that should be zero are relative.
struct MotionScale {
  double period = 1;           ///< [time]
  double length = 0;           ///< longest mean arm, or radius of the largest bead [length]
  double speed = 0;            ///< largest speed of a bead [length/time]
  double numerical_error = 0;  ///< error of velocities; 0 if none is stated [length/time]

  /// Returns the scale of a quantity for beads of this speed: their displacement in one radian of the drives
  /// for arm amplitudes, bead_speed/length for angular velocities, 1 for sines.
  double size_of(ComparedQuantity quantity, double bead_speed) const;
};

/// Returns the swimmer's velocity relative to the fluid, projected onto the swimmer's axis [length/time]. The
/// mean flow is subtracted along periodic axes only: along other axes the walls define the frame of
/// reference.
double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

/// Returns all compared quantities, evaluated from one cycle.
ComparedValues evaluate_compared_values(const CycleStatistics& cycle, const std::optional<Box>& box);

/// Returns the arithmetic mean of each quantity over at least one cycle. All cycles contain the same
/// quantities.
ComparedValues average_compared_values(std::span<const ComparedValues> cycles);

}  // namespace beadswim
