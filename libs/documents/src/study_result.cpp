#include "beadswim/documents/study_result.hpp"

#include <fmt/core.h>

#include <cmath>
#include <span>

namespace beadswim {
namespace {

/// Returns the values of a compared quantity with their uncertainties.
std::vector<ResultValue> with_errors(const ComparedValues& values, const ComparedValues& uncertainties,
                                     ComparedQuantity quantity) {
  std::vector<ResultValue> all;
  const auto found = values.find(quantity);
  if (found == values.end()) return all;
  const auto stated = uncertainties.find(quantity);
  const std::vector<double>& numbers = found->second;
  const std::size_t count = compared_count(quantity, numbers);
  for (std::size_t i = 0; i < count; ++i) {
    const bool has_error = stated != uncertainties.end() && i < stated->second.size();
    all.push_back({.part = count > 1 ? fmt::format("d{}", i + 1) : "",
                   .value = numbers[i],
                   .error = has_error ? stated->second[i] * std::abs(numbers[i]) : 0});
  }
  return all;
}

std::optional<ComparedQuantity> compared(StudyResult result) {
  switch (result) {
    case StudyResult::velocity:
      return ComparedQuantity::velocity;
    case StudyResult::arm_amplitudes:
      return ComparedQuantity::arm_amplitudes;
    case StudyResult::angular_velocity:
      return ComparedQuantity::angular_velocity;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::vector<ResultValue> results_of(const Prediction& prediction, StudyResult result) {
  if (const auto quantity = compared(result))
    return with_errors(swimming_of(prediction), uncertainties_of(prediction), *quantity);
  const std::optional<double>& value =
      result == StudyResult::power ? prediction.power : prediction.efficiency;
  return value ? std::vector<ResultValue>{{.part = "", .value = *value}} : std::vector<ResultValue>{};
}

std::vector<ResultValue> results_of(const RunRecord& run, const SwimmerRecord& swimmer, StudyResult result,
                                    const CycleChoice& cycle, const std::string& source) {
  if (const auto quantity = compared(result))
    return with_errors(swimming_of(run, swimmer, cycle, source), stated_errors_of(run, swimmer, cycle),
                       *quantity);
  double sum = 0;
  const std::span<const CycleStatistics> cycles = select_cycles(swimmer.cycles, cycle, source);
  for (const CycleStatistics& each : cycles) {
    const std::optional<double>& value = result == StudyResult::power ? each.power : each.efficiency;
    if (!value) return {};
    sum += *value;
  }
  return {{.part = "", .value = sum / static_cast<double>(cycles.size())}};
}

}  // namespace beadswim
