#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// Returns the figure of the errors of velocity and arm amplitudes against the cost in core-seconds, with one
/// point per verdict. The error of a point is the root mean square of all errors of the verdict, relative to
/// the method that determined the verdict or to the method that `methods` names. Throws InputError if a
/// verdict does not contain this method, or if `methods` has more than one name.
Figure verdict_figure(const std::vector<std::string>& files, const std::vector<std::string>& methods);

}  // namespace beadswim
