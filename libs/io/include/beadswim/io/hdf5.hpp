#pragma once

#include <hdf5.h>

#include <span>
#include <string>

// HDF5's C handles, closed with their scope, and its status codes as exceptions.

namespace beadswim {

/// Owns one HDF5 identifier.
class H5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  /// Throws SolverError "what: ..." if id is negative.
  H5Handle(hid_t id, Close close, const std::string& what);
  ~H5Handle();
  H5Handle(H5Handle&& other) noexcept;
  H5Handle& operator=(H5Handle&& other) noexcept;
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;

  operator hid_t() const { return id_; }

  /// Closes before the end of the scope. Throws SolverError if what was left to write could not be.
  void close_checked(const std::string& what);

  /// Forgets it without closing: to close a file of several ranks takes all of them.
  void leave_open() { id_ = H5I_INVALID_HID; }

 private:
  void close();

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Throws SolverError "what: HDF5 failed" if status is negative.
void check_hdf5(herr_t status, const std::string& what);

/// Whether the file stores as many bytes as a dataset of these extents claims: what is compressed may claim a
/// thousand times the file. To be asked before memory is taken for it; and HDF5 itself reads beyond what is
/// stored.
bool stores_all(hid_t dataset, std::span<const hsize_t> extents);

/// Group that forgets when it was made, so that the same contents give the same bytes.
H5Handle create_group(hid_t parent, const std::string& name);

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, int value);
void write_attribute(hid_t object, const std::string& name, std::span<const int> values);
/// One fixed-length string an element, padded with zeros.
void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts);

/// Small datasets that every rank holds alike: the first rank of the file's communicator writes.
void write_dataset(hid_t parent, const std::string& name, const std::string& text);
void write_dataset(hid_t parent, const std::string& name, std::span<const int> values);
void write_dataset(hid_t parent, const std::string& name, std::span<const double> values);

}  // namespace beadswim
