#include "beadswim/documents/results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Smallest gap between the surfaces of the two beads of an arm, whose length is mean + d cos(w t + delta):
/// mean - d - a_1 - a_2. `type`: nullptr if unknown; then there is no gap.
ResultValue smallest_gap(const SwimmerType* type, const std::vector<double>& means,
                         const std::vector<double>& amplitudes) {
  const std::size_t arms = type != nullptr ? type->bonds.size() : 0;
  if (arms == 0 || means.size() != arms || amplitudes.size() != arms) return {};
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t arm = 0; arm < arms; ++arm) {
    const auto& [i, j] = type->bonds[arm].beads;
    smallest = std::min(smallest, means[arm] - amplitudes[arm] - contact_distance(*type, i, j));
  }
  return {{smallest}};
}

/// Returns the size of the component of a velocity perpendicular to the axis. `axis`: nullopt if only the
/// component along it is known, which loses half of the digits.
double speed_across(const Vec3& velocity, double along, const std::optional<Vec3>& axis) {
  if (axis) return (velocity - velocity.dot(*axis) * *axis).norm();
  return std::sqrt(std::max(0.0, velocity.squaredNorm() - along * along));
}

/// Adds vectors in the box and numbers, and leaves out results that are not known. `axis`: direction of the
/// swimmer in the box; nullopt: unknown.
Results completed(Results results, const std::optional<Vec3>& vector, const std::optional<Vec3>& axis,
                  const std::optional<Vec3>& rotation, const std::optional<double>& mean_power,
                  const std::optional<double>& lighthill) {
  using enum ResultQuantity;
  const ResultValue& along =
      results[speed_along_axis] = {results.at(velocity).numbers, {}, results.at(velocity).uncertainties};
  if (vector) results[speed_across_axis] = {{speed_across(*vector, along.numbers[0], axis)}};
  if (rotation) results[angular_velocity] = {{rotation->norm()}, rotation};
  for (int a = 0; a < 3; ++a) {
    if (vector) results[std::array{velocity_x, velocity_y, velocity_z}[a]] = {{(*vector)[a]}};
    if (rotation)
      results[std::array{angular_velocity_x, angular_velocity_y, angular_velocity_z}[a]] = {{(*rotation)[a]}};
  }
  if (mean_power) results[power] = {{*mean_power}};
  if (lighthill) results[efficiency] = {{*lighthill}};
  std::erase_if(results, [](const auto& row) { return row.second.numbers.empty(); });
  return results;
}

Results results_of(const CycleStatistics& cycle, const std::optional<Box>& box, const SwimmerType* type) {
  using enum ResultQuantity;
  const std::vector<double>& phases = cycle.arm_phases;
  const Vec3 vector = vector_relative_to_fluid(cycle, box);
  Results results{{velocity, {{velocity_relative_to_fluid(cycle, box)}, vector}},
                  {arm_amplitudes, {cycle.arm_amplitudes}},
                  {arm_phases, {phases}},
                  {gap, smallest_gap(type, cycle.arm_means, cycle.arm_amplitudes)}};
  if (phases.size() >= 2) results[sin_phase_shift] = {{std::sin(phases[0] - phases[1])}};
  if (cycle.dipole) results[dipole] = {{cycle.dipole->axial}};
  return completed(std::move(results), vector, cycle.axis, cycle.angular_velocity, cycle.power,
                   cycle.efficiency);
}

Results results_of(const Prediction& prediction, const SwimmerType* type, const std::optional<Vec3>& axis) {
  using enum ResultQuantity;
  const std::vector<double>& amplitudes = prediction.stroke.amplitude;
  std::vector<double> means = prediction.arm_means.value_or(std::vector<double>());
  if (type != nullptr && !prediction.arm_means)
    for (const Bond& bond : type->bonds) means.push_back(bond.rest_length);
  Results results{{velocity, {{prediction.velocity}, prediction.velocity_vector}},
                  {arm_amplitudes, {amplitudes}},
                  {arm_phases, {prediction.stroke.phase}},
                  {sin_phase_shift, {{prediction.sin_phase_shift}}},
                  {gap, smallest_gap(type, means, amplitudes)}};
  if (prediction.uncertainty) results[velocity].uncertainties = {*prediction.uncertainty};
  if (const auto& stroke = prediction.stroke_uncertainty) {
    results[arm_amplitudes].uncertainties.assign(stroke->arm_amplitudes.begin(),
                                                 stroke->arm_amplitudes.end());
    if (const double sine = prediction.sin_phase_shift; sine != 0)
      results[sin_phase_shift].uncertainties = {stroke->sin_phase_shift / std::abs(sine)};
  }
  if (prediction.dipole) results[dipole] = {{prediction.dipole->axial}};
  if (const auto& thermal = prediction.thermal) {
    results[effective_diffusion] = {{thermal->effective_diffusion}};
    if (thermal->rotational_diffusion > 0) results[rotational_diffusion] = {{thermal->rotational_diffusion}};
    results[peclet] = {{thermal->peclet}};
  }
  return completed(std::move(results), prediction.velocity_vector, axis, prediction.angular_velocity,
                   prediction.power, prediction.efficiency);
}

