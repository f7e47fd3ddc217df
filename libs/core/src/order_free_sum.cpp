#include "beadswim/core/order_free_sum.hpp"

#include <fmt/core.h>

#include "beadswim/core/error.hpp"

namespace beadswim {

void OrderFreeSum::refuse(double x) {
  throw NotFiniteError(
      fmt::format("a term of {} in a sum of terms below {}: the run has become unstable; drive beads "
                  "less, or take more --cells-per-radius",
                  x, largest_term));
}

void OrderFreeSum::overflow() {
  throw SolverError(
      "a sum over cells or links has grown too large to be held: the run has become unstable; drive beads "
      "less, or take more --cells-per-radius");
}

}  // namespace beadswim
