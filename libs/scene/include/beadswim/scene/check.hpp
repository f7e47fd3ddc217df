#pragma once

#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// An error in a layout.
struct LayoutFault {
  std::string place;    ///< JSON pointer to the place in layout.json, for example "/swimmers/3/position"
  std::string message;  ///< states the invalid value, the allowed values and the remedy
};

/// Returns the errors of a layout that a JSON schema cannot detect. The list is empty for a valid layout.
/// There are four groups of errors:
///   1. Units whose SI factor contradicts their name, and arms whose beads overlap at rest length.
///   2. Unknown types, repeated ids, axes that are not unit vectors, and swimmers outside the box.
///   3. Beads that touch or cut a wall.
///   4. Beads that touch or overlap, periodic images included.
/// Group 3 is checked only if groups 1 and 2 contain no error, and group 4 only if groups 1 to 3 contain
/// none. From groups 3 and 4, only the first error of each swimmer is returned.
std::vector<LayoutFault> check_layout(const Layout& layout);

/// Normalises the axes whose length differs from 1 by at most 1e-6. Leaves all other axes unchanged.
void normalise_axes(Layout& layout);

/// Returns a warning with the number of swimmers whose forces do not turn with them: the frame of the forces
/// is the laboratory, and the orientation of the swimmer changes their directions relative to the swimmer.
/// Returns an empty string if there are none. Does not count forces with a non-zero sum, such as weight,
/// which act on the swimmers from outside, nor swimmers for which all forces are reversed if that delays the
/// stroke by half a period and changes nothing else.
std::string warning_of_fixed_forces(const Layout& layout);

}  // namespace beadswim
