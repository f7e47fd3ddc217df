#pragma once

#include <functional>
#include <string>

#include "beadswim/lattice/precision.hpp"

namespace beadswim {

/// What is timed: one step, or one sweep, of this rank's share.
struct BenchCase {
  std::string name;
  Precision precision = Precision::fp64;
  std::function<void()> step;
};

}  // namespace beadswim
