#pragma once

#include <algorithm>
#include <cmath>

namespace beadswim {

/// Sampling times of the swimmers of one type: sample k is taken at the time step nearest to k/per_cycle()
/// driving periods.
class SamplingSchedule {
 public:
  /// `period`: driving period [step]. The schedule has at most `max_per_cycle` samples per period, and at
  /// most one sample per time step. A period that is an integer but for rounding errors is rounded, so that
  /// samples of swimmers with the base period are taken exactly at frames.
  SamplingSchedule(double period, int max_per_cycle) {
    const double whole = std::round(period);
    const double steps = std::abs(period - whole) < 1e-9 * period ? whole : period;
    per_cycle_ = static_cast<int>(std::min<double>(max_per_cycle, std::floor(steps)));
    interval_ = steps / per_cycle_;
  }

  int per_cycle() const { return per_cycle_; }
  long next_step() const { return next_step_; }  ///< step of the next sample
  /// Returns the number of the sample nearest to a step.
  long number_at(long step) const { return std::lround(static_cast<double>(step) / interval_); }
  /// Returns the exact time of a sample [step].
  double time_of(long number) const { return static_cast<double>(number) * interval_; }

  /// Skips samples that are due before `step`, which must not be smaller than in the last call.
  void advance_to(long step) {
    if (next_step_ >= step) return;
    const long number = number_at(step), nearest = std::lround(time_of(number));
    next_step_ = nearest >= step ? nearest : std::lround(time_of(number + 1));
  }

 private:
  int per_cycle_ = 1;
  double interval_ = 1;  ///< [step]
  long next_step_ = 0;
};

}  // namespace beadswim
