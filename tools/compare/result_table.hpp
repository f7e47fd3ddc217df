#pragma once

#include <optional>
#include <string>
#include <vector>

namespace beadswim {

/// Returns the results of swimmers in all their cycles as comma-separated values: names of the columns with
/// their units, then a line per swimmer and cycle. Columns are empty where a file does not state the result.
/// Several runs have columns that name them and the quantities of their studies.
///   files    run records, streams of them, trajectories; failures are left out, and counted on standard
///   error swimmer  id of the only swimmer in the table; nullopt: all swimmers
/// Throws InputError if a file is invalid, if a run has failed or lacks the swimmer, if there is no cycle, or
/// if units differ.
std::string result_table(const std::vector<std::string>& files, std::optional<int> swimmer);

}  // namespace beadswim
