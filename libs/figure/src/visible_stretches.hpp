#pragma once

#include <vector>

#include "svg.hpp"

namespace beadswim {

/// Points connected by an uninterrupted line.
using Stretch = std::vector<svg::Point>;

/// Clips the line through `points` to the range between `top` and `bottom` [px], with y downwards. Returns
/// the visible parts. The line is interrupted at non-finite points. It is also interrupted between two
/// consecutive points outside the range: if they are on opposite sides, they indicate a pole, which the line
/// must not cross.
std::vector<Stretch> visible_stretches(const std::vector<svg::Point>& points, double top, double bottom);

}  // namespace beadswim
