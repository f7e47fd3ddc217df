#pragma once

#include <optional>
#include <string>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// Surroundings of a swimmer. `box` is set if the swimmer is alone in a box that theory can treat; its first
/// axis is parallel to the swimmer. `obstacle` is set if methods for boxes cannot treat the surroundings.
/// Neither is set in open space.
struct Surroundings {
  std::optional<BoxPlace> box;
  std::string obstacle;
};

/// Returns the surroundings of one swimmer of the layout.
Surroundings surroundings_of(const Layout& layout, const Swimmer& swimmer);

}  // namespace beadswim
