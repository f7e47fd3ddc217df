#include "beadswim/core/order_free_sum.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {

void OrderFreeSum::throw_out_of_range(double x) {
  throw NotFiniteError(
      fmt::format("a term of {} in a sum of terms below {}: the run has become unstable; drive beads "
                  "less, or take more {}",
                  x, largest_term, Setting::cells_per_radius));
}

void OrderFreeSum::throw_overflow() {
  throw SolverError(
      fmt::format("a sum over cells or links has grown too large to be held: the run has become unstable; "
                  "drive beads less, or take more {}",
                  Setting::cells_per_radius));
}

}  // namespace beadswim
