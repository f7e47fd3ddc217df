#pragma once

#include <functional>
#include <string>

#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// One benchmark case of beadswim-bench. `step` performs one time step of the lattice on this rank, or one
/// pass over arrays that measures the memory.
struct BenchCase {
  std::string name;
  Precision precision = Precision::fp64;
  std::function<void()> step;
  double updates = 0;  ///< cell updates per step, on all ranks together
};

}  // namespace beadswim
