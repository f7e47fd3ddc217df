#pragma once

#include <memory>
#include <variant>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// The command line, and the checkpoint from which the run continues.
struct Request {
  RunOptions options;
  std::unique_ptr<CheckpointReader> checkpoint;  ///< nullptr: the run begins at time 0
  long steps_done = 0;                           ///< steps before the checkpoint

  /// Returns the name of the layout in messages.
  std::string source() const { return options.layout == "-" ? "standard input" : options.layout; }
  /// Returns true if the run continues from a checkpoint and writes to the trajectory of the previous run.
  bool continues_same_trajectory() const;
};

/// Parses the command line and opens the checkpoint of --restart. Returns an exit status if the program has
/// only to print --help or --version. Throws InputError on all ranks if the command line or the checkpoint is
/// invalid. Collective.
std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator);

/// Reads the layout from the file of the command line or from the checkpoint. Throws InputError on all ranks
/// if both are given and differ, or if the layout is invalid. Collective.
LayoutDocument read_layout(const Request& request, const Communicator& communicator);

}  // namespace beadswim
