#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/tools/named_flags.hpp"

// Flags that several kinds of figures share, and flags whose values have a form of their own.

namespace beadswim {

/// A swimmer that the picture names.
struct SwimmerMark {
  std::string name;
  int id = 0;
};

/// --method.
void add_methods(CLI::App& command, std::vector<std::string>& methods);

/// --cycle.
void add_cycle(CLI::App& command, std::string& cycle);

/// A flag that takes whole numbers from 0 on, joined by commas; `unless_given` is shown as its default.
CLI::Option* add_whole_numbers(CLI::App& command, const std::string& flag, std::vector<int>& numbers,
                               const std::string& unless_given, const std::string& help);

/// --frame: none is the last one.
void add_frame(CLI::App& command, std::optional<std::size_t>& frame);

/// --mark.
void add_marks(CLI::App& command, std::vector<SwimmerMark>& marks);

}  // namespace beadswim
