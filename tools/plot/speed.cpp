#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "abscissa.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "beadswim/figure/error_figure.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_inputs.hpp"
#include "verdicts.hpp"

// Errors of velocity and of stroke against core-seconds a period. Runs of one setting (model; bead boundary,
// relaxation time, precision) are joined in order of their resolution. Runs of one resolution, as at several
// places within a cell, are one point: root mean square of their errors, median of their costs.

namespace beadswim {
namespace {

struct SpeedFlags {
  std::vector<std::string> methods;  ///< of a prediction, or of verdicts
  std::string cycle = "last";
  std::string reference;  ///< file of the run or prediction from which errors are measured
};

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

ErrorReference read_reference(const PlotInputs& inputs, const SpeedFlags& flags, const CycleChoice& cycle) {
  const PlotInputs read = read_plot_inputs({flags.reference}, {flags.methods});
  if (read.runs.size() + read.predictions.size() != 1) {
    throw InputError(flags.reference,
                     "holds several; a reference is one run, or one method's prediction: name one with "
                     "--method, or give a file with one");
  }
  const PlottedRun& first = inputs.runs.front();
  if (!same_units(read.units, inputs.units))
    throw InputError(flags.reference,
                     fmt::format("is in other units than {}; make both from one layout", first.source));
  return read.runs.empty() ? reference_of(read.predictions.front(), first)
                           : reference_of(read.runs.front(), first, cycle);
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

QuantityErrors errors_of(const BySetting& all, const ErrorReference& reference, ComparedQuantity quantity,
                         const std::string& name) {
  QuantityErrors errors{name, errors_of(all, quantity)};
  const auto known = reference.uncertainty.find(quantity);
  if (known != reference.uncertainty.end()) errors.uncertainty = known->second;
  return errors;
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

Figure speed_figure(const PlotInputs& inputs, const SpeedFlags& flags, const CycleChoice& cycle) {
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError("speed-against-error", "draws runs alone; name a prediction with --reference");
  }
  const ErrorReference reference = read_reference(inputs, flags, cycle);
  const BySetting all = measured_by_setting(inputs, reference, cycle);
  std::vector<std::string> notes{
      fmt::format("Root mean square of relative errors, against {}", reference.name)};
  if (const std::string resolutions = resolutions_note(all); !resolutions.empty())
    notes.push_back(resolutions);
  return error_figure({errors_of(all, reference, ComparedQuantity::velocity, "velocity"),
                       errors_of(all, reference, ComparedQuantity::arm_amplitudes, "arm amplitudes")},
                      "core-seconds a period", std::move(notes));
}

}  // namespace

Drawing add_speed_flags(CLI::App& command) {
  const auto flags = std::make_shared<SpeedFlags>();
  add_methods(command, flags->methods);
  add_cycle(command, flags->cycle);
  command
      .add_option(
          "--reference", flags->reference,
          "The prediction or the run record of the same scene from which errors of runs are measured. Of a "
          "prediction, its best usable method or --method counts. Verdicts have a reference already.")
      ->type_name("FILE")
      ->default_str("none");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    if (!flags->reference.empty()) {
      require_other_file(flags->reference, files.output);
      return figure_to_svg(speed_figure(read_plot_inputs(files.inputs, {}), *flags, cycle));
    }
    if (flags->cycle != SpeedFlags().cycle) {
      throw InputError("--cycle",
                       "has no meaning for verdicts, which have theirs; leave it out, or draw runs, with "
                       "--reference");
    }
    return figure_to_svg(verdict_figure(files.inputs, flags->methods));
  };
}

}  // namespace beadswim
