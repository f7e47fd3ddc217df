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

  bool has_forces = false;  ///< frames have forces and drives

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
  std::vector<Vec3> forces{};     ///< of the fluid on each bead, if the header says so [mass length/time^2]
  std::vector<Vec3> drives{};     ///< of the drives on each bead, likewise [mass length/time^2]
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
  // These functions are for rank 0.

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

/// Reads a trajectory that TrajectoryWriter wrote. Requires only one process and no MPI. Can also read the
/// complete frames of FILE.part, the file of a run that is active or was killed. H5MD does not distinguish
/// free-slip and no-slip walls: all walls are read as free-slip. All functions throw InputError with file,
/// place in the file and remedy if the contents are invalid.
class TrajectoryReader {
 public:
  /// Opens a trajectory. Throws InputError if it cannot be read, is not a trajectory or contains no frame.
  explicit TrajectoryReader(const std::string& path);

  const TrajectoryHeader& header() const { return header_; }
  std::size_t frames() const { return frames_; }
  /// Returns true if the run ended while it wrote a further frame, which is left out.
  bool has_incomplete_frame() const { return begun_frames_ > frames_; }

  /// Returns the times of all frames [time].
  std::vector<double> times() const;

  /// Returns frame `index` < frames(), with unwrapped positions.
  TrajectoryFrame frame(std::size_t index) const;

  /// Returns the cycle quantities of all swimmers at the end of each base cycle (docs/notation.md, base
  /// period). `columns` contains the names and shapes of the columns.
  std::vector<TrajectoryCycle> cycles(const std::vector<Column>& columns) const;

 private:
  H5Dataset open_series(const std::string& name, Extents row);
  std::optional<Box> box(std::size_t frame) const;
  void read_header();

  H5File file_;
  std::size_t frames_, begun_frames_ = 0;
  std::size_t beads_;
  H5Dataset step_, time_, edges_, position_, image_, velocity_, mean_flow_, momentum_;
  std::array<Boundary, 3> boundary_;
  TrajectoryHeader header_;
};

/// Returns true if ParaView opens files whose names begin with the name of this file. Its readers of indices
/// fail for others: those that are not ASCII, contain a colon, a backslash or ~, or begin with a space.
bool paraview_can_open(const std::string& path);

/// Writes the index of a finished trajectory in XDMF 2 to the trajectory's folder, completely or not at all.
/// ParaView, which cannot read H5MD itself, finds in it where the data of each frame are in the file. The
/// index contains, for each frame, the time, the beads as points, and the radius, species, swimmer, velocity
/// and image of each bead. Must be called on one rank only. Throws InputError if the trajectory is invalid or
/// the index cannot be created, and SolverError if the index cannot be written.
void write_xdmf(const std::string& trajectory);

}  // namespace beadswim
