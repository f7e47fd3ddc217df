#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// Returns the candidate that a misspelt `name` probably stands for, or an empty text if there is none. A
/// candidate qualifies if few insertions, deletions, substitutions and swaps of adjacent letters turn `name`
/// into the candidate or into a part of it (for example "viscosty" into a part of "kinematic_viscosity"). If
/// several candidates qualify, returns the candidate with the fewest such changes.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// Returns the end of a message about an unknown name: "; did you mean \"NEAREST\"?", or "." if
/// nearest_name() finds no candidate.
std::string format_suggestion(const std::string& name, const std::vector<std::string>& candidates);

/// Returns the message "unknown value \"NAME\"", followed by the nearest allowed name, if there is one, and
/// by all `allowed` names.
std::string format_unknown_name(const std::string& name, const std::vector<std::string>& allowed);

}  // namespace beadswim
