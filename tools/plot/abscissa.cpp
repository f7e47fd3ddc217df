#include "abscissa.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "beadswim/core/error.hpp"
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
std::optional<double> driving_number(const RunRecord& run, Abscissa abscissa) {
  if (!run.driving.amplitude) return std::nullopt;
  const auto& [A, B] = *run.driving.amplitude;
  return abscissa == Abscissa::phase ? run.driving.phase : A / B;
}

}  // namespace

AxisLabel axis_label(Abscissa abscissa, const Units& units) {
  switch (abscissa) {
    case Abscissa::period:
      return {"period T", time_unit(units)};
    case Abscissa::separation_ratio:
      return {"separation of neighbouring beads over their radius, l/λ"};
    case Abscissa::amplitude_ratio:
      return {"ratio of the driving amplitudes, A/B"};
    case Abscissa::phase:
      return {"phase of the driving, α", "rad"};
  }
  return {};
}

std::optional<std::string> text_setting(const Prediction& prediction, const std::string& key) {
  for (const auto& [name, value] : prediction.settings) {
    if (name == key && std::holds_alternative<std::string>(value)) return std::get<std::string>(value);
  }
  return std::nullopt;
}

double abscissa_of(const PlottedPrediction& plotted, Abscissa abscissa) {
  const auto value = number_setting(plotted.prediction, to_text(abscissa));
  if (value) return *value;
  const std::string hint = abscissa == Abscissa::amplitude_ratio ? " (it is left out where B = 0)" : "";
  throw InputError(plotted.source,
                   fmt::format("the prediction by {} lacks the setting \"{}\", which is the abscissa of the "
                               "figure{}; leave the prediction out, or predict again with beadswim-theory",
                               plotted.prediction.method, to_text(abscissa), hint));
}

double abscissa_of(const PlottedRun& run, const SwimmerRecord& swimmer, Abscissa abscissa,
                   const CycleChoice& cycle) {
  if (abscissa == Abscissa::period) return run.record.driving.period;
  if (abscissa == Abscissa::separation_ratio) return separation_of(run, swimmer, cycle);
  if (const auto number = driving_number(run.record, abscissa)) return *number;
  throw InputError(run.source, fmt::format("the run record lacks the {}, the abscissa of the figure; leave "
                                           "the run out, or draw the figure with --against cycle",
                                           axis_label(abscissa, run.record.units).quantity));
}

std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa) {
  std::vector<PlacedPrediction> sorted;
  for (const PlottedPrediction& plotted : inputs.predictions) {
    sorted.push_back({abscissa_of(plotted, abscissa), plotted});
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  std::vector<MethodPredictions> all;
  for (const std::string& method : inputs.methods) {
    all.push_back({method, {}});
    std::copy_if(sorted.begin(), sorted.end(), std::back_inserter(all.back().predictions),
                 [&](const PlacedPrediction& placed) { return placed.plotted.prediction.method == method; });
  }
  return all;
}

}  // namespace beadswim
