#include "scene_facts.hpp"

#include <algorithm>

namespace beadswim {

double base_period(const Layout& layout) {
  const auto own = [&](const Swimmer& swimmer) { return layout.resolved_type(swimmer).driving.period; };
  const double first = own(layout.swimmers.front());
  if (std::ranges::all_of(layout.swimmers, [&](const Swimmer& s) { return own(s) == first; })) return first;
  return layout.types.at(layout.swimmers.front().type).driving.period;
}

SceneBox box_of(const Layout& layout) {
  SceneBox box;
  if (!layout.domain) return box;
  box.lengths = layout.domain->lengths;
  for (int a = 0; a < 3; ++a) box.periodic[a] = layout.domain->boundary[a] == Boundary::periodic;
  return box;
}

}  // namespace beadswim
