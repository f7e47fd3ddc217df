#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/tools/named_flags.hpp"

// Flags that several kinds of figures share, and flags whose values need their own parser.

namespace beadswim {

/// A name that is written beside a swimmer in the figure.
struct SwimmerMark {
  std::string name;
  int id = 0;
};

/// Adds the flag --method, which selects the methods whose predictions are drawn.
void add_methods(CLI::App& command, std::vector<std::string>& methods);

/// Adds the flag --cycle, which selects the cycles of runs that are drawn.
void add_cycle(CLI::App& command, std::string& cycle);

/// Adds a flag whose value is a list of whole numbers >= 0, joined by commas. `unless_given`: text for the
/// default in the help.
CLI::Option* add_whole_numbers(CLI::App& command, const std::string& flag, std::vector<int>& numbers,
                               const std::string& unless_given, const std::string& help);

/// Adds the flag --frame, which selects a frame of a trajectory. `frame` is nullopt for the last frame.
void add_frame(CLI::App& command, std::optional<std::size_t>& frame);

/// Adds the flag --mark, which lists names to write beside swimmers.
void add_marks(CLI::App& command, std::vector<SwimmerMark>& marks);

}  // namespace beadswim
