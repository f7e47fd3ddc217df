#pragma once

#include <map>
#include <string>
#include <vector>

#include "beadswim/study/stream.hpp"

namespace beadswim {

/// Returns the result of a member as bytes, which a process or a rank sends to another one.
std::string to_bytes(int number, const MemberResult& result);

/// Passes results on in the order of their members. A result that comes before an earlier one waits in a
/// temporary file.
class ResultsInOrder {
 public:
  /// `has_earlier`: for each member whether its result is that of an earlier command; empty: none is.
  explicit ResultsInOrder(const StreamSinks& sinks, std::vector<char> has_earlier = {});

  /// Adds the result of a member, as to_bytes() returns it.
  void add(const std::string& bytes);

  const StreamTally& tally() const { return tally_; }

 private:
  void take(int number, const MemberResult& result);
  void take_available();

  const StreamSinks& sinks_;
  std::vector<char> has_earlier_;
  StoredStream stored_;         ///< results that have waited
  std::map<int, int> waiting_;  ///< their numbers in `stored_`, by member
  StreamTally tally_;
};

}  // namespace beadswim
