#pragma once

#include <optional>

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A periodic box so large that a single swimmer moves almost as in the surroundings of the layout. Its edges
/// are integer multiples of the smallest radius.
struct SufficientBox {
  Vec3 lengths = Vec3::Zero();  ///< edges; the first is parallel to the swimmer [length]
  double change = 0;            ///< largest relative change of velocity and arm amplitudes
};

/// Returns a periodic box in which velocity and arm amplitudes, by the method inertia-corrected, differ by at
/// most the relative `tolerance` from those in the question's surroundings. Boxes of increasing size are
/// tried, and the first sufficient one is returned. The gap between the swimmer and its image along the axis
/// is also the width of the box. It increases from 0.5 to 20 (l_1 + l_2). Returns nullopt if no box is
/// sufficient. Throws InputError if the method cannot treat the question.
std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance);

}  // namespace beadswim
