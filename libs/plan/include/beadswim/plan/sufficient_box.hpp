#pragma once

#include <optional>

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A periodic box that changes the motion of a single swimmer little. Its edges are integer multiples of the
/// smallest radius.
struct SufficientBox {
  Vec3 lengths = Vec3::Zero();  ///< edges, the first along the swimmer [length]
  double change = 0;            ///< largest relative change of velocity and arm amplitudes
};

/// Returns the smallest box in a series of growing boxes in which velocity and arm amplitudes differ by at
/// most `tolerance`, relative, from those in the question's surroundings. The method is inertia-corrected.
/// Returns nullopt if no box up to a free length of 20 (l_1 + l_2) is sufficient. Throws InputError if the
/// method cannot treat the question.
std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance);

}  // namespace beadswim
