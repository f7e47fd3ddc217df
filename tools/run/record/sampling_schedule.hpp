#pragma once

#include <span>
#include <vector>

namespace beadswim {

/// When a swimmer is sampled: sample k at the step nearest to k/per_cycle periods.
class SamplingSchedule {
 public:
  /// period: [step]. At most `most_per_cycle` samples a period, and one a step.
  SamplingSchedule(double period, int most_per_cycle);

  int per_cycle() const { return per_cycle_; }
  long number_at(long step) const;       ///< of the sample next to a step
  double time_of(long number) const;     ///< exactly [step]
  long first_due_from(long step) const;  ///< step of the first sample from this step on

 private:
  int per_cycle_;
  double interval_;  ///< [step]
};

/// The schedules of all types of swimmer, asked step by step.
class SamplingSchedules {
 public:
  SamplingSchedules(std::span<const double> periods, int most_per_cycle);

  const SamplingSchedule& of(int type) const { return types_[type].schedule; }
  bool is_any_due(long step) const { return step == next_step_; }
  bool is_due(int type, long step) const { return types_[type].next_step == step; }
  void go_on_from(long step);  ///< earlier samples have been taken

 private:
  struct Type {
    SamplingSchedule schedule;
    long next_step = 0;
  };
  std::vector<Type> types_;
  long next_step_ = 0;  ///< the first of all types'
};

}  // namespace beadswim
