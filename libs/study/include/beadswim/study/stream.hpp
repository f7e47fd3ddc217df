#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/document_stream.hpp"

// A stream of work: members, such as the layouts of a study, on which several processes or groups of ranks
// (rank_groups.hpp) work at the same time. Results are taken in the order of the members. A
// member that cannot be treated has a failure document (schemas/failure.schema.json) in place of its result.
//
// The library handles no signal, prints nothing and ends no process. What a program wants to know or to
// decide during the work passes through StreamSinks.

namespace beadswim {

/// All members of a stream in a temporary file. They can be read at any time and in any order, also by
/// several processes after a fork, and memory does not grow with their size.
class StoredStream {
 public:
  StoredStream() = default;
  /// Stores all documents. `check` takes each of them before, and may throw.
  StoredStream(DocumentStream& documents, const std::function<void(const StreamMember&)>& check);

  /// Appends a member, whose number becomes the new size.
  void add(const StreamMember& member);

  int size() const { return static_cast<int>(members_.size()); }
  /// Returns the member with the number `number`, from 1.
  StreamMember member(int number) const;

  /// Gives the members of rank 0 to all ranks, which have none before. Collective.
  void share(const Communicator& communicator);

 private:
  struct Member {
    std::int64_t start = 0;  ///< position of the text in the file [byte]
    std::string source;
  };

  OpenFile file_ = temporary_file();
  std::vector<Member> members_;
  std::int64_t bytes_ = 0;
};

/// Findings about one member, 0 or 1 each, or their sums over all members.
struct Findings {
  int failed = 0;      ///< without result
  int warned = 0;      ///< with warnings
  int incomplete = 0;  ///< a part of the result is missing
  int negative = 0;    ///< with a negative verdict
};

/// Result of the work on one member.
struct MemberResult {
  std::string line;    ///< document of one line
  std::string note{};  ///< text for people; of a failure the reason
  Findings findings{};
};

/// Returns a failure document in place of a result, with the study of the member.
MemberResult failure_of(const StreamMember& member, const std::string& program, const std::string& reason);

/// What a stream asks and tells while it lasts. All functions but `take` may be empty.
struct StreamSinks {
  std::string program;  ///< name for failure documents
  /// Takes the results in the order of the members, each as soon as it and all earlier ones are there. Rank 0
  /// only.
  std::function<void(int number, const MemberResult&)> take;
  /// Returns the result that an earlier command has kept. Members that have one are not worked on. Called for
  /// all members before the work on ranks begins, when it may throw InputError, and again when the result is
  /// taken.
  std::function<std::optional<MemberResult>(int number)> earlier{};
  /// Takes messages such as "3 of 24 layouts done, about 60 s left", every ten seconds. Rank 0 only.
  std::function<void(const std::string&)> progress{};
  /// Returns true if the work on ranks is to stop, for example after a signal to this rank. Any rank.
  std::function<bool()> stop{};
  /// Called inside the catch block of an exception that one rank may have thrown alone. A program with
  /// several ranks must end all of them here. On one rank this function may return; the exception is then
  /// thrown.
  std::function<void()> failure{};
};

/// Outcome of the work on a stream.
struct StreamTally {
  int taken = 0;        ///< number of results that were taken
  Findings findings{};  ///< sums over these results
  bool is_stopped = false;
};

/// Tells how much of a work is done, such as layouts of a stream, and the time left, every ten seconds.
class StreamProgress {
 public:
  using Message = std::function<void(const std::string&)>;

  /// `message`: takes the text; may be empty. `what`: name of the `count` parts of the work.
  StreamProgress(Message message, int count, std::string what = "layouts")
      : message_(std::move(message)), count_(count), what_(std::move(what)) {}

  /// `done`: number of parts that are done; a fraction counts a part that is half done. `before`: number of
  /// parts that were done before this work began; they do not count for the time left.
  void update(double done, int before = 0);

 private:
  using Clock = std::chrono::steady_clock;

  Message message_;
  int count_;
  std::string what_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Calls work(member) for all members of a stream, in `processes` processes on this machine at a time; with
/// one, in this process. An exception but StoppedEarly, or the end of the process of the work, for example
/// for lack of memory, makes a failure.
StreamTally work_in_processes(const StoredStream& members, int processes,
                              const std::function<MemberResult(const StreamMember&)>& work,
                              const StreamSinks& sinks);

/// Returns the number of processors that this process may use.
int usable_processors();

}  // namespace beadswim
