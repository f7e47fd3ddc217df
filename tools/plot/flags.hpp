#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/tools/named_flags.hpp"

// Flags that several kinds of figures share, and flags whose values need their own parser.

namespace beadswim {

/// A name that is written at a swimmer.
struct SwimmerMark {
  std::string name;
  int id = 0;
};

/// Adds --method.
void add_methods(CLI::App& command, std::vector<std::string>& methods);

/// Adds --cycle.
void add_cycle(CLI::App& command, std::string& cycle);

/// Adds a flag for a list of whole numbers >= 0, separated by commas. The help shows `unless_given` as the
/// default.
CLI::Option* add_whole_numbers(CLI::App& command, const std::string& flag, std::vector<int>& numbers,
                               const std::string& unless_given, const std::string& help);

/// Adds --frame. `frame` has no value for the last frame.
void add_frame(CLI::App& command, std::optional<std::size_t>& frame);

/// Adds --mark.
void add_marks(CLI::App& command, std::vector<SwimmerMark>& marks);

}  // namespace beadswim
