#include "beadswim/run/percent.hpp"

#include <fmt/core.h>

namespace beadswim {

std::string in_percent(double share) {
  if (share > 10) return "more than 1000 %";
  return share < 1 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

}  // namespace beadswim
