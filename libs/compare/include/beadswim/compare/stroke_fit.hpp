#pragma once

#include <span>

// Least-squares fit of the stroke of one arm, equation (4.1) of the paper (Pickl et al. 2017). See
// docs/method/stroke-fit.md.

namespace beadswim {

/// Arm length L(t) = mean + amplitude cos(w t + phase), where w is the angular frequency.
struct StrokeFit {
  double mean = 0;       ///< mean arm length [length]
  double amplitude = 0;  ///< not negative [length]
  double phase = 0;      ///< in (-pi, pi] [rad]; 0 if the amplitude is zero
};

/// Fits L(t) to equally weighted samples lengths[i] [length] at times[i] [time]. `angular_frequency` is w
/// [rad/time]. The samples should cover one period and include only one of its two ends, because both ends
/// have the same phase. If there are n >= 4 samples at equal intervals, other harmonics that n samples
/// resolve do not affect the fit. Throws InputError in these cases:
///   - there are fewer than 3 samples
///   - times and lengths have different sizes
///   - the times do not determine the three unknowns, for example if all are multiples of half a period
StrokeFit fit_stroke(std::span<const double> times, std::span<const double> lengths,
                     double angular_frequency);

}  // namespace beadswim
