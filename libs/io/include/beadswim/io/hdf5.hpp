#pragma once

#include <hdf5.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "beadswim/core/communicator.hpp"

// HDF5 files: groups, attributes, texts, and datasets of numbers that are written and read in hyperslabs. The
// file formats of this library are written with these classes. Invalid or unreadable contents throw DataError
// with the place FILE:/NAME. A file that cannot be written throws SolverError.

namespace beadswim {

/// Owns an HDF5 identifier and closes it in the destructor.
class H5Handle {
 public:
  /// Throws DataError "PLACE: FAULT" if `id` is negative.
  H5Handle(hid_t id, const std::string& place,
           const std::string& fault = "this part of the HDF5 file cannot be read");
  ~H5Handle();
  H5Handle(H5Handle&& other) noexcept : id_(other.release()) {}
  H5Handle& operator=(H5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  operator hid_t() const { return id_; }
  /// Returns the identifier, which then has no owner.
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

 private:
  hid_t id_;
};

/// Type of a Number in memory and in files: char, int, std::int64_t, float or double.
template <class Number>
hid_t number_type() {
  if constexpr (std::same_as<Number, char>) return H5T_NATIVE_CHAR;
  if constexpr (std::same_as<Number, int>) return H5T_NATIVE_INT;
  if constexpr (std::same_as<Number, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::same_as<Number, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::same_as<Number, double>) return H5T_NATIVE_DOUBLE;
}

/// Extents of a dataset or an attribute along its dimensions; empty: a single value.
using Extents = std::vector<hsize_t>;
constexpr hsize_t any_extent = 0;  ///< in the shape of a dataset that is opened: an extent of any size

/// Box of indices in a dataset: `count` indices from `start` on, along each dimension.
struct Hyperslab {
  Extents start, count;
};

/// Way in which the ranks that have opened a file write to a dataset: one rank alone, or all together.
enum class Transfer { independent, collective };

/// A dataset of numbers. `numbers` points to as many numbers as the hyperslab or the row contains. They are
/// converted if the numbers in the file have another type.
class H5Dataset {
 public:
  const Extents& extents() const { return extents_; }
  std::size_t bytes_per_number() const;
  const std::string& place() const { return place_; }

  template <class Number>
  void write(const Hyperslab& part, const Number* numbers, Transfer transfer = Transfer::independent) const {
    write(number_type<Number>(), part, numbers, transfer);
  }
  /// Extends the dataset along its first dimension by one row.
  template <class Number>
  void append_row(const Number* numbers) {
    extend();
    write(rows(extents_[0] - 1, 1), numbers);
  }

  /// Throws DataError if the numbers in the file have a type that a Number cannot represent.
  template <class Number>
  void read(const Hyperslab& part, Number* numbers) const {
    read(number_type<Number>(), part, numbers);
  }
  /// Reads the rows [first, first + count). Throws DataError if the dataset has fewer rows.
  template <class Number>
  std::vector<Number> read_rows(hsize_t first, hsize_t count) const {
    const Hyperslab part = rows(first, count);
    std::vector<Number> numbers(size_of(part.count));
    read(part, numbers.data());
    return numbers;
  }

 private:
  friend class H5File;
  H5Dataset(H5Handle dataset, const std::string& file, const std::string& name);
  static hsize_t size_of(const Extents& extents);
  Hyperslab rows(hsize_t first, hsize_t count) const;
  void extend();
  void write(hid_t type, const Hyperslab& part, const void* numbers, Transfer transfer) const;
  void read(hid_t type, const Hyperslab& part, void* numbers) const;

  std::string file_, place_;
  H5Handle dataset_;
  Extents extents_;
};

/// An HDF5 file. Its bytes depend only on its contents: it stores no times. The names of its objects are
/// paths in the file.
class H5File {
 public:
  enum class Mode { create, update, read };

  /// Opens a file. `format`: page of the file format in docs/formats, for messages. With `ranks`, all ranks
  /// of a communicator open the file together (MPI-IO). Otherwise this process opens it alone, and ignores
  /// the locks of other processes, which may be writing the file.
  H5File(std::string path, Mode mode, std::string format, const Communicator* ranks = nullptr);

  operator hid_t() const { return file_; }
  std::string place_of(const std::string& name) const { return path_ + ":/" + name; }

  bool contains(const std::string& name) const;
  /// Opens a dataset. Throws DataError if it does not exist, does not have the shape `extents`, or declares
  /// more data than the file contains.
  H5Dataset open(const std::string& name, const Extents& extents) const;
  std::string read_text(const std::string& name) const;
  std::vector<std::string> read_attribute(const std::string& object, const std::string& name) const;

  void create_group(const std::string& name) const;
  H5Dataset create(const std::string& name, hid_t type, const Extents& extents) const;
  /// Creates a dataset without rows, for append_row(). `row`: extents of one row.
  H5Dataset create_series(const std::string& name, hid_t type, const Extents& row) const;
  void link(const std::string& target, const std::string& name) const;
  template <class Number>
  void write(const std::string& name, const Number* numbers, const Extents& extents) const {
    create(name, number_type<Number>(), extents).write({Extents(extents.size(), 0), extents}, numbers);
  }
  void write_text(const std::string& name, const std::string& text) const;
  template <class Number>
  void write_attribute(const std::string& object, const std::string& name, const Number* numbers,
                       const Extents& extents) const {
    write_attribute(object, name, number_type<Number>(), extents, numbers);
  }
  /// Write strings of fixed length, padded with zeros.
  void write_attribute(const std::string& object, const std::string& name, const std::string& text) const {
    write_attribute(object, name, std::span(&text, 1), {});
  }
  void write_attribute(const std::string& object, const std::string& name, std::span<const std::string> texts,
                       const Extents& extents) const;
  /// Writes a string of variable length, which h5py reads as text. It reads those of fixed length as bytes.
  void write_variable_attribute(const std::string& object, const std::string& name,
                                const std::string& text) const;
  /// Writes an attribute that refers to the object `target` of the file.
  void write_reference(const std::string& object, const std::string& name, const std::string& target) const;

  void flush() const;
  void close_checked();
  /// Never closes the file. Call this function after an error on one rank only, because closing a file on all
  /// ranks would wait for every rank.
  void leave_open() { file_.release(); }

 private:
  H5Dataset create(const std::string& name, hid_t type, hid_t space, hid_t properties) const;
  void write_attribute(const std::string& object, const std::string& name, hid_t type, const Extents& extents,
                       const void* data) const;

  std::string path_, format_;
  H5Handle file_;
};

}  // namespace beadswim
