#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "beadswim/run/run_settings.hpp"
#include "beadswim/study/stored_stream.hpp"

// Distribution of the members of a stream over the ranks.

namespace beadswim {

/// Numbers of members, from 1, and the ranks that treat them.
struct StreamSchedule {
  std::vector<int> side_by_side;  ///< treated at the same time, each by a group of ranks
  std::vector<int> on_all_ranks;  ///< large lattices, treated afterwards, one after the other
  int ranks_per_run = 1;          ///< ranks of a group

  int groups(const Communicator& communicator) const { return communicator.size() / ranks_per_run; }
  /// Returns the number of this rank's group, from 0. The last group also has the ranks that are left over.
  int own_group(const Communicator& communicator) const {
    return std::min(communicator.rank() / ranks_per_run, groups(communicator) - 1);
  }
};

/// Returns the schedule of the runs of layouts. `ranks_per_run`: ranks of a group, which then treat all
/// layouts; nullopt: groups are as small as keep all ranks busy. A lattice is large then if all ranks can
/// share its cells, 32^3 or more each, and if its group has too little memory for it, or if its work exceeds
/// the share of a group in the work on all lattices by a quarter. Collective.
StreamSchedule schedule_of(const StoredStream& layouts, const RunSettings& settings,
                           const std::optional<int>& ranks_per_run, const Communicator& communicator);

/// Returns the communicator of the ranks of this rank's group. Collective.
std::unique_ptr<Communicator> group_of(const StreamSchedule& schedule, const Communicator& communicator);

}  // namespace beadswim
