#pragma once

#include <optional>

#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/question.hpp"

namespace beadswim {

/// A periodic box that changes a lone swimmer little.
struct SufficientBox {
  Vec3 lengths = Vec3::Zero();  ///< first axis along the swimmer, whole multiples of the smallest radius
  double change = 0;            ///< largest relative change of velocity and arms' amplitudes by it
};

/// The smallest found in which a swimmer alone moves as in the question's surroundings, but for `tolerance`,
/// by inertia-corrected theory; none if none of up to twenty swimmer lengths does.
std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance);

}  // namespace beadswim
