#pragma once

#include <string>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Returns a warning with the number of swimmers whose forces do not turn with them: the frame of the forces
/// is the laboratory, and the orientation of the swimmer changes their directions relative to the swimmer.
/// Returns an empty string if there are none. Does not count forces with a non-zero sum, such as weight,
/// which act on the swimmers from outside, nor swimmers for which all forces are reversed if that delays the
/// stroke by half a period and changes nothing else.
std::string warning_of_fixed_forces(const Layout& layout);

}  // namespace beadswim