/// Returns a swimmer of a scene; nullptr if the scene is unknown or lacks it.
const Swimmer* swimmer_in(const Layout* scene, int id) {
  if (scene == nullptr) return nullptr;
  const auto found = std::ranges::find(scene->swimmers, id, &Swimmer::id);
  return found == scene->swimmers.end() ? nullptr : &*found;
}

std::optional<SwimmerType> type_in(const Layout* scene, int id) {
  const Swimmer* swimmer = swimmer_in(scene, id);
  return swimmer == nullptr ? std::nullopt : std::optional(scene->resolved_type(*swimmer));
}

// --- Means over cycles, and uncertainties

void add(const ResultValue& value, ResultValue& sum) {
  for (std::size_t i = 0; i < sum.numbers.size(); ++i) sum.numbers[i] += value.numbers[i];
  if (value.uncertainties.size() < sum.uncertainties.size()) sum.uncertainties.clear();
  for (std::size_t i = 0; i < sum.uncertainties.size(); ++i) sum.uncertainties[i] += value.uncertainties[i];
  if (sum.vector) *sum.vector += *value.vector;
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
  state(velocity, ResultQuantity::speed_along_axis, results);
  state(arms, ResultQuantity::arm_amplitudes, results);
}

// --- Runs with thermal noise

/// Sets the uncertainties of means to their relative standard errors. Cycles have independent noise.
void add_standard_errors(const std::vector<Results>& cycles, Results& means) {
  for (auto& [quantity, mean] : means) {
    mean.is_mean = true;
    mean.vector.reset();  // the swimmer turns
    mean.uncertainties.clear();
    for (std::size_t i = 0; i < mean.numbers.size() && cycles.size() > 1; ++i) {
      std::vector<double> numbers;
      for (const Results& cycle : cycles) numbers.push_back(cycle.at(quantity).numbers[i]);
      mean.uncertainties.push_back(mean_with_error(numbers).standard_error / std::abs(mean.numbers[i]));
    }
  }
}

/// Replaces amplitude d and phase delta of each arm, which noise makes larger on average, by those along the
/// mean of d exp(i delta) over the cycles.
void project_strokes(std::vector<Results>& cycles) {
  using enum ResultQuantity;
  const auto arm_of = [](const Results& cycle, std::size_t arm) {
    return std::polar(cycle.at(arm_amplitudes).numbers[arm], cycle.at(arm_phases).numbers[arm]);
  };
  const auto found = cycles.front().find(arm_amplitudes);
  for (std::size_t arm = 0; found != cycles.front().end() && arm < found->second.numbers.size(); ++arm) {
    std::complex<double> mean = 0;
    for (const Results& cycle : cycles) mean += arm_of(cycle, arm) / static_cast<double>(cycles.size());
    for (Results& cycle : cycles) {
      const std::complex<double> relative = arm_of(cycle, arm) / mean;
      cycle.at(arm_amplitudes).numbers[arm] = std::abs(mean) * relative.real();
      cycle.at(arm_phases).numbers[arm] = std::arg(mean) + relative.imag();
    }
  }
  for (Results& cycle : cycles)
    if (const auto shift = cycle.find(sin_phase_shift); shift != cycle.end()) {
      const std::vector<double>& phases = cycle.at(arm_phases).numbers;
      shift->second.numbers = {std::sin(phases[0] - phases[1])};
    }
}

ResultValue result_of(const MeanAndError<double>& value) {
  return {.numbers = {value.mean},
          .uncertainties = {value.standard_error / std::abs(value.mean)},
          .is_mean = true};
}

void add_diffusion(const DiffusionStatistics& diffusion, const SwimmerType* type, const Layout* scene,
                   Results& results) {
  // Shorter displacements do not contain all of the diffusion by the motion along the axis.
  constexpr double persistence_times = 5;
  const auto& persistence = diffusion.persistence_time;
  if (const auto& found = diffusion.effective_diffusion;
      found && persistence && *diffusion.lag >= persistence_times * persistence->mean)
    results[ResultQuantity::effective_diffusion] = result_of(*found);
  if (const auto& found = diffusion.rotational_diffusion)
    results[ResultQuantity::rotational_diffusion] = result_of(*found);
  if (type == nullptr || scene == nullptr) return;
  ResultValue peclet = results.at(ResultQuantity::speed_along_axis);
  for (double& number : peclet.numbers) number = peclet_number(*type, scene->fluid, number);
  results[ResultQuantity::peclet] = peclet;
}

