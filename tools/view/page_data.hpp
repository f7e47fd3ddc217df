#pragma once

#include <string>
#include <vector>

#include "beadswim/documents/trajectory_file.hpp"

namespace beadswim {

struct PageOptions {
  std::size_t every = 1;                     ///< of so many frames one is shown, and the last
  std::vector<int> block_swimmers{1, 3, 3};  ///< of which the colours tell blocks; as of block_number
};

/// The frames to show.
std::vector<std::size_t> shown_frames(std::size_t frames, std::size_t every);

/// What the page shows, as HTML elements that hold data: <script type="application/json" id="scene"> and, in
/// base64 of little-endian numbers, <script type="text/plain" id="..."> of
///   radius        float32, of each bead
///   start         float32, x, y, z of each bead in the first frame, unwrapped
///   step          float32, of each swimmer: the length that its whole numbers below count
///   frame-0, ...  int16, x, y, z of each bead less those in the first frame, in steps of its swimmer
///   cycle-NAME    int16, of each base cycle and swimmer, in steps of that swimmer in cycle-NAME-step; -32768
///   for none:
///                 velocity (along its axis, against the mean flow), arm1, arm2 (amplitudes), phase1, phase2
/// Throws InputError naming file and place.
std::string page_data(const TrajectoryFile& file, const PageOptions& options);

/// Bytes that page_data will be, to a tenth for large swarms.
double expected_bytes(const TrajectoryFile& file, const PageOptions& options);

}  // namespace beadswim
