#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// Errors of velocity and of arm amplitudes against core-seconds, a point for each verdict of the files: the
/// root mean square of the errors that it found by its deciding method, or by the one named. Throws
/// InputError.
Figure verdict_figure(const std::vector<std::string>& files, const std::vector<std::string>& methods);

}  // namespace beadswim
