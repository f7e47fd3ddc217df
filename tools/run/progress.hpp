#pragma once

#include <chrono>
#include <optional>

#include "command_line/options.hpp"

namespace beadswim {

/// Prints on stderr how much of a run is done and how long the rest will take.
class Progress {
 public:
  /// `steps`: total number of time steps. `first`: number of steps that an earlier run has completed.
  /// `cells`: number of lattice cells; nullopt for models without a lattice, for which no MLUPS are printed.
  Progress(ProgressStyle style, long first, long steps, double steps_per_cycle, std::optional<double> cells);

  void update(long steps_done);  ///< prints a line if the interval since the last one is over
  void finish(long steps_done);  ///< prints the last line

 private:
  using Clock = std::chrono::steady_clock;

  void print(long steps_done);

  ProgressStyle style_;
  double first_, steps_, steps_per_cycle_;
  std::optional<double> cells_;
  Clock::time_point start_, last_;
};

}  // namespace beadswim
