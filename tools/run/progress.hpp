#pragma once

#include <chrono>

#include "beadswim/core/names.hpp"
#include "beadswim/run/model.hpp"

namespace beadswim {

/// Form of the progress messages on standard error. `automatic`: a bar on a terminal, otherwise lines.
enum class ProgressStyle { automatic, bar, lines, json, none };

template <>
inline constexpr auto name_table<ProgressStyle> =
    std::to_array<NamedValue<ProgressStyle>>({{ProgressStyle::automatic, "auto"},
                                              {ProgressStyle::bar, "bar"},
                                              {ProgressStyle::json, "json"},
                                              {ProgressStyle::lines, "lines"},
                                              {ProgressStyle::none, "none"}});

/// Prints on standard error how many cycles of a run are done and the expected time until the run ends.
class Progress {
 public:
  /// The plan must exist as long as this object. No speed (MLUPS) is printed for models without a lattice.
  Progress(ProgressStyle style, const ModelPlan& plan);

  void update(long steps_done);  ///< prints a line if enough time has passed since the last line
  void finish(long steps_done);  ///< prints the last line

 private:
  using Clock = std::chrono::steady_clock;

  void print(long steps_done);

  ProgressStyle style_;
  const ModelPlan& plan_;
  Clock::time_point start_, last_;
};

}  // namespace beadswim
