#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// The candidate that was probably meant by `name`, or empty if none is near. Near is what can be made of
/// `name` by few insertions, deletions, substitutions and swaps of neighbours, as a whole or as a part of the
/// candidate ("viscosty" of "kinematic_viscosity"). Of several, the one with the fewest.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// How a message about an unknown name goes on: "; did you mean \"NEAREST\"?", or "." if none is near.
std::string guess_at(const std::string& name, const std::vector<std::string>& candidates);

/// "unknown \"NAME\"", the nearest of `allowed` if there is one, and all of them.
std::string unknown_name(const std::string& name, const std::vector<std::string>& allowed);

}  // namespace beadswim
