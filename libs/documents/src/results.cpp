#include "beadswim/documents/results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/scene/units.hpp"

namespace beadswim {
namespace {

/// Motion in one cycle of a run, or as predicted: from it all results are computed. Vectors are in the box.
struct Motion {
  const SwimmerType* type;  ///< nullptr: unknown
  ResultValue velocity;     ///< along the axis
  std::optional<Vec3> velocity_vector, angular_velocity;
  ResultValue arm_amplitudes;
  std::vector<double> arm_phases, arm_means;
  ResultValue sin_phase_shift;
  std::optional<double> power, efficiency;
};

Motion motion_in(const CycleStatistics& cycle, const std::optional<Box>& box, const SwimmerType* type) {
  const std::vector<double>& phases = cycle.arm_phases;
  const Vec3 velocity = vector_relative_to_fluid(cycle, box);
  return {.type = type,
          .velocity = {{velocity_relative_to_fluid(cycle, box)}, velocity},
          .velocity_vector = velocity,
          .angular_velocity = cycle.angular_velocity,
          .arm_amplitudes = {cycle.arm_amplitudes},
          .arm_phases = phases,
          .arm_means = cycle.arm_means,
          .sin_phase_shift = {phases.size() < 2 ? std::vector<double>()
                                                : std::vector{std::sin(phases[0] - phases[1])}},
          .power = cycle.power,
          .efficiency = cycle.efficiency};
}

Motion motion_in(const Prediction& prediction, const SwimmerType* type) {
  Motion motion{.type = type,
                .velocity = {{prediction.velocity}, prediction.velocity_vector},
                .velocity_vector = prediction.velocity_vector,
                .angular_velocity = prediction.angular_velocity,
                .arm_amplitudes = {prediction.stroke.amplitude},
                .arm_phases = prediction.stroke.phase,
                .arm_means = prediction.arm_means.value_or(std::vector<double>()),
                .sin_phase_shift = {{prediction.sin_phase_shift}},
                .power = prediction.power,
                .efficiency = prediction.efficiency};
  if (prediction.uncertainty) motion.velocity.uncertainties = {*prediction.uncertainty};
  if (const auto& stroke = prediction.stroke_uncertainty) {
    motion.arm_amplitudes.uncertainties.assign(stroke->arm_amplitudes.begin(), stroke->arm_amplitudes.end());
    if (prediction.sin_phase_shift != 0)
      motion.sin_phase_shift.uncertainties = {stroke->sin_phase_shift / std::abs(prediction.sin_phase_shift)};
  }
  if (type != nullptr && !prediction.arm_means)
    for (const Bond& bond : type->bonds) motion.arm_means.push_back(bond.rest_length);
  return motion;
}

/// Smallest gap between the surfaces of the two beads of an arm, whose length is mean + d cos(w t + delta):
/// mean - d - a_1 - a_2.
ResultValue smallest_gap(const Motion& motion) {
  const std::vector<double>&means = motion.arm_means, &amplitudes = motion.arm_amplitudes.numbers;
  const std::size_t arms = motion.type != nullptr ? motion.type->bonds.size() : 0;
  if (arms == 0 || means.size() != arms || amplitudes.size() != arms) return {};
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t arm = 0; arm < arms; ++arm) {
    double radii = 0;
    for (const int bead : motion.type->bonds[arm].beads)
      radii += motion.type->beads[static_cast<std::size_t>(bead)].radius;
    smallest = std::min(smallest, means[arm] - amplitudes[arm] - radii);
  }
  return {{smallest}};
}

/// Returns the results that are known.
Results results_of(const Motion& motion) {
  using enum ResultQuantity;
  const auto number = [](const std::optional<double>& known) {
    return known ? ResultValue{{*known}} : ResultValue{};
  };
  const std::optional<Vec3>&vector = motion.velocity_vector, &rotation = motion.angular_velocity;
  Results results{{velocity, motion.velocity},
                  {angular_velocity, rotation ? ResultValue{{rotation->norm()}, rotation} : ResultValue{}},
                  {arm_amplitudes, motion.arm_amplitudes},
                  {arm_phases, {motion.arm_phases}},
                  {sin_phase_shift, motion.sin_phase_shift},
                  {power, number(motion.power)},
                  {efficiency, number(motion.efficiency)},
                  {gap, smallest_gap(motion)}};
  for (int axis = 0; axis < 3; ++axis) {
    if (vector) results[std::array{velocity_x, velocity_y, velocity_z}[axis]] = {{(*vector)[axis]}};
    if (rotation)
      results[std::array{angular_velocity_x, angular_velocity_y, angular_velocity_z}[axis]] = {
          {(*rotation)[axis]}};
  }
  std::erase_if(results, [](const auto& row) { return row.second.numbers.empty(); });
  return results;
}

std::optional<SwimmerType> type_in(const Layout* scene, int swimmer) {
  if (scene == nullptr) return std::nullopt;
  const auto found = std::ranges::find(scene->swimmers, swimmer, &Swimmer::id);
  return found == scene->swimmers.end() ? std::nullopt : std::optional(scene->resolved_type(*found));
}

// --- Means over cycles, and uncertainties

void add(const ResultValue& value, ResultValue& sum) {
  for (std::size_t i = 0; i < sum.numbers.size(); ++i) sum.numbers[i] += value.numbers[i];
  if (sum.vector) *sum.vector += *value.vector;
}

/// Returns the arithmetic mean of each number; a quantity that one element lacks is unknown.
Results mean_of(const std::vector<Results>& all) {
  const auto count = static_cast<double>(all.size());
  Results means = all.front();
  for (const Results& each : all)
    std::erase_if(means, [&](const auto& row) { return !each.contains(row.first); });
  for (auto& [quantity, mean] : means) {
    mean.numbers.assign(mean.numbers.size(), 0);
    if (mean.vector) mean.vector->setZero();
    for (const Results& each : all) add(each.at(quantity), mean);
    for (double& number : mean.numbers) number /= count;
    if (mean.vector) *mean.vector /= count;
  }
  return means;
}

void state(const std::optional<double>& uncertainty, ResultQuantity quantity, Results& results) {
  const auto found = results.find(quantity);
  if (uncertainty && found != results.end())
    found->second.uncertainties.assign(found->second.numbers.size(), *uncertainty);
}

void add_uncertainties(const RunRecord& run, const SwimmerUncertainty& of_cycle, RunUncertainty kind,
                       Results& results) {
  std::optional<double> velocity = of_cycle.velocity.total, arms = of_cycle.arm_amplitudes.total;
  if (run.expected_error && kind == RunUncertainty::with_expected_error) {
    velocity = std::hypot(run.expected_error->velocity, of_cycle.velocity.transient.value_or(0));
    arms = std::hypot(std::ranges::max(run.expected_error->arm_amplitudes),
                      of_cycle.arm_amplitudes.transient.value_or(0));
  }
  state(velocity, ResultQuantity::velocity, results);
  state(arms, ResultQuantity::arm_amplitudes, results);
}

}  // namespace

