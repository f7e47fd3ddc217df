#pragma once

#include "beadswim/io/h5md.hpp"

namespace beadswim {

/// Reads a trajectory that TrajectoryWriter wrote, by one process and without MPI. FILE.part of a run that
/// goes on or was killed can be read too; its frames are those that are whole. H5MD does not record the kind
/// of a wall: walls are read as free-slip.
class TrajectoryReader {
 public:
  /// Throws InputError naming file, place in it and remedy, as all of it does, for what cannot be read, is no
  /// trajectory, or holds no frame.
  explicit TrajectoryReader(const std::string& path);

  const TrajectoryHeader& header() const { return header_; }
  std::size_t frames() const { return frames_; }

  /// Of all frames [time].
  std::vector<double> times() const;

  /// Frame `index` < frames(), positions unwrapped.
  TrajectoryFrame frame(std::size_t index) const;

  /// What each swimmer did, base cycle by base cycle, in columns of these names and shapes; none for files
  /// from before they held it.
  std::vector<TrajectoryCycle> cycles(const std::vector<Column>& columns) const;

 private:
  /// A dataset of numbers, a row a frame or a bead.
  struct Table {
    std::string place;  ///< FILE:/NAME
    H5Handle dataset;
    std::vector<hsize_t> extents;
  };

  Table open_table(const std::string& name, std::vector<hsize_t> row) const;
  Table open_series(const std::string& name, std::vector<hsize_t> row);
  template <typename Number>
  static std::vector<Number> read_raw_rows(const Table& table, hsize_t first, hsize_t count);
  template <typename Number>
  static std::vector<Number> read_rows(const Table& table, hsize_t first, hsize_t count);
  template <typename Number>
  std::vector<Number> read_all(const std::string& name) const;
  std::vector<Vec3> vectors(const Table& table, std::size_t frame) const;
  std::string text(const std::string& name) const;
  std::map<std::string, std::string> texts(const std::string& group) const;
  std::array<Boundary, 3> boundary() const;
  std::optional<Box> box(std::size_t frame) const;
  void read_header();
  void require_whole_swimmers() const;

  std::string path_;
  H5Handle file_;
  std::size_t frames_;
  std::size_t beads_;
  Table step_, time_, edges_, position_, image_, velocity_, mean_flow_, momentum_;
  std::array<Boundary, 3> boundary_;
  TrajectoryHeader header_;
};

}  // namespace beadswim
