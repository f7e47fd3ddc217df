#include "beadswim/io/h5md.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr const char* remedy = "give a trajectory file of beadswim-run (.h5md or .h5md.part)";
constexpr const char* cause = "the file is damaged, or beadswim-run did not write it";
constexpr hsize_t max_beads = 100'000'000;  // a larger number indicates a damaged file
const std::string beads_group = "particles/beads/";

[[noreturn]] void throw_input_error(const std::string& place, const std::string& what) {
  throw InputError(place, what + "; " + remedy);
}

/// Throws InputError about the contents of a trajectory file.
[[noreturn]] void throw_content_error(const DataError& fault) {
  throw InputError(fmt::format("{}; {}; {}", fault.what(), cause, remedy));
}

void require_regular_file(const std::string& path) {
  struct stat status {};
  if (path == "-") throw InputError(path, "a trajectory cannot be read from standard input; name the file");
  if (stat(path.c_str(), &status) != 0 || access(path.c_str(), R_OK) != 0)
    throw_input_error(path, fmt::format("the file cannot be read: {}", std::strerror(errno)));
  if (!S_ISREG(status.st_mode)) throw_input_error(path, "this path is not a regular file");
}

H5File open_file(const std::string& path) {
  require_regular_file(path);
  H5File file(path, H5File::Mode::read, "docs/formats/h5md.md");
  for (const char* group : {"h5md", "particles", "particles/beads", "particles/beads/species"}) {
    if (file.contains(group)) continue;
    throw_input_error(
        path,
        fmt::format("the file is an HDF5 file but not a trajectory of Beadswim: the group /{} is missing",
                    group));
  }
  return file;
}

/// Reads rows of finite numbers.
template <typename Number>
std::vector<Number> finite_rows(const H5Dataset& dataset, hsize_t first, hsize_t count) {
  std::vector<Number> values = dataset.read_rows<Number>(first, count);
  if (!std::ranges::all_of(values, [](Number value) { return std::isfinite(static_cast<double>(value)); }))
    throw DataError(dataset.place(), "the dataset contains a non-finite number");
  return values;
}

/// Reads a dataset with one number per bead.
template <typename Number>
std::vector<Number> numbers_of_beads(const H5File& file, const std::string& name, hsize_t beads) {
  const H5Dataset dataset = file.open(beads_group + name, {any_extent});
  if (dataset.extents()[0] != beads)
    throw DataError(dataset.place(),
                    fmt::format("the dataset does not have {} entries, one per bead", beads));
  return finite_rows<Number>(dataset, 0, beads);
}

/// Reads the vectors of one row.
std::vector<Vec3> vectors(const H5Dataset& dataset, std::size_t row) {
  const std::vector<double> numbers = finite_rows<double>(dataset, row, 1);
  std::vector<Vec3> vectors(numbers.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = Vec3(&numbers[3 * i]);
  return vectors;
}

std::array<Boundary, 3> boundary_of(const H5File& file) {
  const std::string box = beads_group + "box";
  const std::vector<std::string> names = file.read_attribute(box, "boundary");
  if (names.size() != 3)
    throw DataError(file.place_of(box), "the attribute \"boundary\" does not have three entries");
  std::array<Boundary, 3> boundary;
  for (int a = 0; a < 3; ++a) boundary[a] = names[a] == "periodic" ? Boundary::periodic : Boundary::free_slip;
  return boundary;
}

void require_complete_swimmers(const TrajectoryHeader& header, const H5File& file) {
  for (std::size_t b = 0; b < header.bead.size(); ++b) {
    if (header.bead[b] == 1) continue;
    const bool follows =
        b > 0 && header.bead[b] == header.bead[b - 1] + 1 && header.swimmer[b] == header.swimmer[b - 1];
    if (!follows)
      throw DataError(file.place_of(beads_group + "species"),
                      "the numbers of the beads must be 1, 2, 3, ... for the consecutive beads of each "
                      "swimmer");
  }
}

/// Returns true if the last of `rows` rows is not written. On a full disk, such a row can exist. Its time
/// reads as zero.
bool is_last_unwritten(const H5Dataset& time, hsize_t rows) {
  return time.read_rows<double>(rows - 1, 1)[0] == 0;
}

}  // namespace

TrajectoryReader::TrajectoryReader(const std::string& path) try
    : file_(open_file(path)),
      frames_(std::numeric_limits<std::size_t>::max()),
      beads_(file_.open(beads_group + "species", {any_extent}).extents()[0]),
      step_(open_series(beads_group + "position/step", {})),
      time_(open_series(beads_group + "position/time", {})),
      edges_(open_series(beads_group + "box/edges/value", {3, 3})),
      position_(open_series(beads_group + "position/value", {beads_, 3})),
      image_(open_series(beads_group + "image/value", {beads_, 3})),
      velocity_(open_series(beads_group + "velocity/value", {beads_, 3})),
      mean_flow_(open_series("observables/mean_flow/value", {3})),
      momentum_(open_series("observables/momentum/value", {3})) {
  if (frames_ == 0)
    throw InputError(
        path, "the trajectory contains no frame yet; wait for the first frame of the run, or run again");
  if (beads_ == 0 || beads_ > max_beads)
    throw DataError(path, fmt::format("the trajectory has {} beads; this number must be between 1 and {}",
                                      beads_, max_beads));
  read_header();
  if (frames_ > 1 && is_last_unwritten(time_, frames_)) --frames_;
} catch (const DataError& fault) {
  throw_content_error(fault);
}

