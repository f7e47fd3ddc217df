#include "beadswim/io/trajectory_reader.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr const char* remedy = "give a trajectory file of beadswim-run (.h5md or .h5md.part)";
constexpr const char* cause = "the file is damaged, or beadswim-run did not write it";
constexpr const char* unreadable = "this part of the HDF5 file cannot be read";
constexpr const char* missing = "this part of the HDF5 file is missing or cannot be read";
constexpr hsize_t max_beads = 100'000'000;  // a larger number indicates a damaged file

[[noreturn]] void throw_input_error(const std::string& place, const std::string& what) {
  throw InputError(place, what + "; " + remedy);
}

/// Throws InputError about the contents of a trajectory file.
[[noreturn]] void throw_content_error(const std::string& place, const std::string& what) {
  throw_input_error(place, what + "; " + cause);
}

/// Returns a handle that closes `id`. Throws InputError with the text `fault` if the id is negative.
H5Handle checked_handle(hid_t id, H5Handle::Close close, const std::string& place,
                        const std::string& fault = unreadable) {
  if (id < 0) throw_content_error(place, fault);
  return {id, close, place};
}

void require_regular_file(const std::string& path) {
  struct stat status {};
  if (path == "-") throw InputError(path, "a trajectory cannot be read from standard input; name the file");
  if (stat(path.c_str(), &status) != 0 || access(path.c_str(), R_OK) != 0) {
    throw_input_error(path, fmt::format("the file cannot be read: {}", std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) throw_input_error(path, "this path is not a regular file");
}

void require_read(herr_t status, const std::string& place) {
  if (status < 0) throw_content_error(place, unreadable);
}

/// Throws InputError if the HDF5 file lacks a group of Beadswim trajectories, because another program wrote
/// it.
void require_groups(hid_t file, const std::string& path) {
  for (const char* group : {"h5md", "particles", "particles/beads", "particles/beads/species"}) {
    if (H5Lexists(file, group, H5P_DEFAULT) > 0) continue;
    throw_input_error(
        path,
        fmt::format("the file is an HDF5 file but not a trajectory of Beadswim: the group /{} is missing",
                    group));
  }
}

/// Opens the file without HDF5's file lock, because an active run holds the lock while it writes the file.
H5Handle open_file(const std::string& path) {
  require_regular_file(path);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // exceptions replace HDF5's error messages on stderr
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path);
  check_hdf5(H5Pset_file_locking(access, false, true), path);
  H5Handle file = checked_handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose, path,
                                 "the file is not an HDF5 file");
  require_groups(file, path);
  return file;
}

std::vector<hsize_t> extents_of(hid_t dataset, const std::string& place) {
  const H5Handle space = checked_handle(H5Dget_space(dataset), H5Sclose, place);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0) throw_content_error(place, "the dimensions of this HDF5 dataset cannot be read");
  std::vector<hsize_t> extents(rank);
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

template <typename Number>
hid_t native_type() {
  if (std::is_floating_point_v<Number>) return H5T_NATIVE_DOUBLE;
  return sizeof(Number) == sizeof(int) ? H5T_NATIVE_INT : H5T_NATIVE_INT64;
}

/// Returns true if numbers of the type `type` in the file can be read as Number. A floating-point Number
/// accepts all numbers. An integer Number accepts integers of at most its own size.
template <typename Number>
bool holds(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  if (std::is_floating_point_v<Number>) return kind == H5T_FLOAT || kind == H5T_INTEGER;
  return kind == H5T_INTEGER && H5Tget_size(type) <= sizeof(Number);
}

