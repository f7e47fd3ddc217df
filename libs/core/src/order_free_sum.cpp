#include "beadswim/core/order_free_sum.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {

void OrderFreeSum::throw_out_of_range(double x) {
  throw NotFiniteError(fmt::format(
      "a sum contains the term {}, but terms must be below {}: the run has become unstable; reduce the "
      "driving amplitude or use more {}",
      x, largest_term, Setting::cells_per_radius));
}

void OrderFreeSum::throw_overflow() {
  throw SolverError(
      fmt::format("a sum over cells or links exceeds the range of its numbers: the run has become unstable; "
                  "reduce the driving amplitude or use more {}",
                  Setting::cells_per_radius));
}

}  // namespace beadswim
