#include "beadswim/scene/fault.hpp"

#include <tuple>

namespace beadswim {

bool comes_before(const Fault& a, const Fault& b) {
  const auto rank = [](const Fault& f) { return std::tuple(f.step, f.kind, f.bead, f.other, -f.value); };
  return rank(a) < rank(b);
}

void keep_first(std::optional<Fault>& first, const Fault& fault) {
  if (!first || comes_before(fault, *first)) first = fault;
}

}  // namespace beadswim
