#include "speed_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "abscissa.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "error_panel.hpp"

namespace beadswim {
namespace {

/// From which errors are measured: a swimmer by a prediction, or each swimmer by a run.
struct ErrorReference {
  std::string name;
  std::vector<Swimming> swimmers;                  ///< one for all, or one for each of a run's
  std::map<ComparedQuantity, double> uncertainty;  ///< relative, where it is known

  const Swimming& of(std::size_t swimmer) const {
    return swimmers.size() == 1 ? swimmers.front() : swimmers[swimmer];
  }
};

/// Whether two runs are of one scene, as far as their records say: then only resolutions set them apart.
bool are_of_one_scene(const RunRecord& a, const RunRecord& b) {
  return a.driving_period == b.driving_period && a.driving == b.driving && a.domain == b.domain &&
         std::ranges::equal(a.swimmers, b.swimmers, {}, &SwimmerRecord::id, &SwimmerRecord::id);
}

void require_one_scene(const PlottedRun& run, const PlottedRun& other) {
  if (are_of_one_scene(run.record, other.record)) return;
  throw InputError(run.source,
                   fmt::format("is of another scene (box, driving or swimmers) than {}; errors and "
                               "speeds of one scene go into a figure",
                               other.source));
}

/// Of the scene of `first`.
ErrorReference reference_of(const PlottedRun& run, const PlottedRun& first, const CycleChoice& cycle) {
  require_one_scene(run, first);
  const RunRecord& record = run.record;
  ErrorReference reference{.name = record.model, .swimmers = {}, .uncertainty = {}};
  if (record.resolution) {
    reference.name = fmt::format("{}, {}, {:g} cells a radius", record.model,
                                 record.resolution->bead_boundary, record.resolution->cells_per_radius);
  }
  for (const SwimmerRecord& swimmer : record.swimmers)
    reference.swimmers.push_back(swimming_of(record, swimmer, cycle, run.source));
  return reference;
}

ErrorReference reference_of(const PlottedPrediction& best, const PlottedRun& first) {
  const auto period = number_setting(best.prediction, "period");
  if (period && *period != first.record.driving_period) {
    throw InputError(
        best.source,
        fmt::format(
            "predicts for a period of {:g}, and {} has {:g}; draw runs of one period, and a prediction of it",
            *period, first.source, first.record.driving_period));
  }
  ErrorReference reference{
      .name = best.prediction.method, .swimmers = {swimming_of(best.prediction)}, .uncertainty = {}};
  if (const auto& velocity = best.prediction.uncertainty)
    reference.uncertainty[ComparedQuantity::velocity] = *velocity;
  if (const auto& stroke = best.prediction.stroke_uncertainty) {
    const auto& [one, other] = stroke->arm_amplitudes;
    reference.uncertainty[ComparedQuantity::arm_amplitudes] = std::max(one, other);
  }
  return reference;
}

ErrorReference read_reference(const PlotInputs& inputs, const SpeedFigureOptions& options) {
  const PlotInputs read = read_plot_inputs({options.reference}, {options.methods});
  if (read.runs.size() + read.predictions.size() != 1) {
    throw InputError(options.reference,
                     "holds several; a reference is one run, or one method's prediction: name one with "
                     "--method, or give a file with one");
  }
  const PlottedRun& first = inputs.runs.front();
  if (!same_units(read.units, inputs.units))
    throw InputError(options.reference,
                     fmt::format("is in other units than {}; make both from one layout", first.source));
  return read.runs.empty() ? reference_of(read.predictions.front(), first)
                           : reference_of(read.runs.front(), first, options.cycle);
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

/// Core-seconds a period.
double cost_of(const PlottedRun& run) {
  if (!run.record.cost) {
    throw InputError(run.source, "does not say its cost, as of a run with --no-provenance; leave it out");
  }
  return run.record.cost->core_seconds / periods_done(run.record);
}

/// What sets runs apart beside the resolution: "mr, τ = 1.5, single".
std::string setting_name(const RunRecord& record) {
  if (!record.resolution) return record.model;
  return fmt::format("{}, τ = {:g}, {}", record.resolution->bead_boundary,
                     std::round(100 * record.resolution->relaxation_time) / 100,
                     record.resolution->precision);
}

/// Whether beads are on the lattice what they are in the layout, or what corrections make of them, in both.
void require_same_corrections(const PlottedRun& run, const PlottedRun& other) {
  const auto &a = run.record.resolution, &b = other.record.resolution;
  if (!a || (a->radius_on_lattice == b->radius_on_lattice && a->density_on_lattice == b->density_on_lattice))
    return;
  throw InputError(run.source,
                   fmt::format("differs from {} in --radius-correction or --delay-correction alone; draw "
                               "them in figures of their own",
                               other.source));
}

/// Runs of one setting at one resolution.
struct Measured {
  const PlottedRun* first = nullptr;
  std::vector<double> costs;
  std::map<ComparedQuantity, std::vector<double>> errors;  ///< relative
};

void add(const PlottedRun& run, const ErrorReference& reference, const CycleChoice& cycle,
         Measured& measured) {
  const std::vector<SwimmerRecord>& swimmers = run.record.swimmers;
  measured.costs.push_back(cost_of(run));
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    const Swimming swimming = swimming_of(run.record, swimmers[s], cycle, run.source);
    for (const auto& [quantity, values] : reference.of(s)) {
      for (std::size_t i = 0; i < values.size(); ++i)
        measured.errors[quantity].push_back(relative_error(swimming.at(quantity)[i], values[i]));
    }
  }
}

/// By setting, in order of its first run; then by cells a radius, 0 where there is no lattice.
using BySetting = std::vector<std::pair<std::string, std::map<double, Measured>>>;

BySetting measured_by_setting(const PlotInputs& inputs, const ErrorReference& reference,
                              const CycleChoice& cycle) {
  BySetting all;
  for (const PlottedRun& run : inputs.runs) {
    const std::string name = setting_name(run.record);
    auto setting = std::ranges::find(all, name, &BySetting::value_type::first);
    if (setting == all.end()) setting = all.insert(all.end(), {name, {}});
    const double cells = run.record.resolution ? run.record.resolution->cells_per_radius : 0;
    Measured& measured = setting->second[cells];
    if (measured.first == nullptr) measured.first = &run;
    require_one_scene(run, inputs.runs.front());
    require_same_corrections(run, *measured.first);
    add(run, reference, cycle, measured);
  }
  return all;
}

/// The runs' errors of a quantity.
std::vector<ErrorSeries> errors_of(const BySetting& all, ComparedQuantity quantity) {
  std::vector<ErrorSeries> result;
  for (const auto& [name, by_cells] : all) {
    ErrorSeries series{name, {}};
    for (const auto& [cells, measured] : by_cells) {
      if (!measured.errors.contains(quantity)) continue;
      series.points.push_back({.name = cells > 0 ? fmt::format("{}, {:g} cells", name, cells) : name,
                               .source = measured.first->source,
                               .cost = median(measured.costs),
                               .error = root_mean_square(measured.errors.at(quantity))});
    }
    result.push_back(std::move(series));
  }
  return result;
}

ErrorPanel panel_of(const BySetting& all, const ErrorReference& reference, ComparedQuantity quantity,
                    const std::string& what) {
  const auto known = reference.uncertainty.find(quantity);
  return error_panel(errors_of(all, quantity), what, "core-seconds a period",
                     known == reference.uncertainty.end() ? std::nullopt : std::optional(known->second));
}

std::string resolutions_note(const BySetting& all) {
  std::set<double> known;
  for (const auto& [name, points] : all) {
    for (const auto& [cells, measured] : points) known.insert(cells);
  }
  std::string text;
  for (const double cells : known) {
    if (cells > 0) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", cells);
  }
  return text.empty() ? text
                      : "From left to right along a line: " + text + " cells a radius, as far as it was run";
}

}  // namespace

Figure speed_figure(const PlotInputs& inputs, const SpeedFigureOptions& options) {
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError("speed-against-error", "draws runs alone; name a prediction with --reference");
  }
  const ErrorReference reference = read_reference(inputs, options);
  const BySetting all = measured_by_setting(inputs, reference, options.cycle);
  const ErrorPanel velocity = panel_of(all, reference, ComparedQuantity::velocity, "velocity"),
                   strokes = panel_of(all, reference, ComparedQuantity::arm_amplitudes, "arm amplitudes");
  Figure figure{.title = "Speed against error",
                .panels = {velocity.panel, strokes.panel},
                .notes = {fmt::format("Root mean square of relative errors, against {}", reference.name)}};
  const std::string resolutions = resolutions_note(all);
  if (!resolutions.empty()) figure.notes.push_back(resolutions);
  for (const ErrorPanel* panel : {&velocity, &strokes})
    figure.notes.insert(figure.notes.end(), panel->notes.begin(), panel->notes.end());
  return figure;
}

}  // namespace beadswim
