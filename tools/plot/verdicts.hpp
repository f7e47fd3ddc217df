#pragma once

#include <set>
#include <string>
#include <vector>

#include "beadswim/compare/errors_by_setting.hpp"

namespace beadswim {

/// Reads verdicts. Each is a setting with the name of its file: its cost, and the root mean square of all
/// errors of velocity and arm amplitudes, relative to the method that determined the verdict or to the method
/// that `named` names. `drawn`: these methods. Throws InputError if a verdict does not contain the named
/// method or its cost, if `named` has more than one name, or if no verdict compares these quantities.
std::vector<ErrorsOfSetting> read_verdicts(const std::vector<std::string>& files,
                                           const std::vector<std::string>& named,
                                           std::set<std::string>& drawn);

}  // namespace beadswim
