#pragma once

#include <optional>
#include <string>

#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// Where a swimmer lies, as theory sees it: in a box whose first axis is the swimmer's, in open space
/// (neither member set), or in surroundings that theory has no method for.
struct Surroundings {
  std::optional<BoxPlace> box;
  std::string obstacle;
};

Surroundings surroundings_of(const Layout& layout, const Swimmer& swimmer);

}  // namespace beadswim
