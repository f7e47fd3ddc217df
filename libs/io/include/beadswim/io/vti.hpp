#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

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

/// Cells of a file: a box of cubes.
struct VtiCells {
  Index3 cells;
  double spacing = 1;          ///< edge of a cell [length]
  Vec3 origin = Vec3::Zero();  ///< corner of the first cell [length]
};

/// Name of the field that hides cells in ParaView, and its value for a hidden cell. It must consist of small
/// integers.
inline constexpr const char* vti_hiding_field = "vtkGhostType";
inline constexpr float vti_hidden = 8;  // vtkDataSetAttributes::REFINEDCELL

/// Writes fields on cells. The file is written completely or not at all. The data are one block of Base64
/// text inside the XML file, a form that all readers support. Throws SolverError if the file cannot be
/// written.
void write_vti(const std::string& path, const VtiCells& cells, const std::vector<VtiField>& fields);

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

}  // namespace beadswim
