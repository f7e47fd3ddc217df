#include "beadswim/core/order_free_sum.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"

namespace beadswim {

void OrderFreeSum::refuse(double x) {
  throw SolverError(
      fmt::format("a term of {} does not fit an order-free sum (|term| < {})", x, largest_term));
}

}  // namespace beadswim
