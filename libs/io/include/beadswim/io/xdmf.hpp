#pragma once

#include <string>

// Index of a trajectory in XDMF 2, which tells ParaView where the data of each frame are in the H5MD file.
// ParaView cannot read H5MD itself.

namespace beadswim {

/// Returns the file name of the XDMF index of a trajectory. The name ends in .xdmf2, so that ParaView uses
/// the XDMF reader that can select one frame of a dataset. For the ending .xdmf, ParaView uses a reader that
/// cannot do this.
std::string xdmf_name(const std::string& trajectory);

/// Returns true if ParaView opens files whose names begin with the name of this file. Its readers of indices
/// fail for others: those that are not ASCII, contain a colon, a backslash or ~, or begin with a space.
bool paraview_can_open(const std::string& path);

/// Writes the XDMF index of a finished trajectory to the trajectory's folder, completely or not at all. The
/// index contains, for each frame, the time, the beads as points, and the radius, species, swimmer, velocity
/// and image of each bead. Must be called on one rank only. Throws InputError if the trajectory is invalid or
/// the index cannot be created, and SolverError if the index cannot be written.
void write_xdmf(const std::string& trajectory);

}  // namespace beadswim
