#include "beadswim/run/run_length.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {

long total_steps(double cycles, long steps_per_cycle) {
  const double steps = cycles * static_cast<double>(steps_per_cycle);
  constexpr double max_steps = 1e15;  // doubles represent all integers up to this number
  if (steps > max_steps) {
    throw InputError(
        Setting::cycles,
        "{:.3g} cycles are {:.3g} time steps, but at most {:.3g} time steps are possible; run fewer cycles",
        cycles, steps, max_steps);
  }
  return std::max(1L, std::lround(steps));
}

void require_end_after(double cycles, long steps, long steps_done, long steps_per_cycle) {
  if (steps_done <= steps) return;
  throw InputError(Setting::cycles,
                   "the number of cycles, {}, is too small, because the checkpoint is already at cycle "
                   "{:.6g}; give more cycles",
                   cycles, static_cast<double>(steps_done) / static_cast<double>(steps_per_cycle));
}

long steps_between(double cycles, long steps_per_cycle) {
  constexpr double never = 1e15;
  const double steps = cycles * static_cast<double>(steps_per_cycle);
  return std::max(1L, std::lround(std::min(steps, never)));
}

}  // namespace beadswim
