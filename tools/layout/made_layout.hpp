#pragma once

#include <CLI/CLI.hpp>
#include <set>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

// The key made_by of layouts: the command that made a layout, with the values of its flags. From these the
// layout can be made again.

namespace beadswim {

/// Returns the record of the command line of a command that makes layouts: { "command", "parameters" }.
Json made_by_record(const CLI::App& program);

/// A layout with the record of the command that makes it.
struct MadeLayout {
  Layout layout;
  Json made_by;
};

/// Returns the layout that the command of the record makes. Throws InputError if the record is invalid, or
/// the error of the command. `source`: name of the layout for messages.
MadeLayout made_layout(const Json& made_by, const std::string& source);

/// Returns the names of the flags of a command that makes layouts; empty if there is no such command. Without
/// a command, returns the names of the flags of all of them.
std::set<std::string> parameter_names(const std::string& command = "");

}  // namespace beadswim
