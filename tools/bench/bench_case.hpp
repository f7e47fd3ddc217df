#pragma once

#include <functional>
#include <string>

#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// One benchmark case. `step` performs one time step, or one sweep over memory, on the cells of this rank.
struct BenchCase {
  std::string name;
  Precision precision = Precision::fp64;
  std::function<void()> step;
};

}  // namespace beadswim
