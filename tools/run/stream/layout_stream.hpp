#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/temporary_file.hpp"
#include "beadswim/io/document_stream.hpp"
#include "request.hpp"

// The layouts of the command line, on all ranks.

namespace beadswim {

constexpr const char* number_mark = "{}";  ///< in --output: place of the number of a layout

/// Throws InputError on all ranks if `fault`, the message of rank 0, is not empty. Collective.
void throw_together(std::string fault, const Communicator& communicator);

/// Reads the layouts on rank 0, and passes them to all ranks one by one.
class LayoutStream {
 public:
  /// Throws InputError on all ranks if a file cannot be read, or if a layout of a stream is invalid. A run
  /// that continues from a checkpoint needs no layout. Collective.
  LayoutStream(const Request& request, const Communicator& communicator);

  /// Returns true if there are several layouts, or one and a trajectory with {} in its name.
  bool is_stream() const { return is_stream_; }

  /// Returns the next layout on all ranks; nullopt at the end. Collective.
  std::optional<StreamMember> next();

 private:
  const Communicator& communicator_;
  std::optional<DocumentStream> documents_;  ///< nullopt on other ranks than rank 0
  bool is_stream_ = false;
};

/// All layouts of a stream in a temporary file of each rank. Any rank can read any of them at any time, and
/// memory does not grow with their size.
class StoredLayouts {
 public:
  explicit StoredLayouts(LayoutStream& layouts);  ///< collective

  int size() const { return static_cast<int>(members_.size()); }
  /// Returns the layout with the number `number`, from 1.
  StreamMember member(int number) const;

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
