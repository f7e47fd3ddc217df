#include "record/sampling_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadswim {
namespace {

/// Returns the period in time steps. Rounds it to an integer if the difference is a rounding error, so that
/// samples of swimmers with the base period are taken exactly at frames.
double in_steps(double period) {
  const double whole = std::round(period);
  return std::abs(period - whole) < 1e-9 * period ? whole : period;
}

}  // namespace

SamplingSchedule::SamplingSchedule(double period, int max_per_cycle) {
  const double steps = in_steps(period);
  per_cycle_ = static_cast<int>(std::min<double>(max_per_cycle, std::floor(steps)));
  interval_ = steps / per_cycle_;
}

long SamplingSchedule::number_at(long step) const {
  return std::lround(static_cast<double>(step) / interval_);
}

double SamplingSchedule::time_of(long number) const {
  return static_cast<double>(number) * interval_;
}

long SamplingSchedule::first_due_from(long step) const {
  const long number = number_at(step), nearest = std::lround(time_of(number));
  return nearest >= step ? nearest : std::lround(time_of(number + 1));
}

SamplingSchedules::SamplingSchedules(std::span<const double> periods, int max_per_cycle) {
  for (const double period : periods) types_.push_back({.schedule = {period, max_per_cycle}});
}

void SamplingSchedules::advance_to(long step) {
  next_step_ = std::numeric_limits<long>::max();
  for (Type& type : types_) {
    if (type.next_step < step) type.next_step = type.schedule.first_due_from(step);
    next_step_ = std::min(next_step_, type.next_step);
  }
}

}  // namespace beadswim
