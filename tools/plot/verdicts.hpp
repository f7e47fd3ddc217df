#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// Returns the figure of the errors of velocity and arm amplitudes as functions of the core-seconds, with one
/// point per verdict: the root mean square of its errors relative to the method that determined the verdict,
/// or to the method that `methods` names. Throws InputError if a file has no such verdict, or if `methods`
/// has more than one name.
Figure verdict_figure(const std::vector<std::string>& files, const std::vector<std::string>& methods);

}  // namespace beadswim
