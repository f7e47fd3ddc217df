#include "beadswim/io/h5md.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"
#include "part_file.hpp"

namespace beadswim {
namespace {

// The quantities of each cycle are in a separate group, outside the H5MD groups, because MDAnalysis expects
// one value per frame in every series of the H5MD group /observables.
const std::string swimmers_group = "swimmers/";
constexpr const char* trajectory_section = "trajectory";  ///< name of a section of the checkpoint

/// Creates and locks PATH.part and stores its descriptor in `part`. Returns an empty text, or the reason why
/// the trajectory cannot be created.
std::string creation_fault(const std::string& path, int& part) {
  struct stat existing {};
  if (path == "-" || path.ends_with('/')) return fmt::format("\"{}\" is not the name of a file", path);
  if (stat(path.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode))
    return fmt::format("the path {} exists and is not a regular file", path);
  part = open(part_name(path).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (part < 0)
    return fmt::format("the file {} cannot be created: {}", part_name(path), std::strerror(errno));
  if (flock(part, LOCK_EX | LOCK_NB) != 0)
    return fmt::format("the file {} is being written by another run", part_name(path));
  return "";
}

/// Creates and locks the output file on rank 0. Returns the file descriptor on rank 0 and -1 on other ranks.
/// The lock lasts until the descriptor is closed. All ranks throw the same InputError on failure.
int lock_output(const std::string& path, const Communicator& communicator) {
  int part = -1;
  std::string fault = communicator.is_root() ? creation_fault(path, part) : "";
  broadcast(fault, communicator);
  if (!fault.empty()) {
    throw InputError(Setting::output, fault + "; name a file in a folder that exists and can be written to");
  }
  return part;
}

/// Opens PATH.part: as an empty file, or with the trajectory that it contains. This process has locked it, so
/// that HDF5 must not.
H5Handle open_file(const std::string& path, bool has_trajectory) {
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  check_hdf5(H5Pset_file_locking(access, false, true), path);
  const std::string part = part_name(path);
  const hid_t file = has_trajectory ? H5Fopen(part.c_str(), H5F_ACC_RDWR, access)
                                    : H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (file < 0) {
    throw SolverError(
        has_trajectory ? fmt::format("{}: the trajectory in the checkpoint is damaged; take the run's other "
                                     "checkpoint (.ckpt.0 or .ckpt.1), or begin without {}",
                                     part, Setting::restart)
                       : part + ": HDF5 cannot create the trajectory; is the disk full?");
  }
  return {file, H5Fclose, path};
}

/// Smallest size of a row (the data of one frame in one dataset) that is stored in a compressed chunk of its
/// own [byte]. Smaller rows share uncompressed chunks. In both cases, writing a row does not move data of
/// earlier frames.
constexpr hsize_t chunk_bytes = 16384;

struct WrappedPositions {
  std::vector<float> position;
  std::vector<int> image;
};

WrappedPositions wrap(const std::vector<Vec3>& positions, const std::optional<Box>& box) {
  WrappedPositions result;
  for (const Vec3& position : positions) {
    const Vec3 image = box ? image_number(position, *box) : Vec3::Zero(), inside = wrapped(position, box);
    for (int a = 0; a < 3; ++a) {
      const float rounded = static_cast<float>(inside[a]);
      const bool is_at_edge = box && box->is_periodic(a) && rounded >= box->lengths[a];  // due to rounding
      result.image.push_back(static_cast<int>(image[a]) + (is_at_edge ? 1 : 0));
      result.position.push_back(is_at_edge ? 0 : rounded);
    }
  }
  return result;
}

}  // namespace

std::vector<float> flattened(const std::vector<Vec3>& vectors) {
  std::vector<float> flat;
  for (const Vec3& v : vectors) {
    for (int a = 0; a < 3; ++a) flat.push_back(static_cast<float>(v[a]));
  }
  return flat;
}

TrajectoryWriter::TrajectoryWriter(const std::string& path, const TrajectoryHeader& header,
                                   const Communicator& communicator, const CheckpointReader* checkpoint)
    : path_(path),
      communicator_(communicator),
      box_(header.box),
      continues_checkpoint_(checkpoint != nullptr),
      lock_(lock_output(path, communicator)) {
  run_on_root([&] {
    if (checkpoint != nullptr) checkpoint->copy_to(trajectory_section, lock_.descriptor);
    open(header);
  });
}

void TrajectoryWriter::open(const TrajectoryHeader& header) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // exceptions replace HDF5's error messages on stderr
  file_ = open_file(path_, continues_checkpoint_);
  if (!continues_checkpoint_) create_groups(header);
  const hsize_t beads = header.bead.size(), swimmers = header.swimmers();
  add_element(frames_, "particles/beads/box/edges", H5T_NATIVE_DOUBLE, {3, 3});
  add_element(frames_, "particles/beads/position", H5T_NATIVE_FLOAT, {beads, 3});
  add_element(frames_, "particles/beads/image", H5T_NATIVE_INT, {beads, 3});
  add_element(frames_, "particles/beads/velocity", H5T_NATIVE_FLOAT, {beads, 3});
  add_element(frames_, "observables/mean_flow", H5T_NATIVE_DOUBLE, {3});
  add_element(frames_, "observables/momentum", H5T_NATIVE_DOUBLE, {3});
  write_units(header);
  for (const Column& column : header.cycle_columns) {
    std::vector<hsize_t> row{swimmers};
    row.insert(row.end(), column.shape.begin(), column.shape.end());
    add_element(cycles_, swimmers_group + column.name, H5T_NATIVE_DOUBLE, row);
  }
}

void TrajectoryWriter::run_on_root(const std::function<void()>& write) const {
  std::string fault;
  if (communicator_.is_root()) {
    try {
      write();
    } catch (const SolverError& error) {
      fault = error.what();
    }
  }
  broadcast(fault, communicator_);
  if (!fault.empty()) throw SolverError(fault);
}

void TrajectoryWriter::write_units(const TrajectoryHeader& header) {
  if (continues_checkpoint_ || header.length_unit.empty()) return;
  const std::string velocity_unit = header.length_unit + " " + header.time_unit + "-1";
  for (const auto& [name, unit] : {std::pair{frames_.time_name, header.time_unit},
                                   {"particles/beads/position/value", header.length_unit},
                                   {"particles/beads/box/edges/value", header.length_unit},
                                   {"particles/beads/velocity/value", velocity_unit},
                                   {"observables/mean_flow/value", velocity_unit}})
    write_variable_attribute(series_.at(name).dataset, "unit", unit);
}

void TrajectoryWriter::create_groups(const TrajectoryHeader& header) {
  write_metadata(header);
  const H5Handle particles = create_group(file_, "particles");
  const H5Handle beads = create_group(particles, "beads");
  const H5Handle box = create_group(beads, "box");
  write_attribute(box, "dimension", 3);
  std::array<std::string, 3> boundary;
  for (int a = 0; a < 3; ++a) boundary[a] = box_ && box_->is_periodic(a) ? "periodic" : "none";
  write_attribute(box, "boundary", boundary);
  write_dataset(beads, "species", header.bead);
  write_dataset(beads, "swimmer", header.swimmer);
  write_dataset(beads, "radius", header.radius);
  const H5Handle connectivity = create_group(file_, "connectivity");
  write_dataset(connectivity, "bonds", header.bonds);
  const H5Handle bonds(H5Dopen2(connectivity, "bonds", H5P_DEFAULT), H5Dclose, "connectivity/bonds");
  write_reference(bonds, "particles_group", file_, "particles/beads");
  create_group(file_, "observables");
  create_group(file_, "swimmers");
}

void TrajectoryWriter::write_metadata(const TrajectoryHeader& header) {
  const H5Handle h5md = create_group(file_, "h5md");
  write_attribute(h5md, "version", std::array{1, 1});
  const H5Handle author = create_group(h5md, "author");
  write_attribute(author, "name", "unknown");
  const H5Handle creator = create_group(h5md, "creator");
  write_attribute(creator, "name", "beadswim-run");
  write_attribute(creator, "version", header.creator_version);
  const H5Handle parameters = create_group(file_, "parameters");
  for (const auto& [name, text] : header.parameters) write_dataset(parameters, name, text);
}

H5Handle TrajectoryWriter::create_series(const std::string& name, hid_t type,
                                         const std::vector<hsize_t>& row) {
  std::vector<hsize_t> extents{0}, max_extents{H5S_UNLIMITED};
  hsize_t bytes = H5Tget_size(type);
  for (const hsize_t n : row) bytes *= n;
  std::vector<hsize_t> chunk{std::max<hsize_t>(1, chunk_bytes / std::max<hsize_t>(1, bytes))};
  for (auto* shape : {&extents, &max_extents, &chunk}) shape->insert(shape->end(), row.begin(), row.end());

  const H5Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), max_extents.data()),
                       H5Sclose, name);
  const H5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
  check_hdf5(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), name);
  if (bytes >= chunk_bytes) {
    check_hdf5(H5Pset_shuffle(creation), name);
    check_hdf5(H5Pset_deflate(creation, 4), name);
  }
  check_hdf5(H5Pset_obj_track_times(creation, false), name);
  return {H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, name};
}