/// Splits a sequence of texts of fixed length, which are padded with zeros.
std::vector<std::string> split_padded_texts(const std::string& padded, std::size_t length) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at + length <= padded.size(); at += length) {
    const std::string text = padded.substr(at, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

/// Throws InputError if a dataset declares more data than the file stores.
void require_storage(hid_t dataset, std::span<const hsize_t> extents, const std::string& place) {
  if (!has_plausible_extents(dataset, extents))
    throw_content_error(place, "the dataset declares more data than the file contains");
}

/// Returns the length of a text of this type [byte], or 0 if the type is not a string of fixed length.
std::size_t text_length(hid_t type) {
  const bool fixed = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
  return fixed ? H5Tget_size(type) : 0;
}

std::vector<std::string> text_attribute(hid_t file, const std::string& path, const std::string& object,
                                        const std::string& name) {
  const std::string place = fmt::format("{}:/{}", path, object);
  const H5Handle attribute =
      checked_handle(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                     place, fmt::format("this HDF5 object has no attribute \"{}\"", name));
  const H5Handle type = checked_handle(H5Aget_type(attribute), H5Tclose, place);
  const H5Handle space = checked_handle(H5Aget_space(attribute), H5Sclose, place);
  const std::size_t length = text_length(type);
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
  hsize_t file_size = 0;
  require_read(H5Fget_filesize(file, &file_size), place);
  if (static_cast<double>(length) * static_cast<double>(count) > static_cast<double>(file_size))
    throw_content_error(place,
                        fmt::format("the attribute \"{}\" declares more data than the file contains", name));
  std::string padded(length * count, '\0');
  if (padded.empty() || H5Aread(attribute, type, padded.data()) < 0) {
    throw_content_error(place, fmt::format("the HDF5 attribute \"{}\" is not a string", name));
  }
  return split_padded_texts(padded, length);
}

}  // namespace

TrajectoryReader::TrajectoryReader(const std::string& path)
    : path_(path),
      file_(open_file(path)),
      frames_(std::numeric_limits<std::size_t>::max()),
      beads_(open_table("particles/beads/species", {}).extents[0]),
      step_(open_series("particles/beads/position/step", {})),
      time_(open_series("particles/beads/position/time", {})),
      edges_(open_series("particles/beads/box/edges/value", {3, 3})),
      position_(open_series("particles/beads/position/value", {beads_, 3})),
      image_(open_series("particles/beads/image/value", {beads_, 3})),
      velocity_(open_series("particles/beads/velocity/value", {beads_, 3})),
      mean_flow_(open_series("observables/mean_flow/value", {3})),
      momentum_(open_series("observables/momentum/value", {3})) {
  if (frames_ == 0)
    throw InputError(
        path, "the trajectory contains no frame yet; wait for the first frame of the run, or run again");
  if (beads_ == 0 || beads_ > max_beads)
    throw_content_error(path, fmt::format("the trajectory has {} beads; this number must be between 1 and {}",
                                          beads_, max_beads));
  read_header();
  // On a full disk, a last row can exist whose time is not written and reads as zero.
  if (frames_ > 1 && read_raw_rows<double>(time_, frames_ - 1, 1)[0] == 0) --frames_;
}

TrajectoryReader::Table TrajectoryReader::open_table(const std::string& name,
                                                     std::vector<hsize_t> row) const {
  const std::string place = path_ + ":/" + name;
  H5Handle dataset = checked_handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, place, missing);
  Table table{.place = place, .dataset = std::move(dataset), .extents = {}};
  table.extents = extents_of(table.dataset, place);
  const auto fits = [](hsize_t wanted, hsize_t found) { return wanted == found || wanted == any_width; };
  if (table.extents.size() != row.size() + 1 ||
      !std::equal(row.begin(), row.end(), table.extents.begin() + 1, fits)) {
    throw_content_error(place, "the dataset does not have the shape given in docs/formats/h5md.md");
  }
  require_storage(table.dataset, table.extents, place);
  return table;
}

TrajectoryReader::Table TrajectoryReader::open_series(const std::string& name, std::vector<hsize_t> row) {
  Table table = open_table(name, std::move(row));
  // A run that was killed, or that the disk had no room for, may have extended only some series.
  frames_ = std::min<std::size_t>(frames_, table.extents[0]);
  begun_frames_ = std::max<std::size_t>(begun_frames_, table.extents[0]);
  return table;
}

