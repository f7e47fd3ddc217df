#pragma once

#include <algorithm>
#include <cmath>
#include <set>

#include "accepted.hpp"
#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "hdf5_handles.hpp"

namespace beadswim {

inline bool are_finite(const std::vector<Vec3>& vectors, std::size_t beads) {
  return vectors.size() == beads && std::ranges::all_of(vectors, [](const Vec3& v) { return v.allFinite(); });
}

/// Opens a trajectory as beadswim-plot does. If it is accepted, requires that each frame is either refused or
/// complete.
inline void require_whole_or_refused(const std::string& path) {
  require_all_closed_by([&] {
    accepts([&] {
      const TrajectoryFile file = open_trajectory(path);
      const TrajectoryReader& reader = file.reader;
      const TrajectoryHeader& header = reader.header();
      const std::size_t beads = header.bead.size();
      require(reader.frames() > 0 && beads % 3 == 0 && file.layout.swimmers.size() * 3 == beads,
              "whole swimmers");
      require(header.swimmer.size() == beads && header.radius.size() == beads, "a number for each bead");
      require(std::ranges::all_of(header.radius, [](double r) { return r > 0; }), "radii are positive");
      require(header.box ? header.box->lengths == file.layout.domain.box->lengths : !file.layout.domain.box,
              "the box is the layout's");
      require(file.period() > 0 && file.swimmers().size() * 3 == beads,
              "a period, and an id for each swimmer");
      require(std::set(file.in_layout.begin(), file.in_layout.end()).size() * 3 == beads,
              "each swimmer once");
      for (const TrajectoryCycle& cycle : reader.cycles(columns_of<CycleStatistics>({})))
        require(cycle.columns[0].numbers.size() == beads && cycle.columns[4].numbers.size() == beads / 3 * 2,
                "whole cycles");
      for (std::size_t n = 0; n < std::min<std::size_t>(reader.frames(), 10); ++n) {
        const TrajectoryFrame frame = reader.frame(n);
        require(are_finite(frame.positions, beads) && are_finite(frame.velocities, beads), "finite frames");
        require(are_finite({frame.mean_flow, frame.momentum}, 2) && std::isfinite(frame.time),
                "finite totals");
      }
    });
  });
}

}  // namespace beadswim
