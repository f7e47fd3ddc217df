#pragma once

#include "beadswim/collinear/pair_mobility.hpp"

namespace beadswim {

/// Returns d mu / d r by a central difference. The relative error is about (step/r)^2 for a power law, plus
/// rounding errors.
inline double central_difference(PairLaw law, double radius_i, double radius_j, double r, double viscosity) {
  const double step = 1e-5 * r;
  return (law(radius_i, radius_j, r + step, viscosity).value -
          law(radius_i, radius_j, r - step, viscosity).value) /
         (2 * step);
}

}  // namespace beadswim
