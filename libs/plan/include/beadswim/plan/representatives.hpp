#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/question.hpp"

// Swimmers as input of theory, which represent a scene.

namespace beadswim {

/// A swimmer that represents all swimmers of the same type and driving, and the input of theory for it.
struct Representative {
  int swimmer = 0;        ///< id of the swimmer
  ThreeBeadSwimmer type;  ///< type of the swimmer, with the driving of the swimmer, or its stand-in
  Question question;
  /// States how `question` approximates the neighbours, the box or the driving; empty if it does not.
  std::string approximation;
  /// True: the swimmer is not the paper's, and `question` is for three beads with similar radii, distances
  /// and strokes. Their errors have not been validated for the shape.
  bool is_stand_in = false;
  double bead_speed = 0;  ///< of the fastest bead of the swimmer, to first order in the drives [length/time]
  bool is_slanted = false;  ///< true: driving forces have a component normal to the axis
};

/// Returns one representative for each kind of swimmers: those of the same type and driving, apart from the
/// phase offset, and along equal edges of a box; with driving along x, also at the same angle to it. For a
/// type with more than eight kinds, the result contains at most four swimmers of this type: those with the
/// largest and the smallest force along the axis, the longest and the shortest period. `cell`: smallest cell
/// whose repetition gives the scene (scene/reduce.hpp). Throws InputError for swimmers without springs.
std::vector<Representative> representatives(const Layout& cell);

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
