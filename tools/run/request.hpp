#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "beadswim/core/communicator.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "options.hpp"

namespace beadswim {

/// The options of the command line, and the checkpoint from which the run continues, if any.
struct Request {
  RunOptions options;
  std::unique_ptr<CheckpointReader> checkpoint;  ///< nullptr: the run begins at time 0

  /// Returns the name of the layout in messages.
  std::string source() const {
    return options.layouts.front() == "-" ? "standard input" : options.layouts.front();
  }
};

/// Parses the command line and opens the checkpoint of --restart. For --help and --version, prints the
/// requested text and returns an exit status. Throws InputError on all ranks if the command line or the
/// checkpoint is invalid. Collective.
std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator);

/// Returns the layout from `given`, the text that the command line names, or from the checkpoint. Throws
/// InputError if the layout is invalid, or if text and checkpoint contain different layouts.
LayoutDocument read_layout(const Request& request, const std::optional<std::string>& given);

}  // namespace beadswim
