#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "errors.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Figures of the errors of velocity and arm amplitudes against the cost of runs in core-seconds per period.
// A line joins lattice runs with equal bead boundary, relaxation time and precision, in order of their
// resolution. Runs that are equal in resolution, too, for example at several positions within a cell, are
// drawn as one point: the root mean square of their errors and the median of their costs. The same holds for
// runs with equal mobility model.

namespace beadswim {
namespace {

struct SpeedFlags {
  InputChoice choice;  ///< methods of the prediction or of the verdicts whose errors are drawn, and cycles
  std::vector<std::string> references;     ///< files of runs or a prediction from which errors are measured
  std::optional<ResultQuantity> quantity;  ///< the quantity that is drawn; nullopt: both
};

/// The runs of one scene, and the reference values for their errors: a prediction for one swimmer, or all
/// swimmers of a run.
struct ComparedScene {
  std::string title{};  ///< empty if the figure has one scene
  std::vector<const RunFile*> runs{};
  std::string reference{};         ///< name of the reference
  std::optional<int> swimmer{};    ///< id of the only swimmer of a prediction; nullopt: all swimmers
  std::vector<Results> correct{};  ///< of the only swimmer, or of all swimmers
};

/// Returns the differences between the scenes of a run and of another document.
std::vector<SceneDifference> find_differences(const RunRecord& run, const SwimmingDocument& other) {
  std::vector<SceneDifference> differences = scene_differences(run, other);
  if (std::holds_alternative<RunRecord>(other))  // a scene can have more swimmers than its record lists
    add_differences(differences, {{"swimmers", swimmers_value(swimmers_of(run))}},
                    {{"swimmers", swimmers_value(swimmers_of(other))}});
  return differences;
}

void require_one_scene(const RunFile& run, const SourceDocument& other) {
  std::vector<std::string> words;
  for (const SceneDifference& difference : find_differences(run.record, other.document))
    words.push_back(in_words(difference));
  if (words.empty()) return;
  throw InputError(
      other.source,
      "the scene differs from the scene of {}: {}; all files of this figure must have the same scene",
      run.source, joined(words, "; "));
}

/// Returns the relative uncertainty of a quantity of the reference: of a prediction the largest of its
/// numbers, of a run the root mean square over numbers and swimmers. Returns nullopt if none is stated.
std::optional<double> uncertainty_of(const ComparedScene& scene, ResultQuantity quantity) {
  std::optional<double> largest;
  double change = 0, square = 0;
  for (const Results& results : scene.correct) {
    const auto found = results.find(quantity);
    if (found == results.end()) continue;
    const auto& numbers = found->second.numbers;
    const auto& uncertainties = found->second.uncertainties;
    for (std::size_t i = 0; i < uncertainties.size(); ++i) {
      largest = std::max(largest.value_or(0), uncertainties[i]);
      change += std::pow(uncertainties[i] * numbers[i], 2);
      square += std::pow(numbers[i], 2);
    }
  }
  if (scene.swimmer) return largest;
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

/// Takes the reference values of a prediction or of a run, and returns it as a document.
SourceDocument take_reference(const PlottedPrediction& plotted, ComparedScene& scene) {
  scene.reference = plotted.prediction().method;
  scene.swimmer = plotted.document.swimmer;
  scene.correct = {plotted.results()};
  return {plotted.source, plotted.document};
}
SourceDocument take_reference(const RunFile& run, const CycleChoice& cycle, ComparedScene& scene) {
  scene.reference = run.record.model;
  if (const auto& resolution = run.record.resolution)
    scene.reference +=
        fmt::format(", {}, {:g} cells per radius", resolution->bead_boundary, resolution->cells_per_radius);
  for (const SwimmerRecord& swimmer : run.record.swimmers)
    scene.correct.push_back(results_of(run.record, swimmer, cycle, run.source, RunUncertainty::of_cycle));
  return {run.source, run.record};
}

/// Reads the file of a reference and collects the runs of its scene: all runs if there is one reference.
ComparedScene read_scene(const PlotInputs& inputs, const std::string& file, const SpeedFlags& flags) {
  const bool has_several_scenes = flags.references.size() > 1;
  const PlotInputs read = read_plot_inputs({file}, flags.choice);
  if (read.runs.size() + read.predictions.size() != 1) {
    throw InputError(
        file,
        "the file contains several runs or predictions, but errors are relative to one reference; name one "
        "method with --method, or give a file with one run or one prediction");
  }
  if (has_several_scenes && read.runs.empty())
    throw InputError(file, "with several references, each must be a run record, which states its scene");
  if (read.units != inputs.units)
    throw InputError(
        file, "the units of the reference differ from the units of {}; make both files from one layout",
        inputs.runs.front().source);
  ComparedScene scene;
  const SourceDocument reference = read.runs.empty()
                                       ? take_reference(read.predictions[0], scene)
                                       : take_reference(read.runs[0], flags.choice.cycle, scene);
  for (const RunFile& run : inputs.runs)
    if (!has_several_scenes || find_differences(run.record, reference.document).empty())
      scene.runs.push_back(&run);
  if (scene.runs.empty())
    throw InputError(file,
                     "no run has the scene of this reference; add its runs, or leave the reference out");
  require_one_scene(*scene.runs.front(), reference);
  if (has_several_scenes) scene.title = scene_title(scene.runs.front()->record);
  return scene;
}

/// Returns the scenes of all references. Throws InputError if a run has the scene of none or of several.
std::vector<ComparedScene> read_scenes(const PlotInputs& inputs, const SpeedFlags& flags) {
  std::vector<ComparedScene> scenes;
  for (const std::string& file : flags.references) scenes.push_back(read_scene(inputs, file, flags));
  for (const RunFile& run : inputs.runs) {
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

/// Returns the cost of a run in core-seconds per driving period.
double cost_of(const RunFile& run) {
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
                     record.resolution->levels.size() > 1 ? ", levels" : "");
}

/// Throws InputError if two runs use different bead radii or densities on the lattice. The flags
/// --radius-correction and --delay-correction change these values.
void require_same_corrections(const RunFile& run, const RunFile& other) {
  const auto &a = run.record.resolution, &b = other.record.resolution;
  if (!a || (a->radius_on_lattice == b->radius_on_lattice && a->density_on_lattice == b->density_on_lattice))
    return;
  throw InputError(run.source,
                   "this run differs from the run {} only in --radius-correction or --delay-correction; draw "
                   "the two runs in separate figures",
                   other.source);
}

/// Returns the results of the swimmers of which the reference contains values. Throws InputError if one has
/// another number of arms than in the reference.
std::vector<Results> results_of(const RunFile& run, const ComparedScene& scene, const CycleChoice& cycle) {
  const auto arms = [](const Results& results) {
    return count_numbers(results, ResultQuantity::arm_amplitudes);
  };
  std::vector<SwimmerRecord> wanted = run.record.swimmers;
  if (scene.swimmer) wanted = {find_swimmer(run.record, *scene.swimmer, run.source)};
  std::vector<Results> swimmers;
  for (const SwimmerRecord& swimmer : wanted)
    swimmers.push_back(results_of(run.record, swimmer, cycle, run.source));
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    if (arms(scene.correct[s]) == arms(swimmers[s])) continue;
    throw InputError(run.source,
                     "swimmer {} has {} arms, but {} in the reference ({}); give the reference of this scene",
                     wanted[s].id, arms(swimmers[s]), arms(scene.correct[s]), scene.reference);
  }
  return swimmers;
}

std::vector<CostedRun> costed_runs(const ComparedScene& scene, const CycleChoice& cycle) {
  std::vector<CostedRun> runs;
  const SourceDocument first{scene.runs.front()->source, scene.runs.front()->record};
  for (const RunFile* run : scene.runs) {
    CostedRun costed{.source = run->source, .setting = setting_name(run->record), .swimmers = {}};
    if (run->record.resolution) costed.resolution = run->record.resolution->cells_per_radius;
    require_one_scene(*run, first);
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (runs[r].setting == costed.setting && runs[r].resolution == costed.resolution)
        require_same_corrections(*run, *scene.runs[r]);
    costed.cost = cost_of(*run);
    costed.swimmers = results_of(*run, scene, cycle);
    runs.push_back(std::move(costed));
  }
  return runs;
}

std::string resolutions_note(const PlotInputs& inputs) {
  std::set<double> known;
  for (const RunFile& run : inputs.runs)
    if (run.record.resolution) known.insert(run.record.resolution->cells_per_radius);
  return known.empty() ? ""
                       : fmt::format("Lines join runs with {:g} to {:g} cells per radius.", *known.begin(),
                                     *known.rbegin());
}

Figure run_figure(const PlotFiles& files, const SpeedFlags& flags) {
  for (const std::string& file : flags.references) require_other_file(file, files.output);
  const PlotInputs inputs = read_plot_inputs(files.inputs, {.cycle = flags.choice.cycle});
  if (inputs.runs.empty() || !inputs.predictions.empty()) {
    throw InputError(
        "speed-against-error",
        "this figure draws only run records; name run records as files, and a prediction with --reference");
  }
  std::vector<SceneErrors> scenes;
  std::set<std::string> references;
  for (const ComparedScene& scene : read_scenes(inputs, flags)) {
    references.insert(scene.reference);
    scenes.push_back({errors_by_setting(costed_runs(scene, flags.choice.cycle), scene.correct), scene.title});
    for (const ResultQuantity quantity : {ResultQuantity::velocity, ResultQuantity::arm_amplitudes})
      if (const auto uncertainty = uncertainty_of(scene, quantity))
        scenes.back().uncertainties[quantity] = *uncertainty;
  }
  const Figure figure =
      error_figure(scenes, flags.quantity, "core-seconds per period",
                   {{.text = fmt::format("Root mean square of errors relative to the reference ({}).",
                                         joined(references, "; "))},
                    {.text = resolutions_note(inputs)}});
  if (figure.panels.empty())
    throw InputError("--quantity", "the swimmers have no arms, and so no arm amplitudes; leave the flag out");
  return figure;
}

Figure verdict_figure(const PlotFiles& files, const SpeedFlags& flags) {
  std::set<std::string> methods;
  const auto errors = read_verdicts(files.inputs, flags.choice.methods, methods);
  return error_figure(
      {{errors}}, std::nullopt, "core-seconds",
      {{.text =
            fmt::format("Marks are verdicts: root mean square of errors relative to {}, and core-seconds of "
                        "complete runs.",
                        summarise_names(methods, "methods"))}});
}

}  // namespace

DrawFigure add_speed_flags(CLI::App& command) {
  const auto flags = std::make_shared<SpeedFlags>();
  add_result_flags(command, flags->choice);
  add_value(command, "--reference", flags->references, {.name = "FILE,...", .initial = "none"},
            "Prediction or run record from which errors of runs are measured, or one run record per scene; "
            "required if FILES are run records")
      ->delimiter(',');
  add_word(command, "--quantity",
           {to_text(ResultQuantity::velocity), to_text(ResultQuantity::arm_amplitudes)}, "",
           "Quantity whose errors of run records are drawn",
           [flags](const std::string& word) { flags->quantity = from_text<ResultQuantity>(word); })
      ->default_str("both");
  return [flags, cycle = command.get_option("--cycle")](const PlotFiles& files) {
    if (!flags->references.empty()) return draw(run_figure(files, *flags));
    if (!cycle->empty() && cycle->results().front() != "last") {
      throw InputError("--cycle",
                       "each verdict already states which cycle was compared; leave --cycle out, or draw run "
                       "records with --reference instead of verdicts");
    }
    if (flags->quantity)
      throw InputError(
          "--quantity",
          "is for run records; leave it out, or draw run records with --reference instead of verdicts");
    return draw(verdict_figure(files, *flags));
  };
}

}  // namespace beadswim
