#pragma once

#include <string>

// Index of a trajectory in XDMF 2, which tells ParaView where the data of each frame are in the H5MD file.
// ParaView cannot read H5MD itself.

namespace beadswim {

/// Returns the file name of the index of a trajectory. It ends in .xdmf2: for this ending ParaView uses the
/// XDMF reader that can select one frame of a dataset. For .xdmf it uses another reader, which cannot.
std::string xdmf_name(const std::string& trajectory);

/// Writes the index of a finished trajectory to the same folder, completely or not at all. The index
/// contains, for each frame, the time, the beads as points, and the radius, species, swimmer, velocity and
/// image of each bead. To be called on one rank. Throws as TrajectoryReader and write_text do.
void write_xdmf(const std::string& trajectory);

}  // namespace beadswim