std::string unit_of(ResultQuantity quantity, const Units& units) {
  const std::string &mass = units.mass.name, &length = units.length.name, &time = units.time.name;
  switch (row_of(quantity).dimension) {
    case Dimension::number:
      return "";
    case Dimension::angle:
      return "rad";
    case Dimension::length:
      return length_unit(units);
    case Dimension::velocity:
      return velocity_unit(units);
    case Dimension::angular_velocity:
      return units.lattice ? "" : "rad/" + time;
    case Dimension::power:
      return units.lattice ? "" : fmt::format("{} {}²/{}³", mass, length, time);
  }
  return "";
}

Results results_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                   const std::string& source, RunUncertainty uncertainty) {
  const auto type = type_in(run.scene ? &*run.scene : nullptr, swimmer.id);
  std::vector<Results> cycles;
  for (const CycleStatistics& cycle : select_cycles(swimmer.cycles, choice, source))
    cycles.push_back(results_of(motion_in(cycle, run.domain.box, type ? &*type : nullptr)));
  Results results = mean_of(cycles);
  if (choice.kind == CycleChoice::Kind::last && swimmer.uncertainty)
    add_uncertainties(run, *swimmer.uncertainty, uncertainty, results);
  return results;
}

Results results_of(const Prediction& prediction, const Layout* scene, int swimmer) {
  const auto type = type_in(scene, swimmer);
  return results_of(motion_in(prediction, type ? &*type : nullptr));
}

}  // namespace beadswim