/// Returns the means of a run with thermal noise: of all cycles but the first, unless others are chosen.
Results means_with_noise(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                         const SwimmerType* type, const std::string& source) {
  std::span<const CycleStatistics> chosen = select_cycles(swimmer.cycles, choice, source);
  if (choice.kind == CycleChoice::Kind::last && choice.number == 1 && swimmer.cycles.size() > 1)
    chosen = std::span(swimmer.cycles).subspan(1);
  std::vector<Results> cycles;
  for (const CycleStatistics& cycle : chosen) cycles.push_back(results_of(cycle, run.domain.box, type));
  project_strokes(cycles);
  Results means = mean_of(cycles);
  means[ResultQuantity::velocity] = means[ResultQuantity::speed_along_axis];
  for (Results& cycle : cycles) cycle[ResultQuantity::velocity] = cycle[ResultQuantity::speed_along_axis];
  add_standard_errors(cycles, means);
  add_diffusion(run.thermal->diffusion, type, run.scene ? &*run.scene : nullptr, means);
  return means;
}

UnitExponents exponents_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::number:
      return {};
    case Dimension::angle:
      return {.is_angle = true};
    case Dimension::length:
      return {.length = 1};
    case Dimension::velocity:
      return {.length = 1, .time = -1};
    case Dimension::angular_velocity:
      return {.time = -1, .is_angle = true};
    case Dimension::power:
      return {.mass = 1, .length = 2, .time = -3};
    case Dimension::energy:
      return {.mass = 1, .length = 2, .time = -2};
    case Dimension::diffusion:
      return {.length = 2, .time = -1};
    case Dimension::rate:
      return {.time = -1};
  }
  return {};
}

}  // namespace

std::string unit_of(ResultQuantity quantity, const Units& units) {
  const Dimension dimension = row_of(quantity).dimension;
  const bool is_geometric = dimension == Dimension::angle || dimension == Dimension::length;
  if (units.lattice && !is_geometric && dimension != Dimension::velocity) return "";
  return unit_text(exponents_of(dimension), units);
}

Results mean_of(const std::vector<Results>& all) {
  const auto count = static_cast<double>(all.size());
  Results means = all.front();
  for (const Results& each : all)
    std::erase_if(means, [&](const auto& row) { return !each.contains(row.first); });
  for (auto& [quantity, mean] : means) {
    mean.numbers.assign(mean.numbers.size(), 0);
    mean.uncertainties.assign(mean.uncertainties.size(), 0);
    if (mean.vector) mean.vector->setZero();
    for (const Results& each : all) add(each.at(quantity), mean);
    for (double& number : mean.numbers) number /= count;
    for (double& uncertainty : mean.uncertainties) uncertainty /= count;
    if (mean.vector) *mean.vector /= count;
  }
  return means;
}

Results mean_with_errors(const std::vector<Results>& all) {
  Results means = mean_of(all);
  add_standard_errors(all, means);
  return means;
}

Results results_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                   const std::string& source, RunUncertainty uncertainty) {
  const auto type = type_in(run.scene ? &*run.scene : nullptr, swimmer.id);
  if (run.thermal) return means_with_noise(run, swimmer, choice, type ? &*type : nullptr, source);
  std::vector<Results> cycles;
  for (const CycleStatistics& cycle : select_cycles(swimmer.cycles, choice, source))
    cycles.push_back(results_of(cycle, run.domain.box, type ? &*type : nullptr));
  Results results = mean_of(cycles);
  if (choice.kind == CycleChoice::Kind::last && swimmer.uncertainty)
    add_uncertainties(run, *swimmer.uncertainty, uncertainty, results);
  return results;
}

std::optional<Vec3> predicted_axis(const Prediction& prediction, const Layout* scene, int id) {
  const Swimmer* swimmer = swimmer_in(scene, id);
  if (swimmer == nullptr || find_setting<double>(prediction, "turn")) return std::nullopt;
  return swimmer->orientation().col(0);
}

Results results_of(const Prediction& prediction, const Layout* scene, int swimmer) {
  const auto type = type_in(scene, swimmer);
  return results_of(prediction, type ? &*type : nullptr, predicted_axis(prediction, scene, swimmer));
}

}  // namespace beadswim
