#pragma once

#include <memory>
#include <variant>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// The options of the command line, and the checkpoint from which the run continues, if any.
struct Request {
  RunOptions options;
  std::unique_ptr<CheckpointReader> checkpoint;  ///< nullptr: the run begins at time 0
  long steps_done = 0;                           ///< number of time steps before the checkpoint

  /// Returns the name of the layout in messages.
  std::string source() const { return options.layout == "-" ? "standard input" : options.layout; }
  /// Returns true if the run continues from a checkpoint and writes to the trajectory of the earlier run.
  bool continues_same_trajectory() const;
};

/// Parses the command line and opens the checkpoint of --restart. For --help and --version, prints the
/// requested text and returns an exit status. Throws InputError on all ranks if the command line or the
/// checkpoint is invalid. Collective.
std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator);

/// Reads the layout from the file that the command line names, or from the checkpoint. Throws InputError on
/// all ranks if the layout is invalid, or if file and checkpoint contain different layouts. Collective.
LayoutDocument read_layout(const Request& request, const Communicator& communicator);

}  // namespace beadswim
