#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "beadswim/core/vec3.hpp"

// Flow fields for ParaView and OVITO: VTK image data (.vti) with cell data, and time series of them (.pvd).

namespace beadswim {

/// One field on cells, handed over plane by plane (x fastest, components innermost), so that no file's worth
/// of it need be in memory.
struct VtiField {
  std::string name;
  int components = 1;
  std::function<std::vector<float>(int z)> plane;  ///< called for z = 0, 1, ... in turn
};

/// Writes cells of edge `spacing` from the origin, whole or not at all. Inline base64, one piece: the form
/// that all readers take. Throws SolverError if the file cannot be written.
void write_vti(const std::string& path, const Index3& cells, double spacing,
               const std::vector<VtiField>& fields);

/// One file of a time series; `file` is relative to the .pvd.
struct PvdEntry {
  double time = 0;
  std::string file;
};

void write_pvd(const std::string& path, const std::vector<PvdEntry>& entries);

}  // namespace beadswim
