#include "beadswim/io/hdf5.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

constexpr const char* missing = "this part of the HDF5 file is missing or cannot be read";

/// Throws SolverError if `result`, the result of a function of HDF5 that writes, is negative.
void require_written(hid_t result, const std::string& file) {
  if (result < 0) throw SolverError(file + ": HDF5 cannot write this file; is the disk full?");
}

/// Returns a handle for an object that HDF5 has created in the file.
H5Handle created(hid_t id, const std::string& file) {
  require_written(id, file);
  return {id, file};
}

H5Handle dataspace(const Extents& extents, const std::string& place, const hsize_t* max_extents = nullptr) {
  return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), max_extents), place};
}

/// Returns the part of a dataset in the file.
H5Handle selection(hid_t dataset, const Hyperslab& part, const std::string& place) {
  H5Handle space(H5Dget_space(dataset), place);
  const auto& [start, count] = part;
  const bool is_single = start.empty();
  if (!is_single &&
      H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0)
    throw DataError(place, "this part of the HDF5 dataset cannot be selected");
  return space;
}

/// Returns the type of texts of fixed length that are padded with zeros, or of variable length.
H5Handle text_type(std::size_t length, const std::string& file) {
  H5Handle type(H5Tcopy(H5T_C_S1), file);
  const H5T_str_t padding = length == H5T_VARIABLE ? H5T_STR_NULLTERM : H5T_STR_NULLPAD;
  require_written(std::min({H5Tset_size(type, std::max<std::size_t>(length, 1)), H5Tset_strpad(type, padding),
                            H5Tset_cset(type, H5T_CSET_UTF8)}),
                  file);
  return type;
}

/// Returns the length of a text of this type [byte], or 0 if the type is not a string of fixed length.
std::size_t text_length(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 ? H5Tget_size(type) : 0;
}

/// Returns `count` texts that read(bytes) reads; an empty list if they cannot be read or are not strings of
/// fixed length.
std::vector<std::string> read_texts(hid_t type, std::size_t count, auto&& read) {
  const std::size_t length = text_length(type);
  std::string padded(length * count, '\0');
  if (padded.empty() || read(padded.data()) < 0) return {};
  std::vector<std::string> texts;
  for (const char* at = padded.data(); texts.size() < count; at += length)
    texts.emplace_back(at, strnlen(at, length));
  return texts;
}

/// Returns true if the type `memory` can represent numbers of the type `file`. A floating-point type accepts
/// all numbers, an integer type accepts integers of at most its own size.
bool can_represent(hid_t memory, hid_t file) {
  const H5T_class_t kind = H5Tget_class(file);
  if (H5Tget_class(memory) == H5T_FLOAT) return kind == H5T_FLOAT || kind == H5T_INTEGER;
  return kind == H5T_INTEGER && H5Tget_size(file) <= H5Tget_size(memory);
}

Extents extents_of(hid_t dataset, const std::string& place) {
  const H5Handle space(H5Dget_space(dataset), place);
  const int dimensions = H5Sget_simple_extent_ndims(space);
  if (dimensions < 0) throw DataError(place, "the dimensions of this HDF5 dataset cannot be read");
  Extents extents(dimensions);
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

double file_size(hid_t file) {
  hsize_t size = 0;
  H5Fget_filesize(file, &size);
  return static_cast<double>(size);
}

/// Throws DataError if the file is too small for a dataset with these extents. Data in chunks may be
/// compressed. Call this function before memory for a dataset is allocated: a damaged file may declare any
/// extents, and HDF5 does not detect this.
void require_stored(hid_t dataset, hid_t file, const Extents& extents, const std::string& place) {
  constexpr double max_compression = 1032;  // upper bound of the compression ratio of deflate
  const H5Handle type(H5Dget_type(dataset), place), properties(H5Dget_create_plist(dataset), place);
  double declared = static_cast<double>(H5Tget_size(type));
  for (const hsize_t n : extents) declared *= static_cast<double>(n);
  const bool is_in_chunks = H5Pget_layout(properties) == H5D_CHUNKED;
  if (declared >
      (is_in_chunks ? max_compression * file_size(file) : static_cast<double>(H5Dget_storage_size(dataset))))
    throw DataError(place, "the dataset declares more data than the file contains");
}

H5Handle open_file(const std::string& path, H5File::Mode mode, const Communicator* ranks) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // exceptions replace HDF5's error messages on stderr
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), path);
  require_written(ranks != nullptr ? H5Pset_fapl_mpio(access, ranks->get(), MPI_INFO_NULL)
                                   : H5Pset_file_locking(access, false, true),
                  path);
  if (mode != H5File::Mode::create) {
    const unsigned flags = mode == H5File::Mode::update ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
    return {H5Fopen(path.c_str(), flags, access), path, "the file is not an HDF5 file"};
  }
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  if (file < 0) throw SolverError(path + ": the file cannot be created; is the disk full?");
  return {file, path};
}

}  // namespace

