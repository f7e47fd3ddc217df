#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Memory layout of the 19 arrays (one per lattice direction) of the class StreamYardstick. Distances are
/// numbers of array elements.
struct StreamLayout {
  std::string name;
  std::ptrdiff_t array, row, plane;  ///< distance between the starts of consecutive arrays, rows, planes

  std::ptrdiff_t num_elements(int edge) const;  ///< elements from the first to the last of all arrays
};

/// Returns the memory layouts that the class StreamYardstick tries for a cube of edge^3 cells: the layout of
/// the solver; contiguous arrays; arrays that start at different offsets within a memory page; arrays
/// interleaved row by row.
std::vector<StreamLayout> stream_layouts(int edge, Precision precision);

/// Benchmark that gives an upper bound for the speed of a time step with in-place streaming: it loads and
/// stores the 19 populations of each cell without arithmetic.
class StreamYardstick {
 public:
  StreamYardstick(int edge, Precision precision);

  /// Chooses the memory layout with which sweep() is fastest on this machine. All ranks use the same layout.
  /// Times each layout `rounds` times. Collective.
  void choose_layout(int rounds, const Communicator& communicator);
  void use(const StreamLayout& layout) { layout_ = layout; }
  const StreamLayout& layout() const { return layout_; }

  void sweep();

 private:
  template <class Real>
  void sweep_as();

  struct Free {
    void operator()(void* p) const { std::free(p); }
  };

  int edge_;
  Precision precision_;
  StreamLayout layout_;
  std::unique_ptr<void, Free> memory_;
};

}  // namespace beadswim
