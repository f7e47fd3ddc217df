#pragma once

#include <string>
#include <vector>

#include "beadswim/io/checkpoint_file.hpp"
#include "byte_source.hpp"

namespace beadswim {

/// What a checkpoint holds, in memory.
struct CheckpointContents {
  struct Section {
    std::string name, bytes;
  };
  std::vector<Section> sections;
  Index3 cells = Index3::Zero();
  int components = 0;             ///< 0: no lattice
  std::vector<double> numbers{};  ///< [component][z][y][x]

  /// `sections` has the names, the other numbers what is to be read.
  void read(const CheckpointReader& checkpoint);
  /// With the hash that belongs to it.
  void write(const std::string& path, const Communicator& communicator) const;
  /// As the bytes say: sections that are missing, cut, or changed in places; lattices of other numbers and
  /// shapes.
  void edit(ByteSource& edits);
};

}  // namespace beadswim
