#include "beadswim/io/h5md.hpp"

#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "beadswim/core/error.hpp"
#include "beadswim/core/rank_failure.hpp"
#include "beadswim/core/setting.hpp"
#include "part_file.hpp"

namespace beadswim {
namespace {

// The quantities of each cycle are in a separate group, outside the H5MD groups, because MDAnalysis expects
// one value per frame in every series of the H5MD group /observables.
const std::string swimmers_group = "swimmers/";
constexpr const char* trajectory_section = "trajectory";  ///< name of a section of the checkpoint

/// Creates and locks PATH.part. The lock lasts until the file is closed. Throws InputError if the trajectory
/// cannot be created.
OpenFile lock_output(const std::string& path) {
  const auto require = [](bool is_fine, const std::string& fault) {
    if (!is_fine)
      throw InputError(Setting::output,
                       fault + "; name a file in a folder that exists and can be written to");
  };
  struct stat existing {};
  require(path != "-" && !path.ends_with('/'), fmt::format("\"{}\" is not the name of a file", path));
  require(stat(path.c_str(), &existing) != 0 || S_ISREG(existing.st_mode),
          fmt::format("the path {} exists and is not a regular file", path));
  OpenFile part(std::fopen(part_name(path).c_str(), "a+e"));  // keeps its contents until it is locked
  require(part != nullptr,
          fmt::format("the file {} cannot be created: {}", part_name(path), std::strerror(errno)));
  require(flock(fileno(part.get()), LOCK_EX | LOCK_NB) == 0,
          fmt::format("the file {} is being written by another run", part_name(path)));
  return part;
}

/// Writes all that does not depend on time.
void write_header(const H5File& file, const TrajectoryHeader& header) {
  for (const char* group : {"h5md", "h5md/author", "h5md/creator", "parameters"}) file.create_group(group);
  file.write_attribute("h5md", "version", std::array{1, 1}.data(), {2});
  file.write_attribute("h5md/author", "name", "unknown");
  file.write_attribute("h5md/creator", "name", "beadswim-run");
  file.write_attribute("h5md/creator", "version", header.creator_version);
  file.write_text("parameters/layout", header.layout);

  const std::string beads = "particles/beads", bonds = "connectivity/bonds";
  for (const std::string& group : {std::string("particles"), beads, beads + "/box"}) file.create_group(group);
  std::array<std::string, 3> boundary;
  for (int a = 0; a < 3; ++a) boundary[a] = header.box && header.box->is_periodic(a) ? "periodic" : "none";
  const int dimension = 3;
  file.write_attribute(beads + "/box", "dimension", &dimension, {});
  file.write_attribute(beads + "/box", "boundary", boundary, {3});
  file.write(beads + "/species", header.bead.data(), {header.bead.size()});
  file.write(beads + "/swimmer", header.swimmer.data(), {header.swimmer.size()});
  file.write(beads + "/radius", header.radius.data(), {header.radius.size()});
  file.create_group("connectivity");
  file.write(bonds, header.bonds.empty() ? nullptr : header.bonds.front().data(), {header.bonds.size(), 2});
  file.write_reference(bonds, "particles_group", beads);
  for (const char* group : {"observables", "swimmers"}) file.create_group(group);
}

/// Series of the vectors of forces and drives.
constexpr std::array force_series{"particles/beads/force", "particles/beads/drive"};

/// `time`: name of the dataset with the times of frames.
void write_units(const H5File& file, const TrajectoryHeader& header, const std::string& time) {
  const std::string velocity_unit = header.length_unit + " " + header.time_unit + "-1";
  for (const auto& [name, unit] : {std::pair{time, header.time_unit},
                                   {"particles/beads/position/value", header.length_unit},
                                   {"particles/beads/box/edges/value", header.length_unit},
                                   {"particles/beads/velocity/value", velocity_unit},
                                   {"observables/mean_flow/value", velocity_unit}})
    file.write_variable_attribute(name, "unit", unit);
}

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
      continues_checkpoint_(checkpoint != nullptr) {
  run_on_root(
      [&] {
        lock_ = lock_output(path);
        with_checkpoint_remedy([&] {
          if (checkpoint != nullptr) checkpoint->copy_to(trajectory_section, lock_.get());
          open(header);
        });
      },
      communicator_);
}

void TrajectoryWriter::open(const TrajectoryHeader& header) {
  file_.emplace(part_name(path_), continues_checkpoint_ ? H5File::Mode::update : H5File::Mode::create,
                "docs/formats/h5md.md");
  if (!continues_checkpoint_) write_header(*file_, header);
  const hsize_t beads = header.bead.size();
  add_element(frames_, "particles/beads/box/edges", number_type<double>(), {3, 3});
  add_element(frames_, "particles/beads/position", number_type<float>(), {beads, 3});
  add_element(frames_, "particles/beads/image", number_type<int>(), {beads, 3});
  add_element(frames_, "particles/beads/velocity", number_type<float>(), {beads, 3});
  for (const char* name : header.has_forces ? force_series : std::span<const char* const>{})
    add_element(frames_, name, number_type<float>(), {beads, 3});
  if (header.has_forces && !continues_checkpoint_)
    file_->write_variable_attribute(force_series[0], "meaning",
                                    "force of the fluid on the bead, not the total force");
  add_element(frames_, "observables/mean_flow", number_type<double>(), {3});
  add_element(frames_, "observables/momentum", number_type<double>(), {3});
  if (!continues_checkpoint_ && !header.length_unit.empty()) write_units(*file_, header, frames_ + "/time");
  for (const Column& column : header.cycle_columns) {
    Extents row{header.swimmers()};
    row.insert(row.end(), column.shape.begin(), column.shape.end());
    add_element(cycles_, swimmers_group + column.name, number_type<double>(), row);
  }
}

void TrajectoryWriter::add_series(const std::string& name, hid_t type, const Extents& row) {
  Extents any_rows{any_extent};
  any_rows.insert(any_rows.end(), row.begin(), row.end());
  series_.emplace(
      name, continues_checkpoint_ ? file_->open(name, any_rows) : file_->create_series(name, type, row));
}

void TrajectoryWriter::add_element(std::string& sampling, const std::string& name, hid_t type,
                                   const Extents& row) {
  if (!continues_checkpoint_) file_->create_group(name);
  if (sampling.empty()) {
    sampling = name;
    add_series(sampling + "/step", number_type<std::int64_t>(), {});
    add_series(sampling + "/time", number_type<double>(), {});
  } else if (!continues_checkpoint_) {
    for (const char* shared : {"/step", "/time"}) file_->link(sampling + shared, name + shared);
  }
  add_series(name + "/value", type, row);
}

void TrajectoryWriter::append_time(const std::string& sampling, std::int64_t step, double time) {
  file_->flush();
  append_row(sampling + "/step", &step);
  append_row(sampling + "/time", &time);
  file_->flush();
}

void TrajectoryWriter::append(const TrajectoryFrame& frame) {
  run_on_root(
      [&] {
        const WrappedPositions wrapped = wrap(frame.positions, box_);
        const std::vector<float> velocities = flattened(frame.velocities);
        const Eigen::Matrix3d edges = (box_ ? box_->lengths : Vec3::Zero()).asDiagonal();
        append_row("particles/beads/box/edges/value", edges.data());
        append_row("particles/beads/position/value", wrapped.position.data());
        append_row("particles/beads/image/value", wrapped.image.data());
        append_row("particles/beads/velocity/value", velocities.data());
        for (std::size_t n = 0; n < force_series.size() && !frame.forces.empty(); ++n)
          append_row(force_series[n] + std::string("/value"),
                     flattened(n == 0 ? frame.forces : frame.drives).data());
        append_row("observables/mean_flow/value", frame.mean_flow.data());
        append_row("observables/momentum/value", frame.momentum.data());
        append_time(frames_, frame.step, frame.time);
      },
      communicator_);
}

void TrajectoryWriter::append(const TrajectoryCycle& cycle) {
  run_on_root(
      [&] {
        for (const Column& column : cycle.columns)
          append_row(swimmers_group + column.name + "/value", column.numbers.data());
        append_time(cycles_, cycle.step, cycle.time);
      },
      communicator_);
}

void TrajectoryWriter::add_to(CheckpointWriter& checkpoint) const {
  checkpoint.add_file(trajectory_section, lock_.get());
}

void TrajectoryWriter::finish() {
  run_on_root(
      [&] {
        file_->flush();
        series_.clear();
        file_->close_checked();
        if (const int reason = name_finished_file(path_); reason != 0) {
          throw SolverError(
              fmt::format("the complete trajectory {} cannot be renamed to {}: {}; rename the file by hand",
                          part_name(path_), path_, std::strerror(reason)));
        }
      },
      communicator_);
}

}  // namespace beadswim
