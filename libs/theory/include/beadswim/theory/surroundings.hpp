#pragma once

#include <optional>
#include <string>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// Boundaries of the fluid around a swimmer. `box` is set if the swimmer is alone in a box that theory can
/// treat; the first axis of this box is parallel to the swimmer. `obstacle` is set in any other box. It is
/// the reason why methods for boxes cannot treat the swimmer. In open space, `box` is nullopt and `obstacle`
/// is empty.
struct Surroundings {
  std::optional<BoxPlace> box{};
  std::string obstacle{};
};

/// Returns the box of one swimmer of the layout, or the reason why theory cannot treat the box.
Surroundings surroundings_of(const Layout& layout, const Swimmer& swimmer);

}  // namespace beadswim
