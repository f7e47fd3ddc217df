#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/layout_document.hpp"

namespace beadswim {

/// Returns the layout of the run in a trajectory file, with swimmers that start where the run was at the end
/// of base cycle number `cycle`, from 0; nullopt: at the end of the last cycle in the file. Their driving
/// continues; beads and fluid are at rest. The fitted shape at rest gives position and orientation, except
/// for forces in the frame initial-axis, which keep the orientation that defines them. Throws InputError if
/// the file is invalid or has no frame at this time. `flag`: flag that gave the cycle, for messages.
LayoutDocument layout_after_cycle(const std::string& path, std::optional<int> cycle, const std::string& flag);

}  // namespace beadswim
