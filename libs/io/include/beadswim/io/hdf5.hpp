#pragma once

#include <hdf5.h>

#include <span>
#include <string>

// Wrappers of the C interface of HDF5: handles are closed at the end of their scope, and failures throw.

namespace beadswim {

/// Owns an HDF5 identifier and closes it in the destructor.
class H5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  /// Constructs a handle that owns no identifier.
  H5Handle() = default;

  /// Throws SolverError if `id` is negative. `what` names the object in the message.
  H5Handle(hid_t id, Close close, const std::string& what);
  ~H5Handle();
  H5Handle(H5Handle&& other) noexcept;
  H5Handle& operator=(H5Handle&& other) noexcept;
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;

  operator hid_t() const { return id_; }

  /// Closes the identifier. Throws SolverError if closing fails, for example because buffered data cannot be
  /// written.
  void close_checked(const std::string& what);

  /// Releases the identifier without closing it. Call this function after an error on one rank only, because
  /// closing a file on all ranks would wait for every rank.
  void leave_open() { id_ = H5I_INVALID_HID; }

 private:
  void close();

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Throws SolverError if `status` is negative. `what` names the object in the message.
void check_hdf5(herr_t status, const std::string& what);

/// Returns true if the file is large enough for a dataset with these extents. Data in chunks may be
/// compressed, and then may be up to 1032 times larger than the file. Call this function before memory for a
/// dataset is allocated and before the dataset is read: a damaged file may declare any extents, and HDF5 does
/// not detect this.
bool has_plausible_extents(hid_t dataset, std::span<const hsize_t> extents);

/// Creates a group without a time stamp, so that the bytes of the file depend only on its contents.
H5Handle create_group(hid_t parent, const std::string& name);

void write_attribute(hid_t object, const std::string& name, const std::string& text);
/// Writes a string of variable length, which h5py reads as text. It reads those of fixed length as bytes.
void write_variable_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, int value);
void write_attribute(hid_t object, const std::string& name, std::span<const int> values);
/// Writes an array of strings of fixed length, padded with zeros.
void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts);

/// Write small datasets whose contents are equal on all ranks. Collective.
void write_dataset(hid_t parent, const std::string& name, const std::string& text);
void write_dataset(hid_t parent, const std::string& name, std::span<const int> values);
void write_dataset(hid_t parent, const std::string& name, std::span<const double> values);
void write_dataset(hid_t parent, const std::string& name, std::span<const std::array<int, 2>> pairs);

/// Adds an attribute that refers to the object `target` of a file.
void write_reference(hid_t object, const std::string& name, hid_t file, const std::string& target);

}  // namespace beadswim
