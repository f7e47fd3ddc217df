#pragma once

#include <cstdint>
#include <cstdio>
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
  /// Adds a section with the contents of a file, which is open on rank 0.
  void add_file(const std::string& section, std::FILE* file);
  /// Adds `components` numbers per lattice cell, of the type Real (float or double). `part` contains the
  /// cells of this rank. fill(c, numbers) must store component c of all these cells in `numbers`, with x as
  /// the fastest index.
  template <class Real>
  void add_lattice(const LatticePart& part, int components,
                   const std::function<void(int, std::span<Real>)>& fill);

  /// Completes the file, flushes it to the disk and renames it to its final name. Replaces an older file.
  void finish();

 private:
  /// Returns the bytes [first, first + count) of a section that is written. Called on rank 0.
  using Piece = std::function<std::span<const char>(std::uint64_t first, std::uint64_t count)>;
  void add_pieces(const std::string& section, std::uint64_t size, const Piece& piece);

  std::string path_;
  const Communicator& communicator_;
  H5File file_;
  Sha256 hash_;  ///< hash of all sections added so far, on rank 0
  LatticeHash lattice_hash_;
  std::string sections_;
  bool is_finished_ = false;
};

/// Calls read(), which reads a checkpoint. If it throws DataError, throws SolverError with the same message
/// and the remedy: the other checkpoint of the run, or a new run.
void with_checkpoint_remedy(const std::function<void()>& read);

/// Reads a checkpoint. All functions throw DataError if the contents are not as expected.
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
  /// Returns the bytes [first, first + count) of a section, on every rank.
  std::vector<char> bytes(const std::string& section, std::uint64_t first, std::uint64_t count) const;
  /// Returns all bytes of a section, on every rank.
  std::vector<char> bytes(const std::string& section) const { return bytes(section, 0, size(section)); }
  std::string text(const std::string& section) const;
  /// Replaces the contents of a file, which is open on rank 0, by a section. Other ranks do nothing. Throws
  /// SolverError if the file cannot be written.
  void copy_to(const std::string& section, std::FILE* file) const;
  /// Reads the numbers of the lattice cells in `part`, which may differ between ranks. Calls take(c, numbers)
  /// for each component c; `numbers` has x as the fastest index.
  template <class Real>
  void read_lattice(const LatticePart& part, int components,
                    const std::function<void(int, std::span<const Real>)>& take) const;

 private:
  void require_undamaged() const;
  /// Returns the text of an attribute of the file; empty if it does not exist.
  std::string attribute(const std::string& name) const;
  void add_sections(Sha256& hash) const;
  H5Dataset open_lattice(int lattice) const;
  /// Returns the hash of the planes z = const of a lattice that this rank reads. The planes are divided
  /// evenly among all ranks.
  std::uint64_t hash_lattice_part(int lattice) const;

  std::string path_;
  const Communicator& communicator_;
  int exceptions_ = std::uncaught_exceptions();  ///< number of active exceptions at construction
  H5File file_;
};

}  // namespace beadswim
