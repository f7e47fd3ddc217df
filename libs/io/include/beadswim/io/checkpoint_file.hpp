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

// Checkpoint files in HDF5, from which a run can be continued (docs/formats/checkpoint.md). A checkpoint
// contains named sections of bytes. If the model has a lattice, it also contains numbers for each lattice
// cell. Rank 0 provides the sections. Each rank provides the numbers of one box of lattice cells. A hash of
// the contents detects damaged files. The hash does not depend on the number of ranks. All functions are
// collective unless stated otherwise.

namespace beadswim {

/// Part of a lattice: the box of cells with indices from `offset` to `offset + size` (exclusive) along each
/// axis. `cells` is the number of cells of the complete lattice along each axis. A checkpoint may contain
/// several lattices, with the numbers 0, 1, ...
struct LatticePart {
  Index3 cells, offset, size;
  int lattice = 0;
};

/// Hash of the numbers on a lattice. If parts of a lattice are hashed separately, for example by several
/// ranks, the sum of their hashes is the hash of the lattice. The hash detects damage but is not
/// cryptographic.
class LatticeHash {
 public:
  /// Adds one number to the hash: its index `place` in the lattice and its bits.
  void add(std::uint64_t place, std::uint64_t bits);
  std::uint64_t value = 0;
};

/// Writes a checkpoint. All functions throw SolverError if the file cannot be written. The error may occur on
/// one rank only. This rank must then stop all other ranks.
class CheckpointWriter {
 public:
  /// Creates the temporary file PATH.part.
  CheckpointWriter(const std::string& path, const Communicator& communicator);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Adds a section with the bytes of rank 0. The argument `bytes` of other ranks is ignored.
  void add(const std::string& section, std::span<const char> bytes);
  /// Adds a section with the contents of a file that rank 0 reads.
  void add_file(const std::string& section, const std::string& path);
  /// Adds `components` numbers per lattice cell, of the type Real (float or double). `part` contains the
  /// cells of this rank. fill(c, numbers) must store component c of all these cells in `numbers`, with x as
  /// the fastest index.
  template <class Real>
  void add_lattice(const LatticePart& part, int components,
                   const std::function<void(int, std::span<Real>)>& fill);

  /// Completes the file, flushes it to the disk and renames it to its final name. Replaces an older file.
  void finish();

 private:
  H5Handle create(const std::string& name, hid_t type, std::span<const hsize_t> shape);
  void write_bytes(const H5Handle& dataset, hsize_t first, std::span<const char> bytes);

  std::string path_;
  const Communicator& communicator_;
  H5Handle file_;
  Sha256 hash_;  ///< hash of all sections added so far, on rank 0
  LatticeHash lattice_hash_;
  std::string sections_;
  bool is_finished_ = false;
};

/// Reads a checkpoint.
class CheckpointReader {
 public:
  /// Opens a checkpoint and verifies its hash. Throws the same InputError on all ranks if the file is not a
  /// checkpoint or is damaged.
  CheckpointReader(const std::string& path, const Communicator& communicator);
  ~CheckpointReader();
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;

  const std::string& path() const { return path_; }

  /// Returns the size of a section [byte].
  std::uint64_t size(const std::string& section) const;
  /// Returns the bytes [first, first + count) of a section, on every rank. Throws SolverError if the section
  /// is shorter than first + count bytes.
  std::vector<char> bytes(const std::string& section, std::uint64_t first, std::uint64_t count) const;
  std::string text(const std::string& section) const;
  /// Replaces the contents of a file by a section, on rank 0. `descriptor` is the file descriptor of the open
  /// file on rank 0. Other ranks do nothing.
  void copy_to(const std::string& section, int descriptor) const;
  /// Reads the numbers of the lattice cells in `part`, which may differ between ranks. Calls take(c, numbers)
  /// for each component c; `numbers` has x as the fastest index. Throws SolverError if the lattice in the
  /// file has another size.
  template <class Real>
  void read_lattice(const LatticePart& part, int components,
                    const std::function<void(int, std::span<const Real>)>& take) const;

 private:
  void require_undamaged() const;
  void add_sections(Sha256& hash) const;
  bool has_lattice(int lattice) const;
  /// Returns the hash of the planes z = const of a lattice that this rank reads. The planes are divided
  /// evenly among all ranks.
  std::uint64_t hash_lattice_part(int lattice) const;

  std::string path_;
  const Communicator& communicator_;
  int exceptions_ = std::uncaught_exceptions();  ///< number of active exceptions at construction
  H5Handle file_;
};

}  // namespace beadswim
