#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "beadswim/io/document_stream.hpp"
#include "command_line/request.hpp"

// Runs of a stream of layouts. The ranks form groups; each group runs one layout after the other.

namespace beadswim {

/// The layouts of the command line, on all ranks.
class LayoutStream {
 public:
  /// Reads all layouts on rank 0 and copies them to a temporary file of each rank, so that any rank can read
  /// any layout, and memory does not grow with their number. Throws InputError on all ranks if a file cannot
  /// be read, or if a layout of a stream is invalid. A run that continues from a checkpoint needs no layout.
  /// Collective.
  LayoutStream(const Request& request, const Communicator& communicator);

  /// Returns true if there are several layouts, or one and a trajectory with {} in its name.
  bool is_stream() const { return is_stream_; }
  int size() const { return static_cast<int>(members_.size()); }
  /// Returns the layout with the number `number`, from 1.
  StreamMember member(int number) const;

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  struct Member {
    std::int64_t start = 0;  ///< of the text in the file [byte]
    std::string source;
  };

  void add(const StreamMember& member);

  bool is_stream_ = false;
  std::unique_ptr<std::FILE, CloseFile> file_{};
  std::vector<Member> members_;
  std::int64_t bytes_ = 0;
};

/// Runs all layouts and prints their records in order, one per line. Each record is also written to the file
/// NAME.json beside its trajectory NAME.h5md. A layout whose file holds the record of the same run is not run
/// again. `start`: MPI_Wtime from which --time-limit counts [s]. Throws InputError on all ranks, before work
/// begins, if the command line does not fit a stream. Returns the exit status. Collective.
int run_stream(const LayoutStream& layouts, const Request& request, double start,
               const Communicator& communicator, const Communicator& failures);

}  // namespace beadswim
