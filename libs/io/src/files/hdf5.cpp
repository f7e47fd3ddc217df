#include "beadswim/io/hdf5.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

H5Handle fixed_string_type(std::size_t length) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "string type");
  check_hdf5(H5Tset_size(type, std::max<std::size_t>(length, 1)), "string type");
  check_hdf5(H5Tset_strpad(type, H5T_STR_NULLPAD), "string type");
  check_hdf5(H5Tset_cset(type, H5T_CSET_UTF8), "string type");
  return type;
}

H5Handle list_space(hsize_t count) {
  return {H5Screate_simple(1, &count, nullptr), H5Sclose, "dataspace"};
}

void write_attribute_data(hid_t object, const std::string& name, hid_t type, hid_t space, const void* data) {
  const H5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "attribute " + name);
  check_hdf5(H5Awrite(attribute, type, data), "attribute " + name);
}

void write_dataset_data(hid_t parent, const std::string& name, hid_t type, hid_t space, const void* data) {
  const H5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "dataset " + name);
  check_hdf5(H5Pset_obj_track_times(creation, false), "dataset " + name);
  const H5Handle dataset(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                         H5Dclose, "dataset " + name);
  check_hdf5(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), "dataset " + name);
}

}  // namespace

H5Handle::H5Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id < 0)
    throw SolverError(what +
                      ": HDF5 cannot open or create this object; is the file damaged or the disk full?");
}

H5Handle::~H5Handle() {
  close();
}

H5Handle::H5Handle(H5Handle&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}

H5Handle& H5Handle::operator=(H5Handle&& other) noexcept {
  if (this != &other) {
    close();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

void H5Handle::close() {
  if (id_ >= 0) close_(id_);
  id_ = H5I_INVALID_HID;
}

void H5Handle::close_checked(const std::string& what) {
  const hid_t id = std::exchange(id_, H5I_INVALID_HID);
  if (id >= 0 && close_(id) < 0)
    throw SolverError(what + ": HDF5 could not finish writing; is the disk full?");
}

void check_hdf5(herr_t status, const std::string& what) {
  if (status < 0)
    throw SolverError(what +
                      ": HDF5 cannot read or write this object; is the file damaged or the disk full?");
}

bool has_plausible_extents(hid_t dataset, std::span<const hsize_t> extents) {
  constexpr double max_compression = 1032;  // upper bound of the compression ratio of deflate
  const std::string what = "dataset";
  try {
    const H5Handle type(H5Dget_type(dataset), H5Tclose, what);
    const H5Handle creation(H5Dget_create_plist(dataset), H5Pclose, what);
    const H5Handle file(H5Iget_file_id(dataset), H5Fclose, what);
    hsize_t file_size = 0;
    check_hdf5(H5Fget_filesize(file, &file_size), what);
    double claimed = static_cast<double>(H5Tget_size(type));
    for (const hsize_t n : extents) claimed *= static_cast<double>(n);
    const bool in_chunks = H5Pget_layout(creation) == H5D_CHUNKED;
    return claimed <= (in_chunks ? max_compression * static_cast<double>(file_size)
                                 : static_cast<double>(H5Dget_storage_size(dataset)));
  } catch (const SolverError&) {
    return false;
  }
}

H5Handle create_group(hid_t parent, const std::string& name) {
  const H5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "group " + name);
  check_hdf5(H5Pset_obj_track_times(creation, false), "group " + name);
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose, "group " + name};
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
  const H5Handle type = fixed_string_type(text.size());
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "dataspace");
  write_attribute_data(object, name, type, space, text.data());
}

void write_variable_attribute(hid_t object, const std::string& name, const std::string& text) {
  const H5Handle type = fixed_string_type(1);
  check_hdf5(H5Tset_size(type, H5T_VARIABLE), "attribute " + name);
  check_hdf5(H5Tset_strpad(type, H5T_STR_NULLTERM), "attribute " + name);
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "dataspace");
  const char* data = text.c_str();
  write_attribute_data(object, name, type, space, &data);
}

void write_attribute(hid_t object, const std::string& name, int value) {
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "dataspace");
  write_attribute_data(object, name, H5T_NATIVE_INT, space, &value);
}

void write_attribute(hid_t object, const std::string& name, std::span<const int> values) {
  write_attribute_data(object, name, H5T_NATIVE_INT, list_space(values.size()), values.data());
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::vector<char> padded(length * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) std::ranges::copy(texts[i], padded.begin() + i * length);
  write_attribute_data(object, name, fixed_string_type(length), list_space(texts.size()), padded.data());
}

void write_dataset(hid_t parent, const std::string& name, const std::string& text) {
  const H5Handle type = fixed_string_type(text.size());
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "dataspace");
  write_dataset_data(parent, name, type, space, text.data());
}

void write_dataset(hid_t parent, const std::string& name, std::span<const int> values) {
  write_dataset_data(parent, name, H5T_NATIVE_INT, list_space(values.size()), values.data());
}

void write_dataset(hid_t parent, const std::string& name, std::span<const double> values) {
  write_dataset_data(parent, name, H5T_NATIVE_DOUBLE, list_space(values.size()), values.data());
}

void write_dataset(hid_t parent, const std::string& name, std::span<const std::array<int, 2>> pairs) {
  const std::array<hsize_t, 2> extents{pairs.size(), 2};
  const H5Handle space(H5Screate_simple(2, extents.data(), nullptr), H5Sclose, "dataspace");
  write_dataset_data(parent, name, H5T_NATIVE_INT, space, pairs.data());
}

void write_reference(hid_t object, const std::string& name, hid_t file, const std::string& target) {
  hobj_ref_t reference = 0;
  check_hdf5(H5Rcreate(&reference, file, target.c_str(), H5R_OBJECT, -1), "reference to " + target);
  const H5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "dataspace");
  write_attribute_data(object, name, H5T_STD_REF_OBJ, space, &reference);
}

}  // namespace beadswim
