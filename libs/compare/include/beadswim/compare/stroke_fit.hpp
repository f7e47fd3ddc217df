#pragma once

#include <span>

// The stroke of one arm (4.1). See docs/method/stroke-fit.md.

namespace beadswim {

/// L(t) = mean + amplitude cos(w t + phase).
struct StrokeFit {
  double mean = 0;       ///< [length]
  double amplitude = 0;  ///< d >= 0 [length]
  double phase = 0;      ///< delta in (-pi, pi]; 0 if the amplitude vanishes [radian]
};

/// Least squares of (4.1) over samples lengths[i] at times[i], equally weighted; angular_frequency is w = 2
/// pi/T. Samples should tile one period (both ends would count the seam twice); at n >= 4 uniform samples the
/// fit is blind to every harmonic that n resolves. Throws InputError for fewer than 3 samples, unequal sizes,
/// or times that do not determine the three unknowns (for instance all at multiples of half a period).
StrokeFit fit_stroke(std::span<const double> times, std::span<const double> lengths,
                     double angular_frequency);

}  // namespace beadswim
