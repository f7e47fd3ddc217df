#pragma once

#include <string>
#include <vector>

#include "beadswim/io/checkpoint_file.hpp"
#include "byte_source.hpp"

namespace beadswim {

/// Contents of a checkpoint in memory.
struct CheckpointContents {
  struct Section {
    std::string name, bytes;
  };
  std::vector<Section> sections;
  Index3 cells = Index3::Zero();
  int components = 0;             ///< numbers per lattice cell; 0: no lattice
  std::vector<double> numbers{};  ///< [component][z][y][x]

  /// Reads a checkpoint. `sections` must contain the names of the sections, and the other members the sizes
  /// to read.
  void read(const CheckpointReader& checkpoint);
  /// Writes the contents as a checkpoint with the correct hash.
  void write(const std::string& path, const Communicator& communicator) const;
  /// Changes the contents as the bytes select: sections are omitted, shortened or changed in places, and the
  /// lattice gets other numbers or another shape.
  void edit(ByteSource& edits);
};

}  // namespace beadswim
