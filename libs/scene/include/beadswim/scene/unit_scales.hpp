#pragma once

#include <string>

#include "beadswim/scene/layout.hpp"

// Conversion of a layout to other units: to lattice units in resolved runs, to natural units in mobility runs
// and theory.

namespace beadswim {

/// Units of a calculation in the units of the layout.
struct UnitScales {
  double length = 1;   ///< [length]
  double time = 1;     ///< [time]
  double density = 1;  ///< [mass/length^3]

  double velocity() const { return length / time; }
  double mass() const { return density * length * length * length; }
  double momentum() const { return mass() * velocity(); }
  double force() const { return momentum() / time; }
  double body_force() const { return force() / (length * length * length); }
  double stiffness() const { return mass() / (time * time); }
  double damping() const { return mass() / time; }
  double energy() const { return mass() * velocity() * velocity(); }
  double viscosity() const { return damping() / length; }
  double power() const { return energy() / time; }
};

/// Return a type or a layout in these units. The layout keeps its `units`, for messages and figures.
SwimmerType in_units(SwimmerType type, const UnitScales& units);
Layout in_units(Layout layout, const UnitScales& units);

/// Returns units in which the smallest radius, the base period and the dynamic viscosity are between 1/2
/// and 2. They are powers of 4, so that the conversion and square roots are exact: results have the same bits
/// in all units of a layout that differ by powers of 4.
UnitScales natural_units(const Layout& layout);

/// Returns why quantities of a layout are outside the range of valid results; empty if none is.
std::string range_fault(const Layout& layout);

}  // namespace beadswim
