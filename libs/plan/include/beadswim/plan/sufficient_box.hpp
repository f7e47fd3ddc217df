#pragma once

#include <optional>

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A periodic box so large that a single swimmer moves almost as in the box or open space of the layout. The
/// edges of this box are integer multiples of the smallest bead radius.
struct SufficientBox {
  Vec3 lengths = Vec3::Zero();  ///< edges; the first is parallel to the swimmer [length]
  double change = 0;            ///< largest relative change of velocity and arm amplitudes
};

/// Returns a periodic box for the swimmer of the question. In this box, velocity and arm amplitudes by the
/// method inertia-corrected differ by at most `tolerance` (relative) from their values in the box or open
/// space of the question. Boxes of increasing size are tried, and the first sufficient one is returned. The
/// free length between the swimmer and its periodic image increases from 0.5 to 20 times the sum of both rest
/// lengths; the width of the box equals the free length. Returns nullopt if no box is sufficient. Throws
/// InputError if the method cannot treat the question.
std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance);

}  // namespace beadswim
