#pragma once

#include <functional>
#include <string>

#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// One benchmark case of beadswim-bench. `step` performs one time step of the lattice, or loads and stores
/// all arrays once, on the cells of this rank.
struct BenchCase {
  std::string name;
  Precision precision = Precision::fp64;
  std::function<void()> step;
};

}  // namespace beadswim
