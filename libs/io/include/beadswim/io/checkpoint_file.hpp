#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/io/hdf5.hpp"

// Checkpoints: HDF5 files of named byte sections, which rank 0 has, and of numbers on a lattice, of which
// each rank has a box (docs/formats/checkpoint.md). A hash of all contents, the same for any number of ranks,
// tells a whole file from a damaged one. All ranks call everything together.

namespace beadswim {

/// A box of cells [offset, offset + size) of a lattice of `cells`.
struct LatticePart {
  Index3 cells, offset, size;
};

/// Hash of numbers on a lattice that adds up over parts in any order. Against damage, not against malice.
class LatticeHash {
 public:
  void add(std::uint64_t place, std::uint64_t bits);
  std::uint64_t value = 0;
};

class CheckpointWriter {
 public:
  /// Begins PATH.part. Throws SolverError, as everything here, if it cannot be written; maybe on one rank
  /// alone, which must then stop the others.
  CheckpointWriter(const std::string& path, const Communicator& communicator);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Rank 0's bytes.
  void add(const std::string& section, std::span<const char> bytes);
  /// The contents of rank 0's file.
  void add_file(const std::string& section, const std::string& path);
  /// Real: float or double. fill(c, numbers) writes component c of the part's cells, x fastest.
  template <class Real>
  void add_lattice(const LatticePart& part, int components,
                   const std::function<void(int, std::span<Real>)>& fill);

  /// Puts the file on the disk, whole, and gives it its name, in place of an older one.
  void finish();

 private:
  H5Handle create(const std::string& name, hid_t type, std::span<const hsize_t> shape);
  void write_bytes(const H5Handle& dataset, hsize_t first, std::span<const char> bytes);

  std::string path_;
  const Communicator& communicator_;
  H5Handle file_;
  Sha256 hash_;  ///< on rank 0
  LatticeHash lattice_hash_;
  std::string sections_;
  bool is_finished_ = false;
};

class CheckpointReader {
 public:
  /// Throws InputError, alike on all ranks, if the file is no checkpoint or not what was written.
  CheckpointReader(const std::string& path, const Communicator& communicator);
  ~CheckpointReader();
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;

  const std::string& path() const { return path_; }

  std::uint64_t size(const std::string& section) const;
  /// Bytes [first, first + count) of a section, on every rank.
  std::vector<char> bytes(const std::string& section, std::uint64_t first, std::uint64_t count) const;
  std::string text(const std::string& section) const;
  /// Writes a section to rank 0's open file, from its start.
  void copy_to(const std::string& section, int descriptor) const;
  /// take(c, numbers) gets component c of the part's cells, x fastest.
  template <class Real>
  void read_lattice(const LatticePart& part, int components,
                    const std::function<void(int, std::span<const Real>)>& take) const;

 private:
  void require_sound() const;
  void add_sections(Sha256& hash) const;
  std::uint64_t hash_of_part() const;  ///< of some planes, one after the other on all ranks

  std::string path_;
  const Communicator& communicator_;
  int exceptions_ = std::uncaught_exceptions();  ///< under way when it was opened
  H5Handle file_;
};

}  // namespace beadswim
