#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/document_stream.hpp"

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

}  // namespace beadswim
