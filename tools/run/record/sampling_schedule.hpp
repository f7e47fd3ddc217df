#pragma once

#include <span>
#include <vector>

namespace beadswim {

/// Sampling times of a swimmer: sample k is taken at the step nearest to k/per_cycle() periods.
class SamplingSchedule {
 public:
  /// `period`: driving period [step]. There are at most `max_per_cycle` samples per period, and at most one
  /// per step.
  SamplingSchedule(double period, int max_per_cycle);

  int per_cycle() const { return per_cycle_; }
  long number_at(long step) const;       ///< number of the sample nearest to a step
  double time_of(long number) const;     ///< exact time of a sample [step]
  long first_due_from(long step) const;  ///< step of the first sample at or after `step`

 private:
  int per_cycle_;
  double interval_;  ///< [step]
};

/// Sampling times of all swimmer types, queried step by step.
class SamplingSchedules {
 public:
  SamplingSchedules(std::span<const double> periods, int max_per_cycle);

  const SamplingSchedule& of(int type) const { return types_[type].schedule; }
  bool is_any_due(long step) const { return step == next_step_; }
  bool is_due(int type, long step) const { return types_[type].next_step == step; }
  void advance_to(long step);  ///< skips samples before `step`

 private:
  struct Type {
    SamplingSchedule schedule;
    long next_step = 0;
  };
  std::vector<Type> types_;
  long next_step_ = 0;  ///< minimum over all types
};

}  // namespace beadswim
