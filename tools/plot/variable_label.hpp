#pragma once

#include <string>

#include "beadswim/figure/figure.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Returns the label of a quantity of a study, with its unit: "period" of /types/a/driving/period, "radius,
/// bead 2" of /types/a/beads/1/radius. Returns the name itself for flags and for unknown pointers; the unit
/// of unknown quantities is empty.
AxisLabel variable_label(const std::string& name, const Units& units);

}  // namespace beadswim