void TrajectoryWriter::add_series(const std::string& name, hid_t type, std::vector<hsize_t> row) {
  const std::string what = path_ + ":/" + name;
  H5Handle dataset = continues_checkpoint_
                         ? H5Handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, what)
                         : create_series(name, type, row);
  const H5Handle space(H5Dget_space(dataset), H5Sclose, what);
  std::vector<hsize_t> extent(row.size() + 1);
  if (H5Sget_simple_extent_ndims(space) != std::ssize(extent))
    throw SolverError(
        what +
        fmt::format(": this dataset of the trajectory has a wrong number of dimensions in the checkpoint; "
                    "take the run's other checkpoint (.ckpt.0 or .ckpt.1), or begin without {}",
                    Setting::restart));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  series_.emplace(
      name, Series{.dataset = std::move(dataset), .row = std::move(row), .type = type, .rows = extent[0]});
}

void TrajectoryWriter::add_element(Sampling& sampling, const std::string& name, hid_t type,
                                   std::vector<hsize_t> row) {
  if (!continues_checkpoint_) create_group(file_, name);
  if (sampling.step_name.empty()) {
    sampling = {.step_name = name + "/step", .time_name = name + "/time"};
    add_series(sampling.step_name, H5T_NATIVE_INT64, {});
    add_series(sampling.time_name, H5T_NATIVE_DOUBLE, {});
  } else if (!continues_checkpoint_) {
    for (const auto& [target, link] : {std::pair{sampling.step_name, "/step"}, {sampling.time_name, "/time"}})
      check_hdf5(
          H5Lcreate_hard(file_, target.c_str(), file_, (name + link).c_str(), H5P_DEFAULT, H5P_DEFAULT),
          name);
  }
  add_series(name + "/value", type, std::move(row));
}

