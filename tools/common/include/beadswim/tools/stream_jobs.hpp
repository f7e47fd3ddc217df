#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "beadswim/io/document_stream.hpp"

// Work on the documents of a stream, in several processes.

namespace beadswim {

/// Result of the work on one document. A program gives `state` its own meaning.
struct MemberResult {
  std::string text;
  int state = 0;
};

/// Calls work(member) for all documents of a stream, in `jobs` processes at a time, and then take(member,
/// result) in this process, in the order of the stream. The result is nullopt if the process of the work
/// ended, for example for lack of memory. At most 4 x jobs results wait for an earlier one. `work` must not
/// throw; with one job it runs in this process.
void for_each_member(
    DocumentStream& stream, int jobs, const std::function<MemberResult(const StreamMember&)>& work,
    const std::function<void(const StreamMember&, const std::optional<MemberResult>&)>& take);

/// Returns the number of processors that this process may use.
int usable_processors();

/// Prints on standard error how much of a work is done, such as layouts of a stream, and the time left, every
/// ten seconds.
class StreamProgress {
 public:
  /// `what`: name of the `count` parts of the work.
  StreamProgress(std::string program, int count, std::string what = "layouts")
      : program_(std::move(program)), count_(count), what_(std::move(what)) {}

  /// `done`: number of parts that are done; a fraction counts a part that is half done. `before`: number of
  /// parts that were done before this work began; they do not count for the time left.
  void update(double done, int before = 0);

 private:
  using Clock = std::chrono::steady_clock;

  std::string program_;
  int count_;
  std::string what_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace beadswim
