#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "beadswim/core/names.hpp"

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
  /// `first`: number of time steps that an earlier run has completed. `steps`: total number of time steps,
  /// including `first`. `updates_per_step`: number of lattice cells that a step updates; nullopt for models
  /// without a lattice, for which no speed (MLUPS) is printed.
  Progress(ProgressStyle style, long first, long steps, double steps_per_cycle,
           std::optional<double> updates_per_step);

  void update(long steps_done);  ///< prints a line if enough time has passed since the last line
  void finish(long steps_done);  ///< prints the last line

 private:
  using Clock = std::chrono::steady_clock;

  void print(long steps_done);

  ProgressStyle style_;
  double first_, steps_, steps_per_cycle_;
  std::optional<double> updates_per_step_;
  Clock::time_point start_, last_;
};

}  // namespace beadswim
