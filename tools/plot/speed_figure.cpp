#include "speed_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "beadswim/core/error.hpp"
#include "swimming_files.hpp"

namespace beadswim {
namespace {

/// From which errors are measured: a swimmer by a prediction, or each swimmer by a run.
struct ErrorReference {
  std::string name;
  std::vector<Swimming> swimmers;

  const Swimming& of(std::size_t swimmer) const {
    return swimmers.size() == 1 ? swimmers.front() : swimmers[swimmer];
  }
};

ErrorReference reference_of(const RunRecord& run, const CycleChoice& cycle, const std::string& source) {
  ErrorReference reference{.name = run.model, .swimmers = {}};
  if (run.resolution) {
    reference.name = fmt::format("{}, {}, {:g} cells a radius", run.model, run.resolution->bead_boundary,
                                 run.resolution->cells_per_radius);
  }
  for (const SwimmerRecord& swimmer : run.swimmers)
    reference.swimmers.push_back(swimming_of(run, swimmer, cycle, source));
  return reference;
}

ErrorReference reference_of(const PlottedPrediction& best) {
  return {.name = best.prediction.method, .swimmers = {swimming_of(best.prediction)}};
}

ErrorReference read_reference(const PlotInputs& inputs, const SpeedFigureOptions& options) {
  const PlotInputs read = read_plot_inputs({options.reference}, {});
  if (read.runs.size() + read.predictions.size() != 1) {
    throw InputError(options.reference, "holds several documents; a reference is one run or prediction");
  }
  if (!same_units(read.units, inputs.units)) {
    throw InputError(options.reference, fmt::format("is in other units than {}", inputs.runs.front().source));
  }
  if (read.runs.empty()) return reference_of(read.predictions.front());
  return reference_of(read.runs.front().record, options.cycle, read.runs.front().source);
}

/// Periods of driving that a run did: fractions too, where it has a lattice that says so.
double periods_done(const RunRecord& record) {
  if (!record.resolution || !record.domain || !record.cost->cell_updates) {
    const std::vector<CycleStatistics>& cycles = record.swimmers.front().cycles;
    return cycles.empty() ? 0 : cycles.back().index;
  }
  const double cells = record.domain->lengths.prod() / std::pow(record.resolution->cell_size, 3);
  return static_cast<double>(*record.cost->cell_updates) /
         (cells * static_cast<double>(record.resolution->steps_per_cycle));
}

/// [1/hour] of one core
double speed_of(const PlottedRun& run) {
  if (!run.record.cost) {
    throw InputError(run.source, "does not say its cost, as of a run with --no-provenance; leave it out");
  }
  return 3600 * periods_done(run.record) / run.record.cost->core_seconds;
}

std::string setting_of(const RunRecord& record) {
  if (!record.resolution) return record.model;
  return fmt::format("{}, τ = {:.2g}, {}", record.resolution->bead_boundary,
                     record.resolution->relaxation_time, record.resolution->precision);
}

/// Runs of one setting at one resolution.
struct Measured {
  std::vector<double> speeds;
  std::map<ComparedQuantity, std::vector<double>> errors;  ///< relative
};

void add(const PlottedRun& run, const ErrorReference& reference, const CycleChoice& cycle,
         Measured& measured) {
  const std::vector<SwimmerRecord>& swimmers = run.record.swimmers;
  if (reference.swimmers.size() > 1 && reference.swimmers.size() != swimmers.size()) {
    throw InputError(run.source, fmt::format("has {} swimmers, the reference {}", swimmers.size(),
                                             reference.swimmers.size()));
  }
  measured.speeds.push_back(speed_of(run));
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    const Swimming swimming = swimming_of(run.record, swimmers[s], cycle, run.source);
    for (const auto& [quantity, values] : reference.of(s)) {
      for (std::size_t i = 0; i < values.size(); ++i)
        measured.errors[quantity].push_back(relative_error(swimming.at(quantity)[i], values[i]));
    }
  }
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// By setting, in order of its first run; then by cells a radius, 0 where there is no lattice.
using BySetting = std::vector<std::pair<std::string, std::map<double, Measured>>>;

BySetting measured_by_setting(const PlotInputs& inputs, const ErrorReference& reference,
                              const CycleChoice& cycle) {
  BySetting all;
  for (const PlottedRun& run : inputs.runs) {
    const std::string name = setting_of(run.record);
    auto setting = std::ranges::find(all, name, &BySetting::value_type::first);
    if (setting == all.end()) setting = all.insert(all.end(), {name, {}});
    const double cells = run.record.resolution ? run.record.resolution->cells_per_radius : 0;
    add(run, reference, cycle, setting->second[cells]);
  }
  return all;
}

Panel panel_of(const BySetting& all, ComparedQuantity quantity, const std::string& what) {
  Panel panel{.x_label = {"error of the " + what, "%"},
              .y_label = {"periods a core does in an hour"},
              .x_scale = ScaleKind::logarithmic,
              .y_scale = ScaleKind::logarithmic};
  for (const auto& [name, points] : all) {
    const int position = static_cast<int>(panel.series.size());
    Series series{.label = name,
                  .mark = Mark::line_and_points,
                  .colour = position,
                  .shape = position,
                  .dash = position};
    for (const auto& [cells, measured] : points) {
      if (!measured.errors.contains(quantity)) continue;
      series.x.push_back(100 * root_mean_square(measured.errors.at(quantity)));
      series.y.push_back(median(measured.speeds));
    }
    panel.series.push_back(series);
  }
  return panel;
}

std::string resolutions_note(const BySetting& all) {
  std::map<double, bool> known;
  for (const auto& setting : all) {
    for (const auto& point : setting.second) known[point.first] = true;
  }
  std::string text;
  for (const auto& [cells, is_known] : known) {
    if (cells > 0) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", cells);
  }
  return text.empty() ? text : "From above along a line: " + text + " cells a radius, as far as it was run";
}

}  // namespace

Figure speed_figure(const PlotInputs& inputs, const SpeedFigureOptions& options) {
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError("speed-against-error", "draws runs alone; name a prediction with --reference");
  }
  const ErrorReference reference = read_reference(inputs, options);
  const BySetting all = measured_by_setting(inputs, reference, options.cycle);
  Figure figure{.title = "Speed against error",
                .panels = {panel_of(all, ComparedQuantity::velocity, "velocity"),
                           panel_of(all, ComparedQuantity::arm_amplitudes, "arm amplitudes")},
                .notes = {fmt::format("Root mean square of relative errors, against {}", reference.name)}};
  const std::string resolutions = resolutions_note(all);
  if (!resolutions.empty()) figure.notes.push_back(resolutions);
  return figure;
}

}  // namespace beadswim
