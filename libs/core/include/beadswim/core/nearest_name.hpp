#pragma once

#include <string>
#include <vector>

namespace beadswim {

/// The candidate with the smallest edit distance to `name` (insertions, deletions, substitutions and
/// swaps of neighbours count one each); empty if `candidates` is empty.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace beadswim
