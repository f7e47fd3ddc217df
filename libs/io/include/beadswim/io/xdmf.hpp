#pragma once

#include <string>

// A trajectory for ParaView, which does not know H5MD: an index in XDMF 2 that says where in the file the
// numbers of each frame are.

namespace beadswim {

/// The index of a trajectory. ParaView gives files with this ending, and not those that end in .xdmf, to the
/// one of its XDMF readers that can take a frame out of a dataset of all frames.
std::string xdmf_name(const std::string& trajectory);

/// Writes the index of a finished trajectory beside it, whole or not at all: for each frame its time, beads
/// as points, and radius, species, swimmer, velocity and image of each. By one process. Throws as
/// write_text does if it cannot be written.
void write_xdmf(const std::string& trajectory);

}  // namespace beadswim
