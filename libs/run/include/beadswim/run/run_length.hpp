#pragma once

namespace beadswim {

/// Returns the number of time steps of a run of `cycles` base cycles. Throws InputError above 10^15 steps.
long total_steps(double cycles, long steps_per_cycle);

/// Throws InputError if a restart begins after the end of a run of `cycles` base cycles: steps_done > steps.
void require_end_after(double cycles, long steps, long steps_done, long steps_per_cycle);

/// Returns the number of time steps between outputs that are `cycles` base cycles apart.
long steps_between(double cycles, long steps_per_cycle);

}  // namespace beadswim
