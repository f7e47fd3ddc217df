#pragma once

#include <span>
#include <string>

#include "beadswim/compare/cycle_statistics.hpp"

namespace beadswim {

/// Selection of cycles of a swimmer.
struct CycleChoice {
  enum class Kind {
    last,   ///< the last `number` cycles
    index,  ///< the cycle with index `number`
  };
  Kind kind = Kind::last;
  int number = 1;
};

/// Parses "last" (the last cycle), "N" (the cycle with index N) or "mean:N" (the last N cycles). Throws
/// InputError for Setting::cycle if the text is none of these.
CycleChoice parse_cycle_choice(const std::string& text);

/// Returns the selected cycles; empty if one of them does not exist. `cycles` are in increasing order of
/// their index.
std::span<const CycleStatistics> find_cycles(std::span<const CycleStatistics> cycles,
                                             const CycleChoice& choice);

/// Returns the selected cycles. `cycles` are in increasing order of their index. Throws InputError if a
/// selected cycle does not exist; the message states `source` and the available cycles.
std::span<const CycleStatistics> select_cycles(std::span<const CycleStatistics> cycles,
                                               const CycleChoice& choice, const std::string& source);

}  // namespace beadswim
