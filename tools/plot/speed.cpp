#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "abscissa.hpp"
#include "beadswim/compare/errors_by_setting.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/figure/error_figure.hpp"
#include "beadswim/scene/units.hpp"
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
  std::vector<ComparedValues> swimmers;            ///< one for all, or one for each of a run's
  std::map<ComparedQuantity, double> uncertainty;  ///< relative, where it is known
};

/// Whether two runs are of one scene, as far as their records say: then only resolutions set them apart.
bool are_of_one_scene(const RunRecord& a, const RunRecord& b) {
  return a.driving == b.driving && a.domain == b.domain &&
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
  if (period && *period != first.record.driving.period) {
    throw InputError(
        best.source,
        fmt::format(
            "predicts for a period of {:g}, and {} has {:g}; draw runs of one period, and a prediction of it",
            *period, first.source, first.record.driving.period));
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

std::vector<CostedRun> costed_runs(const PlotInputs& inputs, const CycleChoice& cycle) {
  std::vector<CostedRun> runs;
  for (const PlottedRun& run : inputs.runs) {
    CostedRun costed{.source = run.source, .setting = setting_name(run.record), .swimmers = {}};
    if (run.record.resolution) costed.resolution = run.record.resolution->cells_per_radius;
    const auto alike = std::ranges::find_if(runs, [&](const CostedRun& other) {
      return other.setting == costed.setting && other.resolution == costed.resolution;
    });
    require_one_scene(run, inputs.runs.front());
    if (alike != runs.end())
      require_same_corrections(run, inputs.runs[static_cast<std::size_t>(alike - runs.begin())]);
    costed.cost = cost_of(run);
    for (const SwimmerRecord& swimmer : run.record.swimmers)
      costed.swimmers.push_back(swimming_of(run.record, swimmer, cycle, run.source));
    runs.push_back(std::move(costed));
  }
  return runs;
}

QuantityErrors errors_of(const std::vector<ErrorsOfSetting>& all, const ErrorReference& reference,
                         ComparedQuantity quantity, const std::string& name) {
  QuantityErrors errors{name, {}};
  for (const auto& [setting, resolutions] : all) {
    errors.series.push_back({setting, {}});
    for (const auto& [cells, source, cost, known] : resolutions) {
      if (!known.contains(quantity)) continue;
      errors.series.back().points.push_back(
          {.name = cells > 0 ? fmt::format("{}, {:g} cells", setting, cells) : setting,
           .source = source,
           .cost = cost,
           .error = known.at(quantity)});
    }
  }
  const auto known = reference.uncertainty.find(quantity);
  if (known != reference.uncertainty.end()) errors.uncertainty = known->second;
  return errors;
}

std::string resolutions_note(const std::vector<ErrorsOfSetting>& all) {
  std::set<double> known;
  for (const ErrorsOfSetting& each : all) {
    for (const ErrorsAtResolution& errors : each.resolutions) known.insert(errors.resolution);
  }
  known.erase(0);
  return known.empty()
             ? ""
             : fmt::format("From left to right along a line: {:g} cells a radius, as far as it was run",
                           fmt::join(known, ", "));
}

Figure speed_figure(const PlotInputs& inputs, const SpeedFlags& flags, const CycleChoice& cycle) {
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError("speed-against-error", "draws runs alone; name a prediction with --reference");
  }
  const ErrorReference reference = read_reference(inputs, flags, cycle);
  const auto all = errors_by_setting(costed_runs(inputs, cycle), reference.swimmers);
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
      .add_option("--reference", flags->reference,
                  "Prediction (its best usable method, or --method) or run record of the same scene from "
                  "which errors "
                  "of runs are measured; required for runs")
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
