#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/temporary_file.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/io/columns.hpp"
#include "beadswim/io/hdf5.hpp"

// Bead trajectories in the subset of H5MD 1.1 that h5py and MDAnalysis read (docs/formats/h5md.md). See de
// Buyl, Colberg & Hofling, Comput. Phys. Commun. 185 (2014) 1546. All quantities are in the units of the
// layout.

namespace beadswim {

/// Data of a trajectory that do not depend on time.
struct TrajectoryHeader {
  std::optional<Box> box{};                 ///< empty in open space
  std::vector<int> swimmer;                 ///< id of the swimmer of each bead
  std::vector<int> bead;                    ///< number of each bead in its swimmer: 1, 2, ...
  std::vector<double> radius;               ///< radius of each bead [length]
  std::vector<std::array<int, 2>> bonds{};  ///< indices of the two beads of each bond
  /// Names of the units of length and time, which become attributes "unit"; empty: no attributes.
  std::string length_unit{}, time_unit{};
  std::string creator_version;
  std::string layout{};  ///< layout document of the run, as JSON text
  std::vector<Column>
      cycle_columns{};  ///< names and shapes of the columns of TrajectoryCycle, without numbers

  /// Returns the number of swimmers.
  std::size_t swimmers() const { return std::ranges::count(bead, 1); }
  /// Returns the indices of the first beads of all swimmers.
  std::vector<std::size_t> first_beads() const {
    std::vector<std::size_t> first;
    for (std::size_t b = 0; b < bead.size(); ++b)
      if (bead[b] == 1) first.push_back(b);
    return first;
  }
};

/// One frame of a trajectory, with the beads in the order of the header. Positions and velocities are
/// required on rank 0 only.
struct TrajectoryFrame {
  std::int64_t step = 0;
  double time = 0;                ///< [time]
  std::vector<Vec3> positions;    ///< unwrapped: not moved back into the box [length]
  std::vector<Vec3> velocities;   ///< [length/time]
  Vec3 mean_flow = Vec3::Zero();  ///< volume average of the velocity of fluid and beads [length/time]
  Vec3 momentum = Vec3::Zero();   ///< total momentum of fluid and beads [mass length/time]
};

/// Quantities of the last complete cycle of each swimmer. The swimmers have the order of their beads in the
/// header. The quantities of a swimmer that has not completed a cycle are NaN.
struct TrajectoryCycle {
  std::int64_t step = 0;
  double time = 0;              ///< [time]
  std::vector<Column> columns;  ///< the columns of the header; required on rank 0 only
};

/// Returns the components x, y, z of all vectors in single precision.
std::vector<float> flattened(const std::vector<Vec3>& vectors);

/// Writes a trajectory frame by frame. All functions are collective and throw SolverError on all ranks if the
/// file cannot be written. Only rank 0 writes, without MPI-IO, which would wait for the disk after each
/// frame. The file is named PATH.part until finish(). Each frame is passed to the operating system, so that
/// the file of a killed run lacks at most a part of its last frame. The bytes of the file do not depend on
/// the number of ranks.
class TrajectoryWriter {
 public:
  /// Creates PATH.part. With a checkpoint, the file starts with the frames that the checkpoint contains.
  /// Throws InputError if PATH.part cannot be created or another process is writing it.
  TrajectoryWriter(const std::string& path, const TrajectoryHeader& header, const Communicator& communicator,
                   const CheckpointReader* checkpoint = nullptr);
  TrajectoryWriter(const TrajectoryWriter&) = delete;
  TrajectoryWriter& operator=(const TrajectoryWriter&) = delete;

  void append(const TrajectoryFrame& frame);
  void append(const TrajectoryCycle& cycle);

  /// Stores all frames written so far in a checkpoint.
  void add_to(CheckpointWriter& checkpoint) const;

  /// Completes the file and renames it to its final name. Replaces an older file.
  void finish();

 private:
  /// Calls write() on rank 0. Throws its SolverError on all ranks. Collective.
  void run_on_root(const std::function<void()>& write) const;

  // The remaining functions are for rank 0.

  void open(const TrajectoryHeader& header);
  /// Adds a dataset to series_. Creates it, or opens it if the file comes from a checkpoint.
  void add_series(const std::string& name, hid_t type, const Extents& row);
  /// Adds the group of a time-dependent quantity (an H5MD element), with the datasets value, step and time.
  /// Quantities that are sampled at the same times share step and time: `sampling` is the name of the first
  /// of these quantities, and the groups of the others contain links.
  void add_element(std::string& sampling, const std::string& name, hid_t type, const Extents& row);
  template <class Number>
  void append_row(const std::string& name, const Number* numbers) {
    series_.at(name).append_row(numbers);
  }
  /// Appends step and time of a sampling after all other data are written: on a full disk, no row has a time
  /// before its numbers are written.
  void append_time(const std::string& sampling, std::int64_t step, double time);

  std::string path_;
  const Communicator& communicator_;
  std::optional<Box> box_;
  bool continues_checkpoint_;  ///< true if the file comes from a checkpoint
  OpenFile lock_;              ///< locks the file for this process until it is closed
  std::optional<H5File> file_;
  std::map<std::string, H5Dataset> series_;  ///< keys: names in the file
  std::string frames_, cycles_;              ///< samplings of frames and of cycles
};

}  // namespace beadswim
