#include "abscissa.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/scene/units.hpp"

namespace beadswim {
namespace {

/// Returns the smallest bead radius of the scene or, in an older record without it, of a lattice run.
double smallest_radius(const PlottedRun& run) {
  if (run.record.scene) return smallest_radius(*run.record.scene);
  if (const auto& resolution = run.record.resolution)
    return resolution->cells_per_radius * resolution->cell_size;
  throw InputError(
      run.source,
      "the run record lacks the bead radius, which is needed for the separation ratio l/λ; leave "
      "this file out");
}

double separation_of(const PlottedRun& run, const SwimmerRecord& swimmer, const CycleChoice& choice) {
  const auto cycles = select_cycles(swimmer.cycles, choice, run.source);
  std::array<double, 2> arms{};
  for (const CycleStatistics& cycle : cycles) {
    if (cycle.arm_means.size() != 2)
      throw InputError(run.source, "the swimmer does not have two arms; leave this file out");
    for (std::size_t arm = 0; arm < 2; ++arm) arms[arm] += cycle.arm_means[arm];
  }
  return std::min(arms[0], arms[1]) / static_cast<double>(cycles.size()) / smallest_radius(run);
}

/// Returns the ratio A/B of the driving amplitudes or the driving phase α; nullopt if the record contains no
/// driving amplitudes. For B = 0, A/B is infinite and is not drawn.
std::optional<double> driving_number(const RunRecord& run, AbscissaKind kind) {
  if (!run.driving.amplitude) return std::nullopt;
  const auto& [A, B] = *run.driving.amplitude;
  return kind == AbscissaKind::phase ? run.driving.phase : A / B;
}

}  // namespace

AxisLabel study_label(const std::string& name, const Units& units) {
  if (name == "period") return {name, time_unit(units)};
  if (name == "radius" || name == "arm") return {name, length_unit(units)};
  return {name, name == "phase" ? "rad" : ""};
}

AxisLabel result_label(ResultQuantity quantity, const Units& units) {
  return {std::string(row_of(quantity).label), unit_of(quantity, units)};
}

AxisLabel axis_label(const Abscissa& abscissa, const Units& units) {
  switch (abscissa.kind) {
    case AbscissaKind::period:
      return {"period T", time_unit(units)};
    case AbscissaKind::separation_ratio:
      return {"separation of neighbouring beads over their radius, l/λ"};
    case AbscissaKind::amplitude_ratio:
      return {"ratio of the driving amplitudes, A/B"};
    case AbscissaKind::phase:
      return {"phase of the driving, α", "rad"};
    case AbscissaKind::study:
      break;
  }
  return study_label(abscissa.study, units);
}

std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key) {
  for (const auto& [name, value] : prediction.settings) {
    if (name == key && std::holds_alternative<std::string>(value)) return std::get<std::string>(value);
  }
  return std::nullopt;
}

Json study_value(const Json& study, const std::string& name, const std::string& source,
                 const std::string& flag) {
  if (study.is_object() && study.contains(name)) return study[name];
  std::vector<std::string> names;
  for (const auto& [each, value] : study.items()) names.push_back(each);
  throw InputError(
      flag,
      names.empty()
          ? fmt::format("{} belongs to no study; make its layout with beadswim-layout vary", source)
          : fmt::format("\"{}\" is not varied in {}: {}", name, source, format_unknown_name(name, names)));
}

double number_in_study(const Json& study, const std::string& name, const std::string& source,
                       const std::string& flag) {
  const Json value = study_value(study, name, source, flag);
  if (value.is_number()) return value.get<double>();
  throw InputError(flag, fmt::format("\"{}\" is the word {} in {}, not a number; use it with --group-by",
                                     name, value.dump(), source));
}

double abscissa_of(const PlottedPrediction& plotted, const Abscissa& abscissa) {
  if (abscissa.kind == AbscissaKind::study)
    return number_in_study(plotted.study, abscissa.study, plotted.source, "--x");
  const std::string key = to_text(abscissa.kind);
  if (const auto value = number_setting(plotted.prediction, key)) return *value;
  const std::string hint =
      abscissa.kind == AbscissaKind::amplitude_ratio ? " (it is left out where B = 0)" : "";
  throw InputError(plotted.source,
                   fmt::format("the prediction by {} lacks the setting \"{}\", which is the abscissa of the "
                               "figure{}; leave the prediction out, or predict again with beadswim-theory",
                               plotted.prediction.method, key, hint));
}

double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, const Abscissa& abscissa,
                   const CycleChoice& cycle) {
  switch (abscissa.kind) {
    case AbscissaKind::study:
      return number_in_study(study_of(run), abscissa.study, run.source, "--x");
    case AbscissaKind::period:
      return run.record.driving.period;
    case AbscissaKind::separation_ratio:
      return separation_of(run, swimmer, cycle);
    default:
      break;
  }
  if (const auto number = driving_number(run.record, abscissa.kind)) return *number;
  throw InputError(run.source, fmt::format("the run record lacks the {}, the abscissa of the figure; leave "
                                           "the run out, or draw the figure with --against cycle",
                                           axis_label(abscissa, run.record.units).quantity));
}

}  // namespace beadswim