void TrajectoryWriter::append_row(const std::string& name, const void* data) {
  Series& series = series_.at(name);
  std::vector<hsize_t> extent{series.rows + 1}, start{series.rows}, count{1};
  extent.insert(extent.end(), series.row.begin(), series.row.end());
  start.insert(start.end(), series.row.size(), 0);
  count.insert(count.end(), series.row.begin(), series.row.end());
  const std::string what = path_ + ":/" + name;
  require_written(H5Dset_extent(series.dataset, extent.data()));

  const H5Handle in_file(H5Dget_space(series.dataset), H5Sclose, what);
  const H5Handle in_memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose,
                           what);
  check_hdf5(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
             what);
  require_written(H5Dwrite(series.dataset, series.type, in_memory, in_file, H5P_DEFAULT, data));
  ++series.rows;
}

void TrajectoryWriter::flush() const {
  require_written(H5Fflush(file_, H5F_SCOPE_GLOBAL));
}

void TrajectoryWriter::require_written(herr_t status) const {
  if (status < 0)
    throw SolverError(part_name(path_) + ": HDF5 cannot write the trajectory; is the disk full?");
}

void TrajectoryWriter::append(const TrajectoryFrame& frame) {
  run_on_root([&] {
    const WrappedPositions wrapped = wrap(frame.positions, box_);
    const std::vector<float> velocities = flattened(frame.velocities);
    const Eigen::Matrix3d edges = (box_ ? box_->lengths : Vec3::Zero()).asDiagonal();
    append_row("particles/beads/box/edges/value", edges.data());
    append_row("particles/beads/position/value", wrapped.position.data());
    append_row("particles/beads/image/value", wrapped.image.data());
    append_row("particles/beads/velocity/value", velocities.data());
    append_row("observables/mean_flow/value", frame.mean_flow.data());
    append_row("observables/momentum/value", frame.momentum.data());
    flush();  // on a full disk, no row has a time before its numbers are written
    append_row(frames_.step_name, &frame.step);
    append_row(frames_.time_name, &frame.time);
    flush();
  });
}

void TrajectoryWriter::append(const TrajectoryCycle& cycle) {
  run_on_root([&] {
    for (const Column& column : cycle.columns)
      append_row(swimmers_group + column.name + "/value", column.numbers.data());
    flush();
    append_row(cycles_.step_name, &cycle.step);
    append_row(cycles_.time_name, &cycle.time);
    flush();
  });
}

void TrajectoryWriter::add_to(CheckpointWriter& checkpoint) const {
  checkpoint.add_file(trajectory_section, part_name(path_));
}

TrajectoryWriter::Lock::~Lock() {
  if (descriptor >= 0) close(descriptor);
}

void TrajectoryWriter::finish() {
  run_on_root([&] {
    for (auto& [name, series] : series_) series.dataset.close_checked(path_ + ":/" + name);
    file_.close_checked(path_);
    if (const int reason = name_finished_file(path_); reason != 0) {
      throw SolverError(
          fmt::format("the complete trajectory {} cannot be renamed to {}: {}; rename the file by hand",
                      part_name(path_), path_, std::strerror(reason)));
    }
  });
}

}  // namespace beadswim
