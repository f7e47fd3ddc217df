#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "beadswim/run/run_settings.hpp"
#include "beadswim/study/stream.hpp"

// Work on the members of a stream by groups of ranks.

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

/// A group of ranks that works on a member, and what it asks and tells meanwhile.
struct RankGroup {
  const Communicator& ranks;
  /// Takes the share of the work on the member that is done, from 0 to 1. Called on rank 0 of the group,
  /// often.
  std::function<void(double)> progress;
  /// Returns true, on any rank of the group, if the work on the stream is to stop. All ranks of the group
  /// then agree to leave the member as it is and throw StoppedEarly.
  std::function<bool()> is_to_stop;
};

/// Calls work(member, group) for all members of a stream, collectively for groups of ranks; the result is
/// that of rank 0 of the group. Each group takes the next member that no group has begun. Afterwards all
/// ranks work on large members together. InputError, thrown by all ranks of a group, makes a failure. If one
/// group or idle rank stops, all stop. Returns the tally on all ranks. Throws InputError of sinks.earlier on
/// all ranks. Collective.
StreamTally work_on_ranks(const StoredStream& members, StreamSchedule schedule,
                          const std::function<MemberResult(const StreamMember&, const RankGroup&)>& work,
                          const StreamSinks& sinks, const Communicator& communicator);

}  // namespace beadswim
