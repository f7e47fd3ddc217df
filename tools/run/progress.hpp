#pragma once

#include <chrono>
#include <optional>

#include "command_line/options.hpp"

namespace beadswim {

/// Tells on stderr how far a run is and how long it will take.
class Progress {
 public:
  /// Of `steps` in all, `first` have been done by an earlier run. Without cells it tells no updates of them.
  Progress(ProgressStyle style, long first, long steps, double steps_per_cycle, std::optional<double> cells);

  void update(long steps_done);
  void finish(long steps_done);  ///< the last word, and the end of the bar's line

 private:
  using Clock = std::chrono::steady_clock;

  void print(long steps_done);

  ProgressStyle style_;
  double first_, steps_, steps_per_cycle_;
  std::optional<double> cells_;
  Clock::time_point start_, last_;
};

}  // namespace beadswim
