#pragma once

#include <span>
#include <vector>

namespace beadswim {

/// Sampling times of a swimmer: sample k is taken at the time step nearest to k/per_cycle() driving periods.
class SamplingSchedule {
 public:
  /// `period`: driving period [step]. The schedule has at most `max_per_cycle` samples per period, and at
  /// most one sample per time step.
  SamplingSchedule(double period, int max_per_cycle);

  int per_cycle() const { return per_cycle_; }
  long number_at(long step) const;       ///< number of the sample nearest to a step
  double time_of(long number) const;     ///< exact time of a sample [step]
  long first_due_from(long step) const;  ///< step of the first sample at or after `step`

 private:
  int per_cycle_;
  double interval_;  ///< [step]
};

/// Sampling times for each swimmer type. The caller must query the steps of a run in ascending order.
class SamplingSchedules {
 public:
  SamplingSchedules(std::span<const double> periods, int max_per_cycle);

  const SamplingSchedule& of(int type) const { return types_[type].schedule; }
  bool is_any_due(long step) const { return step == next_step_; }
  bool is_due(int type, long step) const { return types_[type].next_step == step; }
  void advance_to(long step);  ///< skips samples that are due before `step`

 private:
  struct Type {
    SamplingSchedule schedule;
    long next_step = 0;
  };
  std::vector<Type> types_;
  long next_step_ = 0;  ///< smallest next_step of all types
};

}  // namespace beadswim
