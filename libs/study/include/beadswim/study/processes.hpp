#pragma once

#include "beadswim/study/stream.hpp"

namespace beadswim {

/// Calls work(member) for all members of a stream, in `processes` processes on this machine at a time; with
/// one, in this process. An exception but StoppedEarly, or the end of the process of the work, for example
/// for lack of memory, makes a failure.
StreamTally work_in_processes(const StoredStream& members, int processes,
                              const std::function<MemberResult(const StreamMember&)>& work,
                              const StreamSinks& sinks);

/// Returns the number of processors that this process may use.
int usable_processors();

}  // namespace beadswim
