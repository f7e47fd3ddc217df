#pragma once

#include <span>
#include <string>

#include "beadswim/compare/cycle_statistics.hpp"

namespace beadswim {

/// Which of a swimmer's cycles to look at.
struct CycleChoice {
  enum class Kind {
    last,   ///< the last `number` cycles
    index,  ///< the cycle with index `number`
  };
  Kind kind = Kind::last;
  int number = 1;
};

/// "last", "N" (the Nth cycle) or "mean:N" (the last N). Throws InputError of Setting::cycle.
CycleChoice parse_cycle_choice(const std::string& text);

/// `cycles` are in order of their index. Throws InputError naming `source` and the cycles there are.
std::span<const CycleStatistics> chosen_cycles(std::span<const CycleStatistics> cycles,
                                               const CycleChoice& choice, const std::string& source);

}  // namespace beadswim
