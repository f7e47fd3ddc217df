#pragma once

#include <string>
#include <vector>

#include "beadswim/documents/trajectory_file.hpp"
#include "flow_arrows.hpp"

namespace beadswim {

/// Selection of the frames that the page shows, size of the blocks of swimmers that it colours, and flow.
struct PageOptions {
  std::size_t every = 1;                     ///< shows the frames 0, every, 2 every, ... and the last
  std::vector<int> block_swimmers{1, 3, 3};  ///< swimmers per block, as in block_number()
  std::optional<FlowArrows> flow{};          ///< nullopt: the page shows no flow
};

/// Returns the indices of the frames that the page shows: 0, every, 2 every, ... and the last frame.
std::vector<std::size_t> select_frames(std::size_t frames, std::size_t every);

/// Returns the data of the page as HTML elements. The element <script type="application/json" id="scene">
/// contains JSON. The elements <script type="text/plain" id="ID"> contain arrays of little-endian numbers in
/// base64:
///
///   ID               type     content
///   radius           float32  radius of each bead [length]
///   start            float32  x, y, z of each bead in the first frame, unwrapped [length]
///   step             float32  quantisation step of each swimmer [length]
///   frame-0, ...     int16    x, y, z of each bead minus its start, in steps of its swimmer
///   cycle-NAME       int16    NAME of each swimmer or bond in each base cycle, in steps of cycle-NAME-step;
///                             -32768 represents NaN
///   cycle-NAME-step  float32  quantisation step of each swimmer or bond
///   flow-place       float32  x, y, z of each arrow of the flow [length]
///   flow-velocity    float32  velocity of the fluid at each arrow, along x, y, z [length/time]
///
/// NAME is velocity of each swimmer (along its axis, relative to the mean flow), or amplitude or phase (arm
/// amplitude and phase) of each bond, swimmer after swimmer. The key "shapes" of the scene lists number of
/// beads, bonds, angles and line (the two end beads of swimmers in line) of the types, with beads numbered
/// from 0; "shape" is the index of each swimmer's type in this list. "flow" has the number of arrows, their
/// spacing and the cycles of a mean, or is null. Throws InputError that names the file and the place in it.
std::string page_data(const TrajectoryFile& file, const PageOptions& options);

/// Returns the approximate size of page_data() [byte]. For large swarms the error is below 10 %.
double expected_bytes(const TrajectoryFile& file, const PageOptions& options);

}  // namespace beadswim