template <typename Number>
std::vector<Number> TrajectoryReader::read_raw_rows(const Table& table, hsize_t first, hsize_t count) {
  std::vector<hsize_t> start(table.extents.size(), 0), size = table.extents;
  start[0] = first;
  size[0] = count;
  hsize_t numbers = 1;
  for (const hsize_t n : size) numbers *= n;
  const H5Handle type = checked_handle(H5Dget_type(table.dataset), H5Tclose, table.place);
  if (!holds<Number>(type))
    throw_content_error(table.place, "the dataset does not contain numbers of a suitable type");
  const H5Handle in_file = checked_handle(H5Dget_space(table.dataset), H5Sclose, table.place);
  const H5Handle in_memory = checked_handle(H5Screate_simple(1, &numbers, nullptr), H5Sclose, table.place);
  require_read(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr),
               table.place);
  std::vector<Number> values(numbers);
  if (H5Dread(table.dataset, native_type<Number>(), in_memory, in_file, H5P_DEFAULT, values.data()) < 0) {
    throw_content_error(table.place, "the numbers in this HDF5 dataset cannot be read");
  }
  return values;
}

template <typename Number>
std::vector<Number> TrajectoryReader::read_rows(const Table& table, hsize_t first, hsize_t count) {
  std::vector<Number> values = read_raw_rows<Number>(table, first, count);
  const auto is_number = [](Number value) { return std::isfinite(static_cast<double>(value)); };
  if (!std::all_of(values.begin(), values.end(), is_number)) {
    throw_content_error(table.place, "the dataset contains a non-finite number");
  }
  return values;
}

template <typename Number>
std::vector<Number> TrajectoryReader::read_all(const std::string& name) const {
  const Table table = open_table(name, {});
  if (table.extents[0] != beads_)
    throw_content_error(table.place,
                        fmt::format("the dataset does not have {} entries, one per bead", beads_));
  return read_rows<Number>(table, 0, beads_);
}

std::vector<Vec3> TrajectoryReader::vectors(const Table& table, std::size_t frame) const {
  const std::vector<double> numbers = read_rows<double>(table, frame, 1);
  std::vector<Vec3> vectors(numbers.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = Vec3(&numbers[3 * i]);
  return vectors;
}

std::string TrajectoryReader::text(const std::string& name) const {
  const std::string place = path_ + ":/" + name;
  const H5Handle dataset =
      checked_handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose, place, missing);
  const H5Handle type = checked_handle(H5Dget_type(dataset), H5Tclose, place);
  const std::size_t length = text_length(type);
  require_storage(dataset, {}, place);
  std::string padded(length, '\0');
  if (length == 0 || !extents_of(dataset, place).empty() ||
      H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()) < 0) {
    throw_content_error(place, "the HDF5 dataset is not a string");
  }
  return split_padded_texts(padded, length).front();
}

std::map<std::string, std::string> TrajectoryReader::texts(const std::string& group) const {
  const std::string place = path_ + ":/" + group;
  const H5Handle opened_group =
      checked_handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, place, missing);
  H5G_info_t info{};
  require_read(H5Gget_info(opened_group, &info), place);
  std::map<std::string, std::string> result;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 256> name{};
    if (H5Lget_name_by_idx(opened_group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(),
                           H5P_DEFAULT) < 0) {
      throw_content_error(place, unreadable);
    }
    result[name.data()] = text(group + "/" + name.data());
  }
  return result;
}

std::array<Boundary, 3> TrajectoryReader::boundary() const {
  const std::string box = "particles/beads/box";
  const std::vector<std::string> names = text_attribute(file_, path_, box, "boundary");
  if (names.size() != 3)
    throw_content_error(path_ + ":/" + box, "the attribute \"boundary\" does not have three entries");
  std::array<Boundary, 3> boundary;
  for (int a = 0; a < 3; ++a) boundary[a] = names[a] == "periodic" ? Boundary::periodic : Boundary::free_slip;
  return boundary;
}

std::optional<Box> TrajectoryReader::box(std::size_t frame) const {
  const std::vector<double> edges = read_rows<double>(edges_, frame, 1);
  const Box box{.lengths = {edges[0], edges[4], edges[8]}, .boundary = boundary_};
  for (int a = 0; a < 3; ++a) {
    if (!(box.lengths[a] > 0) && (box.is_periodic(a) || box.lengths[a] != 0)) {
      throw_content_error(edges_.place, "the dataset contains a box edge that is not positive");
    }
  }
  return box.lengths == Vec3::Zero() ? std::nullopt : std::optional(box);
}

