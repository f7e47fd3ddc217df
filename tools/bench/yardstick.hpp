#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/precision.hpp"

// Memory bandwidth, and an upper bound of the speed of the lattice that follows from it.

namespace beadswim {

struct FreeMemory {
  void operator()(void* p) const { std::free(p); }
};

/// Two arrays far larger than the caches, to measure the memory bandwidth. Each rank has its own arrays.
class Bandwidth {
 public:
  Bandwidth();

  /// Returns the bytes that one call of copy() or scale_in_place() loads and stores on one rank [byte].
  double bytes() const { return 2.0 * sizeof(double) * num_elements; }
  void copy();
  void scale_in_place();

  static constexpr long num_elements = 1L << 25;  ///< length of each array

 private:
  std::unique_ptr<double[], FreeMemory> source_, destination_;
};

/// Memory layout of the 19 arrays (one per lattice direction) of the class StreamYardstick. Distances are
/// numbers of array elements.
struct StreamLayout {
  std::string name;
  std::ptrdiff_t array, row, plane;  ///< distance between the starts of consecutive arrays, rows, planes
};

/// Benchmark that gives an upper bound for the speed of a time step with in-place streaming: it loads and
/// stores the 19 populations of each cell without arithmetic.
class StreamYardstick {
 public:
  StreamYardstick(int edge, Precision precision);

  /// Chooses the memory layout with which sweep() is fastest on this machine. All ranks use the same layout.
  /// Times each layout `rounds` times. Collective.
  void choose_layout(int rounds, const Communicator& communicator);
  const StreamLayout& layout() const { return layout_; }

  void sweep();

 private:
  int edge_;
  Precision precision_;
  StreamLayout layout_;
  std::unique_ptr<void, FreeMemory> memory_;
};

}  // namespace beadswim