H5Dataset TrajectoryReader::open_series(const std::string& name, Extents row) {
  row.insert(row.begin(), any_extent);
  H5Dataset series = file_.open(name, row);
  // A run that was killed, or that the disk had no room for, may have extended only some series.
  frames_ = std::min<std::size_t>(frames_, series.extents()[0]);
  begun_frames_ = std::max<std::size_t>(begun_frames_, series.extents()[0]);
  return series;
}

std::optional<Box> TrajectoryReader::box(std::size_t frame) const {
  const std::vector<double> edges = finite_rows<double>(edges_, frame, 1);
  const Box box{.lengths = {edges[0], edges[4], edges[8]}, .boundary = boundary_};
  for (int a = 0; a < 3; ++a)
    if (!(box.lengths[a] > 0) && (box.is_periodic(a) || box.lengths[a] != 0))
      throw DataError(edges_.place(), "the dataset contains a box edge that is not positive");
  return box.lengths == Vec3::Zero() ? std::nullopt : std::optional(box);
}

void TrajectoryReader::read_header() {
  boundary_ = boundary_of(file_);
  header_.box = box(0);
  header_.swimmer = numbers_of_beads<int>(file_, "swimmer", beads_);
  header_.bead = numbers_of_beads<int>(file_, "species", beads_);
  header_.radius = numbers_of_beads<double>(file_, "radius", beads_);
  if (!std::ranges::all_of(header_.radius, [](double radius) { return radius > 0; }))
    throw DataError(file_.place_of(beads_group + "radius"),
                    "the dataset contains a bead radius that is not positive");
  header_.creator_version = file_.read_attribute("h5md/creator", "version").front();
  header_.layout = file_.read_text("parameters/layout");
  require_complete_swimmers(header_, file_);
}

std::vector<double> TrajectoryReader::times() const try {
  return finite_rows<double>(time_, 0, frames_);
} catch (const DataError& fault) {
  throw_content_error(fault);
}

TrajectoryFrame TrajectoryReader::frame(std::size_t index) const try {
  TrajectoryFrame frame;
  frame.step = finite_rows<std::int64_t>(step_, index, 1)[0];
  frame.time = finite_rows<double>(time_, index, 1)[0];
  frame.positions = vectors(position_, index);
  frame.velocities = vectors(velocity_, index);
  const std::vector<Vec3> images = vectors(image_, index);
  const std::optional<Box> frame_box = box(index);
  for (std::size_t b = 0; b < beads_ && frame_box; ++b)
    frame.positions[b] += images[b].cwiseProduct(frame_box->lengths);
  if (!std::ranges::all_of(frame.positions, [](const Vec3& position) { return position.allFinite(); }))
    throw DataError(
        image_.place(),
        "the number of a periodic image in this dataset is so large that the position of a bead is not "
        "finite");
  frame.mean_flow = vectors(mean_flow_, index)[0];
  frame.momentum = vectors(momentum_, index)[0];
  return frame;
} catch (const DataError& fault) {
  throw_content_error(fault);
}

std::vector<TrajectoryCycle> TrajectoryReader::cycles(const std::vector<Column>& columns) const try {
  std::vector<TrajectoryCycle> cycles;
  const std::string first = "swimmers/" + columns.front().name;
  const H5Dataset step = file_.open(first + "/step", {any_extent});
  const H5Dataset time = file_.open(first + "/time", {any_extent});
  hsize_t count = std::min(step.extents()[0], time.extents()[0]);
  std::vector<H5Dataset> values;
  for (const Column& column : columns) {
    Extents extents{any_extent, header_.swimmers()};
    extents.insert(extents.end(), column.shape.begin(), column.shape.end());
    values.push_back(file_.open("swimmers/" + column.name + "/value", extents));
    count = std::min(count, values.back().extents()[0]);  // a killed run may have extended only some
  }
  if (count > 0 && is_last_unwritten(time, count)) --count;
  for (hsize_t c = 0; c < count; ++c) {
    TrajectoryCycle& cycle =
        cycles.emplace_back(TrajectoryCycle{.step = finite_rows<std::int64_t>(step, c, 1)[0],
                                            .time = finite_rows<double>(time, c, 1)[0],
                                            .columns = columns});
    for (std::size_t i = 0; i < values.size(); ++i) {
      cycle.columns[i].shape.assign(values[i].extents().begin() + 2, values[i].extents().end());
      cycle.columns[i].numbers = values[i].read_rows<double>(c, 1);
      if (std::ranges::any_of(cycle.columns[i].numbers, [](double number) { return std::isinf(number); }))
        throw DataError(values[i].place(), "the dataset contains an infinite number");
    }
  }
  return cycles;
} catch (const DataError& fault) {
  throw_content_error(fault);
}

}  // namespace beadswim