void TrajectoryReader::read_header() {
  boundary_ = boundary();
  header_.box = box(0);
  header_.swimmer = read_all<int>("particles/beads/swimmer");
  header_.bead = read_all<int>("particles/beads/species");
  header_.radius = read_all<double>("particles/beads/radius");
  if (!std::ranges::all_of(header_.radius, [](double radius) { return radius > 0; }))
    throw_content_error(path_ + ":/particles/beads/radius",
                        "the dataset contains a bead radius that is not positive");
  header_.creator_version = text_attribute(file_, path_, "h5md/creator", "version").front();
  header_.parameters = texts("parameters");
  require_complete_swimmers();
}

void TrajectoryReader::require_complete_swimmers() const {
  for (std::size_t b = 0; b < beads_; ++b) {
    if (header_.bead[b] == 1) continue;
    const bool follows =
        b > 0 && header_.bead[b] == header_.bead[b - 1] + 1 && header_.swimmer[b] == header_.swimmer[b - 1];
    if (!follows)
      throw_content_error(path_ + ":/particles/beads/species",
                          "the numbers of the beads must be 1, 2, 3, ... for the consecutive beads of each "
                          "swimmer");
  }
}

std::vector<double> TrajectoryReader::times() const {
  return read_rows<double>(time_, 0, frames_);
}

TrajectoryFrame TrajectoryReader::frame(std::size_t index) const {
  TrajectoryFrame frame;
  frame.step = read_rows<std::int64_t>(step_, index, 1)[0];
  frame.time = read_rows<double>(time_, index, 1)[0];
  frame.positions = vectors(position_, index);
  frame.velocities = vectors(velocity_, index);
  const std::vector<Vec3> images = vectors(image_, index);
  const std::optional<Box> frame_box = box(index);
  for (std::size_t b = 0; b < beads_ && frame_box; ++b)
    frame.positions[b] += images[b].cwiseProduct(frame_box->lengths);
  if (!std::ranges::all_of(frame.positions, [](const Vec3& position) { return position.allFinite(); }))
    throw_content_error(
        image_.place,
        "the number of a periodic image in this dataset is so large that the position of a bead is not "
        "finite");
  frame.mean_flow = vectors(mean_flow_, index)[0];
  frame.momentum = vectors(momentum_, index)[0];
  return frame;
}

std::vector<TrajectoryCycle> TrajectoryReader::cycles(const std::vector<Column>& columns) const {
  std::vector<TrajectoryCycle> cycles;
  if (H5Lexists(file_, "swimmers", H5P_DEFAULT) <= 0) return cycles;
  const std::string first = "swimmers/" + columns.front().name;
  const Table step = open_table(first + "/step", {}), time = open_table(first + "/time", {});
  hsize_t count = std::min(step.extents[0], time.extents[0]);
  std::vector<Table> tables;
  for (const Column& column : columns) {
    std::vector<hsize_t> row{header_.swimmers()};
    row.insert(row.end(), column.shape.begin(), column.shape.end());
    tables.push_back(open_table("swimmers/" + column.name + "/value", row));
    count = std::min(count, tables.back().extents[0]);  // a killed run may have extended only some tables
  }
  if (count > 0 && read_raw_rows<double>(time, count - 1, 1)[0] == 0) --count;  // not written: full disk
  for (hsize_t c = 0; c < count; ++c) {
    TrajectoryCycle& cycle =
        cycles.emplace_back(TrajectoryCycle{.step = read_rows<std::int64_t>(step, c, 1)[0],
                                            .time = read_rows<double>(time, c, 1)[0],
                                            .columns = columns});
    for (std::size_t i = 0; i < tables.size(); ++i) {
      cycle.columns[i].shape.assign(tables[i].extents.begin() + 2, tables[i].extents.end());
      std::vector<double>& numbers = cycle.columns[i].numbers = read_raw_rows<double>(tables[i], c, 1);
      const auto is_infinite = [](double number) { return std::isinf(number); };
      if (std::ranges::any_of(numbers, is_infinite))
        throw_content_error(tables[i].place, "the dataset contains an infinite number");
    }
  }
  return cycles;
}

}  // namespace beadswim
