#pragma once

#include <memory>
#include <string>
#include <variant>

#include "beadswim/core/communicator.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/study/stream.hpp"
#include "options.hpp"

namespace beadswim {

constexpr const char* number_mark = "{}";  ///< in --output: place of the number of a layout

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

/// The layouts of the command line; none for a run that continues from a checkpoint without naming a layout.
struct GivenLayouts {
  StoredStream layouts;
  bool is_stream = false;  ///< several layouts, or one and a trajectory with {} in its name
};

/// Returns the layouts on all ranks. Throws InputError on all ranks if a file cannot be read, or if a layout
/// of a stream is invalid. Collective.
GivenLayouts read_layouts(const Request& request, const Communicator& communicator);

/// Returns the layout of a single run from the command line or from the checkpoint. Throws InputError if the
/// layout is invalid, or if command line and checkpoint contain different layouts.
LayoutDocument read_layout(const Request& request, const StoredStream& layouts);

}  // namespace beadswim
