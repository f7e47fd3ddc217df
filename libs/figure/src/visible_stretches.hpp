#pragma once

#include <vector>

#include "svg.hpp"

namespace beadswim {

/// Points joined by a line without a break.
using Stretch = std::vector<svg::Point>;

/// The parts between heights `top` and `bottom` of the line through `points`, in px, y downwards. The line
/// breaks at points that are not finite, and between two points beyond the ends: on opposite sides they mark
/// a pole, which no line should cross.
std::vector<Stretch> visible_stretches(const std::vector<svg::Point>& points, double top, double bottom);

}  // namespace beadswim
