#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/temporary_file.hpp"
#include "beadswim/core/vec3.hpp"

// Flow fields for ParaView and OVITO: VTK image data (.vti) with cell data, and time series of such files
// (.pvd).

namespace beadswim {

/// One field on the cells of a lattice. The field is provided one plane z = const at a time, so that the
/// complete field need not be in memory.
struct VtiField {
  std::string name;
  int components = 1;
  bool is_small_integer = false;  ///< written as integers from 0 to 255, otherwise in single precision
  /// Returns the numbers of plane z: all components of each cell, with x as the fastest cell index, then y.
  /// Called for z = 0, 1, ... in this order.
  std::function<std::vector<float>(int z)> plane;
};

/// Cells of a file, a box of cubes, and what is said of all its fields.
struct VtiCells {
  Index3 cells = Index3::Zero();
  double spacing = 1;          ///< edge of a cell [length]
  Vec3 origin = Vec3::Zero();  ///< corner of the first cell [length]
  std::optional<int> mean_cycles{};    ///< cycles over which the fields are averaged; nullopt: one time
  std::optional<int> frame_swimmer{};  ///< id of the swimmer in whose frame they are; nullopt: the box

  Eigen::AlignedBox3d extent() const { return {origin, origin + spacing * cells.cast<double>().matrix()}; }
  /// Visits the numbers that a file has as field data.
  static void visit_numbers(auto&& visit, auto& cells) {
    visit("mean_cycles", cells.mean_cycles);
    visit("frame_swimmer", cells.frame_swimmer);
  }
};

/// Name of the field that hides cells in ParaView, and its value for a hidden cell. It must consist of small
/// integers.
inline constexpr const char* vti_hiding_field = "vtkGhostType";
inline constexpr float vti_hidden = 8;  // vtkDataSetAttributes::REFINEDCELL

/// Writes fields on cells. The file is written completely or not at all. The data are one block of Base64
/// text inside the XML file, a form that all readers support. Throws SolverError if the file cannot be
/// written.
void write_vti(const std::string& path, const VtiCells& cells, const std::vector<VtiField>& fields);

/// Reads a file that write_vti() has written, one plane of cells at a time. All functions throw InputError
/// with file, fault and remedy if the file cannot be read or contains anything else.
class VtiReader {
 public:
  explicit VtiReader(const std::string& path);

  const VtiCells& cells() const { return cells_; }
  bool has(const std::string& field) const { return fields_.contains(field); }
  /// Returns the numbers of a field in plane z, in the order of VtiField::plane. All are finite.
  std::vector<float> plane(const std::string& field, int components, int z) const;

 private:
  struct StoredField {
    int components = 1;
    bool is_small_integer = false;
    std::int64_t start = 0;  ///< place of the Base64 text in the file [byte]

    int number_size() const { return is_small_integer ? 1 : static_cast<int>(sizeof(float)); }
  };

  [[noreturn]] void refuse(const std::string& fault) const;
  /// Returns bytes of the stream (size, then data) that the Base64 text at `start` encodes.
  std::string decoded(std::int64_t start, std::int64_t first_byte, std::int64_t bytes) const;
  void read_cells(const std::string& header);
  std::int64_t read_field(std::int64_t start);

  std::string path_;
  OpenFile file_;
  std::int64_t file_bytes_ = 0;
  VtiCells cells_;
  std::map<std::string, StoredField> fields_;
};

/// One file of a time series. `file` is a path relative to the folder of the .pvd file. Files of the same
/// time are parts of one picture.
struct PvdEntry {
  double time = 0;
  std::string file;
  int part = 0;
};

/// Writes a .pvd file, the index of a time series of .vti files. Throws InputError if the file cannot be
/// created, and SolverError if it cannot be written.
void write_pvd(const std::string& path, const std::vector<PvdEntry>& entries);

/// Returns the entries of a file that write_pvd() has written. Throws InputError if it cannot be read or has
/// other contents.
std::vector<PvdEntry> read_pvd(const std::string& path);

}  // namespace beadswim
