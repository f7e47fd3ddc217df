#include "beadswim/core/order_free_sum.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

namespace beadswim {

void OrderFreeSum::throw_out_of_range(double x) {
  throw NotFiniteError(
      fmt::format("the run has become unstable: the value {} is to be added to a sum over cells or links, "
                  "but values must be below {}; reduce the driving amplitude or use more {}",
                  x, largest_term, Setting::cells_per_radius));
}

void OrderFreeSum::throw_overflow() {
  throw SolverError(
      fmt::format("the run has become unstable: a sum over cells or links is too large to be stored; reduce "
                  "the driving amplitude or use more {}",
                  Setting::cells_per_radius));
}

}  // namespace beadswim