H5Handle::H5Handle(hid_t id, const std::string& place, const std::string& fault) : id_(id) {
  if (id < 0) throw DataError(place, fault);
}

H5Handle::~H5Handle() {
  if (id_ >= 0) H5Idec_ref(id_);
}

H5Dataset::H5Dataset(H5Handle dataset, const std::string& file, const std::string& name)
    : file_(file),
      place_(file + ":/" + name),
      dataset_(std::move(dataset)),
      extents_(extents_of(dataset_, place_)) {}

std::size_t H5Dataset::bytes_per_number() const {
  return H5Tget_size(H5Handle(H5Dget_type(dataset_), place_));
}

hsize_t H5Dataset::size_of(const Extents& extents) {
  return std::accumulate(extents.begin(), extents.end(), hsize_t{1}, std::multiplies<>());
}

Hyperslab H5Dataset::rows(hsize_t first, hsize_t count) const {
  if (count > extents_[0] || first > extents_[0] - count)
    throw DataError(place_, "the dataset ends too early");
  Hyperslab rows{.start = Extents(extents_.size(), 0), .count = extents_};
  rows.start[0] = first;
  rows.count[0] = count;
  return rows;
}

void H5Dataset::extend() {
  Extents extended = extents_;
  ++extended[0];
  require_written(H5Dset_extent(dataset_, extended.data()), file_);
  extents_ = extended;
}

void H5Dataset::write(hid_t type, const Hyperslab& part, const void* numbers, Transfer transfer) const {
  const H5Handle properties(H5Pcreate(H5P_DATASET_XFER), place_);
  if (transfer == Transfer::collective)
    require_written(H5Pset_dxpl_mpio(properties, H5FD_MPIO_COLLECTIVE), file_);
  const H5Handle in_memory = dataspace(part.count, place_), in_file = selection(dataset_, part, place_);
  require_written(H5Dwrite(dataset_, type, in_memory, in_file, properties, numbers), file_);
}

void H5Dataset::read(hid_t type, const Hyperslab& part, void* numbers) const {
  if (size_of(part.count) == 0) return;
  if (!can_represent(type, H5Handle(H5Dget_type(dataset_), place_)))
    throw DataError(place_, "the dataset does not contain numbers of a suitable type");
  const H5Handle in_memory = dataspace(part.count, place_), in_file = selection(dataset_, part, place_);
  if (H5Dread(dataset_, type, in_memory, in_file, H5P_DEFAULT, numbers) < 0)
    throw DataError(place_, "the numbers in this HDF5 dataset cannot be read");
}

H5File::H5File(std::string path, Mode mode, std::string format, const Communicator* ranks)
    : path_(std::move(path)), format_(std::move(format)), file_(open_file(path_, mode, ranks)) {}

bool H5File::contains(const std::string& name) const {
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

H5Dataset H5File::open(const std::string& name, const Extents& extents) const {
  H5Dataset dataset({H5Dopen2(file_, name.c_str(), H5P_DEFAULT), place_of(name), missing}, path_, name);
  const auto fits = [](hsize_t wanted, hsize_t found) { return wanted == found || wanted == any_extent; };
  if (!std::ranges::equal(extents, dataset.extents_, fits))
    throw DataError(dataset.place_, "the dataset does not have the shape given in " + format_);
  require_stored(dataset.dataset_, file_, dataset.extents_, dataset.place_);
  return dataset;
}

std::string H5File::read_text(const std::string& name) const {
  const std::string place = place_of(name);
  const H5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), place, missing);
  const H5Handle type(H5Dget_type(dataset), place);
  require_stored(dataset, file_, {}, place);
  const std::size_t count = extents_of(dataset, place).empty() ? 1 : 0;
  const std::vector<std::string> text = read_texts(
      type, count, [&](char* bytes) { return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes); });
  if (text.empty()) throw DataError(place, "the HDF5 dataset is not a string");
  return text.front();
}

