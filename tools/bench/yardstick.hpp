#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Memory layout of the 19 arrays of the yardstick. Lengths and distances are numbers of array elements.
struct StreamLayout {
  std::string name;
  std::ptrdiff_t array, row, plane;  ///< distance between the starts of consecutive arrays, rows, planes

  std::ptrdiff_t num_elements(int edge) const;  ///< from the first element to the last
};

/// Returns the layouts that the yardstick tries for a cube: the layout of the solver, contiguous arrays,
/// arrays that start at different offsets within a page, and arrays interleaved row by row.
std::vector<StreamLayout> stream_layouts(int edge, Precision precision);

/// Upper bound for the speed of a time step in place: a sweep with 19 loads and 19 stores per cell, without
/// arithmetic.
class StreamYardstick {
 public:
  StreamYardstick(int edge, Precision precision);

  /// Chooses the layout with the fastest sweep() on this machine, and the same layout on all ranks. Times
  /// each layout `rounds` times. Collective.
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
