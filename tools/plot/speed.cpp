#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "beadswim/compare/errors_by_setting.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/documents/document_scenes.hpp"
#include "beadswim/figure/error_figure.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_inputs.hpp"
#include "verdicts.hpp"

// Figures of the errors of velocity and arm amplitudes against the cost of runs in core-seconds per period.
// A line joins lattice runs with equal bead boundary, relaxation time and precision, in order of their
// resolution. Runs that are equal in resolution, too, for example at several positions within a cell, are
// drawn as one point: the root mean square of their errors and the median of their costs. The same holds for
// runs with equal mobility model.

namespace beadswim {
namespace {

struct SpeedFlags {
  ResultFlags results;  ///< methods of the prediction or of the verdicts whose errors are drawn
  std::vector<std::string>
      references;  ///< files of runs or a prediction relative to which errors are measured
  std::optional<ResultQuantity> quantity;  ///< the quantity that is drawn; nullopt: both
};

/// Reference values for the errors of runs: a prediction for one swimmer, or all swimmers of a run.
struct ErrorReference {
  std::string name;
  std::optional<int> swimmer{};          ///< id of the only swimmer of a prediction; nullopt: all swimmers
  std::vector<Results> swimmers;         ///< of the only swimmer, or of all swimmers
};

/// The runs of one scene and their reference.
struct ComparedScene {
  std::string title;  ///< empty if the figure has one scene
  ErrorReference reference;
  std::vector<const PlottedRun*> runs;
};

/// Returns the differences between the scenes of a run and of another document.
std::vector<SceneDifference> find_differences(const RunRecord& run, const SwimmingDocument& other) {
  std::vector<SceneDifference> differences = scene_differences(run, other);
  if (std::holds_alternative<RunRecord>(other))  // a scene can have more swimmers than its record lists
    add_differences(differences, {{"swimmers", swimmers_value(swimmers_of(run))}},
                    {{"swimmers", swimmers_value(swimmers_of(other))}});
  return differences;
}

void require_one_scene(const PlottedRun& run, const SourceDocument& other) {
  std::vector<std::string> words;
  for (const SceneDifference& difference : find_differences(run.record, other.document))
    words.push_back(in_words(difference));
  if (words.empty()) return;
  throw InputError(other.source, fmt::format("the scene differs from the scene of {}: {}; all files of this "
                                             "figure must have the same scene",
                                             run.source, fmt::join(words, "; ")));
}

/// Returns the velocity and stroke of a run as the reference for errors.
ErrorReference reference_of(const PlottedRun& run, const CycleChoice& cycle) {
  const RunRecord& record = run.record;
  ErrorReference reference{.name = record.model, .swimmers = {}};
  if (record.resolution) {
    reference.name = fmt::format("{}, {}, {:g} cells per radius", record.model,
                                 record.resolution->bead_boundary, record.resolution->cells_per_radius);
  }
  for (const SwimmerRecord& swimmer : record.swimmers)
    reference.swimmers.push_back(results_of(record, swimmer, cycle, run.source, RunUncertainty::of_cycle));
  return reference;
}

/// Returns the relative uncertainty of a quantity of the reference: of a prediction the largest of its
/// numbers, of a run the root mean square over numbers and swimmers. Returns nullopt if none is stated.
std::optional<double> uncertainty_of(const ErrorReference& reference, ResultQuantity quantity) {
  std::optional<double> largest;
  double change = 0, square = 0;
  for (const Results& results : reference.swimmers) {
    const auto found = results.find(quantity);
    if (found == results.end()) continue;
    const auto& [numbers, vector, uncertainties] = found->second;
    for (std::size_t i = 0; i < uncertainties.size(); ++i) {
      largest = std::max(largest.value_or(0), uncertainties[i]);
      change += std::pow(uncertainties[i] * numbers[i], 2);
      square += std::pow(numbers[i], 2);
    }
  }
  if (reference.swimmer) return largest;
  return change > 0 ? std::optional(std::sqrt(change / square)) : std::nullopt;
}

/// Returns "9 swimmers, box 120 x 120 x 120".
std::string scene_title(const RunRecord& record) {
  const auto swimmers = record.swarm && !record.swarm->empty() ? record.swarm->back().statistics.swimmers
                                                               : std::ssize(record.swimmers);
  std::string title = swimmers == 1 ? "1 swimmer" : fmt::format("{} swimmers", swimmers);
  if (record.domain.box) {
    const Vec3& lengths = record.domain.box->lengths;
    title += fmt::format(", box {:g} x {:g} x {:g}", lengths[0], lengths[1], lengths[2]);
  }
  return title;
}

/// Returns the only run or prediction that a file of a reference contains.
SourceDocument document_of(const PlotInputs& read) {
  if (!read.runs.empty()) return {read.runs.front().source, read.runs.front().record};
  const PlottedPrediction& only = read.predictions.front();
  PredictionDocument document{
      {.units = read.units, .swimmer = only.swimmer, .predictions = {only.prediction}}};
  document.scene = only.scene;
  return {only.source, document};
}

/// Reads the file of a reference and collects the runs of its scene: all runs if there is one reference.
ComparedScene read_scene(const PlotInputs& inputs, const std::string& file, const SpeedFlags& flags,
                         const CycleChoice& cycle) {
  const bool has_several_scenes = flags.references.size() > 1;
  const PlotInputs read = read_plot_inputs({file}, flags.results.methods, cycle);
  if (read.runs.size() + read.predictions.size() != 1) {
    throw InputError(
        file,
        "the file contains several runs or predictions, but errors are relative to one reference; name one "
        "method with --method, or give a file with one run or one prediction");
  }
  if (has_several_scenes && read.runs.empty())
    throw InputError(file, "with several references, each must be a run record, which states its scene");
  if (!same_units(read.units, inputs.units))
    throw InputError(
        file,
        fmt::format("the units of the reference differ from the units of {}; make both files from one layout",
                    inputs.runs.front().source));
  const SourceDocument reference = document_of(read);
  ComparedScene scene;
  for (const PlottedRun& run : inputs.runs)
    if (!has_several_scenes || find_differences(run.record, reference.document).empty())
      scene.runs.push_back(&run);
  if (scene.runs.empty())
    throw InputError(file,
                     "no run has the scene of this reference; add its runs, or leave the reference out");
  const PlottedRun& first = *scene.runs.front();
  require_one_scene(first, reference);
  if (read.runs.empty()) {
    const PlottedPrediction& only = read.predictions.front();
    scene.reference = {only.prediction.method, only.swimmer, {results_of(only)}};
  } else {
    scene.reference = reference_of(read.runs.front(), cycle);
  }
  if (has_several_scenes) scene.title = scene_title(first.record);
  return scene;
}

/// Returns the scenes of all references. Throws InputError if a run has the scene of none or of several.
std::vector<ComparedScene> read_scenes(const PlotInputs& inputs, const SpeedFlags& flags,
                                       const CycleChoice& cycle) {
  std::vector<ComparedScene> scenes;
  for (const std::string& file : flags.references) scenes.push_back(read_scene(inputs, file, flags, cycle));
  for (const PlottedRun& run : inputs.runs) {
    const auto matches = std::ranges::count_if(
        scenes, [&](const ComparedScene& scene) { return std::ranges::count(scene.runs, &run) > 0; });
    if (matches > 1)
      throw InputError(run.source,
                       "two references have the scene of this run; draw the scenes in separate figures");
    if (matches == 0)
      throw InputError(run.source,
                       "the scene of this run is that of no reference; add its reference to --reference, or "
                       "leave the run out");
  }
  return scenes;
}

bool has_finer_levels(const RunRecord& record) {
  return record.resolution && record.resolution->levels.size() > 1;
}

/// Returns the cost of a run in core-seconds per driving period.
double cost_of(const PlottedRun& run) {
  if (!run.record.cost) {
    throw InputError(run.source,
                     "the run record does not contain the cost of the run, for example because the run had "
                     "the flag --no-provenance; leave this file out");
  }
  return run.record.cost->core_seconds / run.record.cost->cycles;
}

/// Returns the settings of a run except its resolution, for example "mr, τ = 1.5, single" (bead boundary,
/// relaxation time, precision).
std::string setting_name(const RunRecord& record) {
  if (!record.resolution) {
    const bool has_order = record.mobility && record.mobility->multipole_order;
    return has_order ? fmt::format("{}, order {}", record.model, *record.mobility->multipole_order)
                     : record.model;
  }
  return fmt::format("{}, τ = {:g}, {}{}", record.resolution->bead_boundary,
                     std::round(100 * record.resolution->relaxation_time) / 100, record.resolution->precision,
                     has_finer_levels(record) ? ", levels" : "");
}

/// Throws InputError if two runs use different bead radii or densities on the lattice. The flags
/// --radius-correction and --delay-correction change these values.
void require_same_corrections(const PlottedRun& run, const PlottedRun& other) {
  const auto &a = run.record.resolution, &b = other.record.resolution;
  if (!a || (a->radius_on_lattice == b->radius_on_lattice && a->density_on_lattice == b->density_on_lattice))
    return;
  throw InputError(run.source, fmt::format("this run differs from the run {} only in --radius-correction or "
                                           "--delay-correction; draw the two runs in separate figures",
                                           other.source));
}

/// Throws InputError if a swimmer of the run has another number of arms than in the reference.
void require_same_arms(const PlottedRun& run, const std::vector<Results>& swimmers,
                       const ErrorReference& reference) {
  const auto arms = [](const Results& results) {
    const auto found = results.find(ResultQuantity::arm_amplitudes);
    return found == results.end() ? 0 : found->second.numbers.size();
  };
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    if (arms(reference.swimmers[s]) == arms(swimmers[s])) continue;
    throw InputError(run.source, fmt::format("swimmer {} has {} arms, but {} in the reference ({}); give the "
                                             "reference of this scene",
                                             reference.swimmer.value_or(run.record.swimmers[s].id),
                                             arms(swimmers[s]), arms(reference.swimmers[s]), reference.name));
  }
}

/// Returns the results of the swimmers of which the reference contains values.
std::vector<Results> results_of(const PlottedRun& run, const ErrorReference& reference,
                                const CycleChoice& cycle) {
  std::vector<SwimmerRecord> wanted = run.record.swimmers;
  if (reference.swimmer) wanted = {find_swimmer(run.record, *reference.swimmer, run.source)};
  std::vector<Results> swimmers;
  for (const SwimmerRecord& swimmer : wanted)
    swimmers.push_back(results_of(run.record, swimmer, cycle, run.source));
  require_same_arms(run, swimmers, reference);
  return swimmers;
}

std::vector<CostedRun> costed_runs(const ComparedScene& scene, const CycleChoice& cycle) {
  std::vector<CostedRun> runs;
  const std::vector<const PlottedRun*>& plotted = scene.runs;
  const SourceDocument first{plotted.front()->source, plotted.front()->record};
  for (const PlottedRun* each : plotted) {
    const PlottedRun& run = *each;
    CostedRun costed{.source = run.source, .setting = setting_name(run.record), .swimmers = {}};
    if (run.record.resolution) costed.resolution = run.record.resolution->cells_per_radius;
    const auto same_setting = std::ranges::find_if(runs, [&](const CostedRun& other) {
      return other.setting == costed.setting && other.resolution == costed.resolution;
    });
    require_one_scene(run, first);
    if (same_setting != runs.end())
      require_same_corrections(run, *plotted[static_cast<std::size_t>(same_setting - runs.begin())]);
    costed.cost = cost_of(run);
    costed.swimmers = results_of(run, scene.reference, cycle);
    runs.push_back(std::move(costed));
  }
  return runs;
}

QuantityErrors errors_of(const std::vector<ErrorsOfSetting>& all, const ComparedScene& scene,
                         ResultQuantity quantity, const std::string& name) {
  QuantityErrors errors{.quantity = name,
                        .series = {},
                        .uncertainty = uncertainty_of(scene.reference, quantity),
                        .scene = scene.title};
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
  return errors;
}

std::string resolutions_note(const PlotInputs& inputs) {
  std::set<double> known;
  for (const PlottedRun& run : inputs.runs)
    if (run.record.resolution) known.insert(run.record.resolution->cells_per_radius);
  return known.empty() ? ""
                       : fmt::format("Lines join runs with {:g} to {:g} cells per radius.", *known.begin(),
                                     *known.rbegin());
}

Figure speed_figure(const PlotInputs& inputs, const SpeedFlags& flags, const CycleChoice& cycle) {
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError(
        "speed-against-error",
        "this figure draws only run records; name run records as files, and a prediction with --reference");
  }
  std::vector<QuantityErrors> panels;
  std::set<std::string> references;
  for (const ComparedScene& scene : read_scenes(inputs, flags, cycle)) {
    const auto all = errors_by_setting(costed_runs(scene, cycle), scene.reference.swimmers);
    references.insert(scene.reference.name);
    for (const auto& [quantity, name] : {std::pair(ResultQuantity::velocity, "velocity"),
                                         std::pair(ResultQuantity::arm_amplitudes, "arm amplitudes")})
      if (flags.quantity.value_or(quantity) == quantity)
        panels.push_back(errors_of(all, scene, quantity, name));
  }
  std::vector<Note> notes{{.text = fmt::format("Root mean square of errors relative to the reference ({}).",
                                               fmt::join(references, "; "))},
                          {.text = resolutions_note(inputs)}};
  return error_figure(panels, "core-seconds per period", std::move(notes));
}

}  // namespace

