#pragma once

#include <cstdint>
#include <exception>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/io/columns.hpp"
#include "beadswim/io/hdf5.hpp"

// Bead trajectories in H5MD 1.1 (de Buyl, Colberg & Hofling, Comput. Phys. Commun. 185 (2014) 1546), in the
// subset that MDAnalysis and h5py read: docs/formats/h5md.md. Quantities are in the layout's units.

namespace beadswim {

/// What does not change in a trajectory.
struct TrajectoryHeader {
  std::optional<Box> box{};    ///< none: open space
  std::vector<int> swimmer;    ///< id of the swimmer of each bead
  std::vector<int> bead;       ///< 1, 2 or 3 within the swimmer, of each bead
  std::vector<double> radius;  ///< of each bead
  std::string creator_version;
  std::map<std::string, std::string> parameters;  ///< texts for /parameters: layout, units, ...
  std::vector<Column> cycle_columns{};  ///< of what is known of each swimmer's cycles; without numbers
};

/// One frame. Beads in the order of the header; rank 0 alone need fill their lists.
struct TrajectoryFrame {
  std::int64_t step = 0;
  double time = 0;
  std::vector<Vec3> positions;  ///< unwrapped
  std::vector<Vec3> velocities;
  Vec3 mean_flow = Vec3::Zero();  ///< volume mean of the velocity of fluid and beads
  Vec3 momentum = Vec3::Zero();   ///< of fluid and beads
};

/// What each swimmer did in its last whole cycle; NaN for one that has ended none yet. A record per swimmer,
/// in the order of the beads.
struct TrajectoryCycle {
  std::int64_t step = 0;
  double time = 0;
  std::vector<Column> columns;  ///< those of the header; rank 0 alone need fill them
};

/// x, y, z of each vector, in single precision.
std::vector<float> flattened(const std::vector<Vec3>& vectors);

/// Writes a trajectory frame by frame. All ranks construct it and call its functions together. While it is
/// being written the file is called PATH.part; each frame is flushed, so that a killed run leaves whole
/// frames there. The same frames give the same bytes, on any number of ranks.
class TrajectoryWriter {
 public:
  /// Throws InputError if the file cannot be created, or another process is writing it. With a checkpoint it
  /// begins with the frames that this holds.
  TrajectoryWriter(const std::string& path, const TrajectoryHeader& header, const Communicator& communicator,
                   const CheckpointReader* checkpoint = nullptr);
  ~TrajectoryWriter();
  TrajectoryWriter(const TrajectoryWriter&) = delete;
  TrajectoryWriter& operator=(const TrajectoryWriter&) = delete;

  void append(const TrajectoryFrame& frame);
  void append(const TrajectoryCycle& cycle);

  /// Puts all frames so far into the checkpoint.
  void add_to(CheckpointWriter& checkpoint) const;

  /// Gives the file its name, in place of an older one.
  void finish();

 private:
  /// A dataset that grows row by row.
  struct Series {
    H5Handle dataset;
    std::vector<hsize_t> row;  ///< shape of one row
    hid_t type;                ///< in memory
    hsize_t rows = 0;
  };

  /// Time-dependent quantities that are sampled together: one step and one time, under every name.
  struct Sampling {
    std::string step_name, time_name;  ///< in the file
  };

  /// A file descriptor with a lock on the file, on rank 0.
  struct Lock {
    explicit Lock(int locked) : descriptor(locked) {}
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    int descriptor;
  };

  void write_metadata(const TrajectoryHeader& header);
  void create_groups(const TrajectoryHeader& header);
  /// The series of a name: created, or as it is in a file that a checkpoint holds.
  void add_series(const std::string& name, hid_t type, std::vector<hsize_t> row);
  H5Handle create_series(const std::string& name, hid_t type, const std::vector<hsize_t>& row);
  /// Group of a time-dependent quantity: datasets value, step and time.
  void add_element(Sampling& sampling, const std::string& name, hid_t type, std::vector<hsize_t> row);
  void append_row(const std::string& name, const void* data);
  void flush() const;
  /// Throws SolverError if HDF5 says that it failed.
  void require_written(herr_t status) const;

  std::string path_;
  bool root_;
  MPI_Comm comm_;
  std::optional<Box> box_;
  std::size_t beads_;
  bool goes_on_;  ///< with a file that a checkpoint held
  Lock lock_;
  int exceptions_ = std::uncaught_exceptions();  ///< under way when it was opened
  H5Handle file_;
  std::map<std::string, Series> series_;  ///< by path in the file
  Sampling frames_, cycles_;
};

}  // namespace beadswim
