#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// Where the yardstick's 19 arrays lie, in numbers.
struct StreamLayout {
  std::string name;
  std::ptrdiff_t array, row, plane;  ///< from one to the next

  std::ptrdiff_t numbers(int edge) const;  ///< that it takes
};

/// The layouts that are tried for a cube: the solver's own, plain arrays, arrays shifted within their pages,
/// and arrays interleaved row by row.
std::vector<StreamLayout> stream_layouts(int edge, Precision precision);

/// What the memory allows a step in place: 19 loads and 19 stores a cell and no arithmetic.
class StreamYardstick {
 public:
  StreamYardstick(int edge, Precision precision);

  /// Takes the layout in which sweep() is fastest on this machine, measured `rounds` times each, the same on
  /// all ranks. Collective.
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
