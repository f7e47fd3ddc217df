#pragma once

#include "beadswim/io/h5md.hpp"

namespace beadswim {

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

}  // namespace beadswim