Drawing add_speed_flags(CLI::App& command) {
  const auto flags = std::make_shared<SpeedFlags>();
  add_result_flags(command, flags->results);
  command
      .add_option(
          "--reference", flags->references,
          "Prediction or run record from which errors of runs are measured, or one run record per scene; "
          "required if FILES are run records")
      ->type_name("FILE,...")
      ->delimiter(',')
      ->default_str("none");
  add_word(command, "--quantity",
           {to_text(ResultQuantity::velocity), to_text(ResultQuantity::arm_amplitudes)}, "",
           "Quantity whose errors of run records are drawn",
           [flags](const std::string& word) { flags->quantity = from_text<ResultQuantity>(word); })
      ->default_str("both");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = flags->results.cycle_choice();
    if (!flags->references.empty()) {
      for (const std::string& file : flags->references) require_other_file(file, files.output);
      return Drawn(speed_figure(read_plot_inputs(files.inputs, {}, cycle), *flags, cycle));
    }
    if (flags->results.cycle != ResultFlags().cycle) {
      throw InputError("--cycle",
                       "each verdict already states which cycle was compared; leave --cycle out, or draw run "
                       "records with --reference instead of verdicts");
    }
    if (flags->quantity)
      throw InputError(
          "--quantity",
          "is for run records; leave it out, or draw run records with --reference instead of verdicts");
    return Drawn(verdict_figure(files.inputs, flags->results.methods.methods));
  };
}

}  // namespace beadswim
