#pragma once

#include <memory>
#include <variant>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "command_line/options.hpp"

namespace beadswim {

/// What a run is asked to do: the command line, and what it goes on from.
struct Request {
  RunOptions options;
  std::unique_ptr<CheckpointReader> checkpoint;  ///< none: it begins anew
  long steps_done = 0;                           ///< by the run that it goes on from

  /// Of the layout, for people.
  std::string source() const { return options.layout == "-" ? "standard input" : options.layout; }
  /// Whether the run goes on under the name that its checkpoint's had.
  bool goes_on_there() const;
};

/// An exit status if --help or --version was all that was asked for. Throws InputError alike on all ranks.
std::variant<Request, int> read_request(int argc, char** argv, const Communicator& communicator);

/// The layout, or the checkpoint's, which a layout that is given must be. Throws InputError alike on all
/// ranks. Collective.
LayoutDocument read_layout(const Request& request, const Communicator& communicator);

}  // namespace beadswim
