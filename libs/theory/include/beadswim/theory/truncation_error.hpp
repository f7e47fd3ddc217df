#pragma once

#include <optional>

#include "beadswim/theory/collinear_swimmer.hpp"

namespace beadswim {

/// Smallest distance of neighbouring beads at rest over the mean of their two radii: l/lambda for equal
/// beads and arms, 2 for touching ones.
double separation_ratio(const CollinearSwimmer& swimmer);

/// Velocity of second-order Rotne-Prager theory over that of exact Stokes flow, by interpolation of
/// three-sphere multipole results for equal beads and arms at separation ratios 3 to 20, and by its
/// power law beyond. None below 3, where no reference is known.
std::optional<double> rotne_prager_over_exact(double separation_ratio);

/// Relative change of the velocity that second order in amplitude leaves out, about 0.3 (d1^2 + d2^2) / l^2.
double finite_amplitude_change(const CollinearSwimmer& swimmer, const std::array<double, 2>& arm_amplitudes);

}  // namespace beadswim