std::vector<std::string> H5File::read_attribute(const std::string& object, const std::string& name) const {
  const std::string place = place_of(object);
  const H5Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                           place, fmt::format("this HDF5 object has no attribute \"{}\"", name));
  const H5Handle type(H5Aget_type(attribute), place), space(H5Aget_space(attribute), place);
  const auto count = static_cast<std::size_t>(std::max<hssize_t>(0, H5Sget_simple_extent_npoints(space)));
  if (static_cast<double>(text_length(type)) * static_cast<double>(count) > file_size(file_))
    throw DataError(place,
                    fmt::format("the attribute \"{}\" declares more data than the file contains", name));
  std::vector<std::string> texts =
      read_texts(type, count, [&](char* bytes) { return H5Aread(attribute, type, bytes); });
  if (texts.empty()) throw DataError(place, fmt::format("the HDF5 attribute \"{}\" is not a string", name));
  return texts;
}

void H5File::create_group(const std::string& name) const {
  const H5Handle properties(H5Pcreate(H5P_GROUP_CREATE), path_);
  require_written(H5Pset_obj_track_times(properties, false), path_);
  created(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), path_);
}

H5Dataset H5File::create(const std::string& name, hid_t type, hid_t space, hid_t properties) const {
  require_written(H5Pset_obj_track_times(properties, false), path_);
  const hid_t id = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  return {created(id, path_), path_, name};
}

H5Dataset H5File::create(const std::string& name, hid_t type, const Extents& extents) const {
  const H5Handle properties(H5Pcreate(H5P_DATASET_CREATE), path_);
  require_written(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER), path_);
  return create(name, type, dataspace(extents, path_), properties);
}

H5Dataset H5File::create_series(const std::string& name, hid_t type, const Extents& row) const {
  // Rows of at least this size [byte] are stored in compressed chunks of their own. Smaller rows share
  // uncompressed chunks. In both cases, writing a row does not move data of earlier rows.
  constexpr hsize_t chunk_bytes = 16384;
  const hsize_t bytes = H5Tget_size(type) * H5Dataset::size_of(row);
  Extents extents{0}, max_extents{H5S_UNLIMITED};
  Extents chunk{std::max<hsize_t>(1, chunk_bytes / std::max<hsize_t>(1, bytes))};
  for (Extents* shape : {&extents, &max_extents, &chunk}) shape->insert(shape->end(), row.begin(), row.end());
  const H5Handle properties(H5Pcreate(H5P_DATASET_CREATE), path_);
  require_written(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), path_);
  if (bytes >= chunk_bytes)
    require_written(std::min({H5Pset_shuffle(properties), H5Pset_deflate(properties, 4)}), path_);
  return create(name, type, dataspace(extents, path_, max_extents.data()), properties);
}

void H5File::link(const std::string& target, const std::string& name) const {
  require_written(H5Lcreate_hard(file_, target.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                  path_);
}

void H5File::write_text(const std::string& name, const std::string& text) const {
  const H5Handle type = text_type(text.size(), path_);
  create(name, type, Extents{}).write(type, {}, text.data(), Transfer::independent);
}

void H5File::write_attribute(const std::string& object, const std::string& name, hid_t type,
                             const Extents& extents, const void* data) const {
  const hid_t id = H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, dataspace(extents, path_),
                                     H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  require_written(H5Awrite(created(id, path_), type, data), path_);
}

void H5File::write_attribute(const std::string& object, const std::string& name,
                             std::span<const std::string> texts, const Extents& extents) const {
  const std::size_t length = std::ranges::max(texts, {}, &std::string::size).size();
  std::string padded;
  for (const std::string& text : texts) padded += text + std::string(length - text.size(), '\0');
  write_attribute(object, name, text_type(length, path_), extents, padded.data());
}

void H5File::write_variable_attribute(const std::string& object, const std::string& name,
                                      const std::string& text) const {
  const char* data = text.c_str();
  write_attribute(object, name, text_type(H5T_VARIABLE, path_), {}, &data);
}

void H5File::write_reference(const std::string& object, const std::string& name,
                             const std::string& target) const {
  hobj_ref_t reference = 0;
  require_written(H5Rcreate(&reference, file_, target.c_str(), H5R_OBJECT, -1), path_);
  write_attribute(object, name, H5T_STD_REF_OBJ, {}, &reference);
}

void H5File::flush() const {
  require_written(H5Fflush(file_, H5F_SCOPE_GLOBAL), path_);
}

void H5File::close_checked() {
  require_written(H5Idec_ref(file_.release()), path_);
}

}  // namespace beadswim
