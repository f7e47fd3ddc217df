#pragma once

namespace beadswim {

/// Steps of a whole run of so many cycles. Throws InputError if there are too many.
long total_steps(double cycles, long steps_per_cycle);

/// Steps between flow fields, or checkpoints, each so many cycles.
long steps_between(double cycles, long steps_per_cycle);

}  // namespace beadswim
