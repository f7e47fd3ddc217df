#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/documents/results.hpp"

namespace beadswim {

/// Returns the value of a result of each swimmer in its last cycle that has ended at `time`; nullopt for
/// swimmers without one. `record`: file of the run record; empty: the trajectory has the results. `ids`: of
/// the swimmers. Throws InputError if the result has a value per arm, if no swimmer has a value, or if the
/// record is of another run.
std::vector<std::optional<double>> last_values(ResultQuantity quantity, const std::string& trajectory,
                                               const std::string& record, double time,
                                               const std::vector<int>& ids);

}  // namespace beadswim
