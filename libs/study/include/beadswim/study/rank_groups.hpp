#pragma once

#include "beadswim/study/stream.hpp"
#include "beadswim/study/stream_schedule.hpp"

namespace beadswim {

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
