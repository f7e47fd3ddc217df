#include "plot_inputs.hpp"

#include <algorithm>

#include "beadswim/compare/comparison.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Returns the usable prediction with the best method, in the order of preference of beadswim-compare.
const Prediction& best_prediction(const PredictionDocument& document, const std::string& source) {
  std::vector<Reference> references;
  for (const Prediction& prediction : document.predictions) {
    references.push_back({.source = source,
                          .method = prediction.method,
                          .usable = prediction.usable,
                          .results = results_of(prediction, nullptr, document.swimmer)});
  }
  const auto best = best_reference(references, default_quantities);
  if (!best)
    throw InputError(source,
                     "no prediction in the document is usable; to draw some anyway, name their methods with "
                     "--method");
  return document.predictions[*best];
}

PlottedPrediction plotted(PredictionDocument document, const std::string& source, Prediction prediction) {
  document.predictions = {std::move(prediction)};
  return {source, std::move(document)};
}

/// Appends the predictions by the methods in `methods`, in this order, to `result`.
void append_named(const PredictionDocument& document, const std::string& source, const Names& methods,
                  std::vector<PlottedPrediction>& result) {
  for (const std::string& method : methods)
    for (const Prediction& prediction : document.predictions)
      if (prediction.method == method) result.push_back(plotted(document, source, prediction));
}

/// Adds the method of a prediction to the names, which are in the order of first predictions.
void add_method(const Prediction& prediction, Names& methods) {
  if (!contains(methods, prediction.method)) methods.push_back(prediction.method);
}

/// Throws InputError if no prediction was made by the method. `flag`: flag that names the method, for the
/// message.
void require_known(const std::string& method, const std::string& flag, const Names& known) {
  if (contains(known, method)) return;
  if (known.empty()) {
    throw InputError(flag,
                     "the method \"{}\" names the predictions to draw, but no file of predictions is given; "
                     "add a file that beadswim-theory printed",
                     method);
  }
  throw InputError(flag, "no prediction has the method \"{}\"{} The predictions have the methods {}", method,
                   format_suggestion(method, known), joined(known, ", "));
}

/// Replaces the method name "all" by the methods of all documents. Throws InputError if none of them has a
/// named method.
InputChoice resolve_methods(InputChoice choice, const std::vector<SourceDocument>& documents) {
  Names known;
  for (const SourceDocument& file : documents)
    if (const auto* document = std::get_if<PredictionDocument>(&file.document))
      for (const Prediction& prediction : document->predictions) add_method(prediction, known);
  if (choice.methods == Names{"all"}) choice.methods = known;
  for (const std::string& method : choice.methods) require_known(method, "--method", known);
  if (!choice.relative_to.empty()) require_known(choice.relative_to, "--relative-to", known);
  return choice;
}

/// Converts a JSON document that a figure can show.
SwimmingDocument document_to_draw(const Json& json, const std::string& source) {
  if (schema_of(json).starts_with("beadswim/verdict/"))
    throw InputError(source,
                     "the document is a verdict; verdicts are drawn only by beadswim-plot "
                     "speed-against-error, without --reference; leave this file out");
  return swimming_from_json(json, source);
}

/// Adds the swimmers of a run that have the chosen cycles. Throws InputError if there are none.
void append(RunRecord run, const std::string& source, const CycleChoice& cycle, PlotInputs& inputs) {
  if (run.status == RunStatus::failed) throw InputError(source, "the run has failed; run again");
  const auto lacks_cycles = [&](const SwimmerRecord& each) {
    return find_cycles(each.cycles, cycle).empty();
  };
  if (std::ranges::all_of(run.swimmers, lacks_cycles))
    select_cycles(run.swimmers.empty() ? std::vector<CycleStatistics>() : run.swimmers.front().cycles, cycle,
                  source);
  std::erase_if(run.swimmers, lacks_cycles);
  inputs.runs.push_back({source, std::move(run)});
}

}  // namespace

void require_same_units(const Units& units, const std::string& source, const Units& first,
                        const std::string& first_source) {
  if (units == first) return;
  throw InputError(
      source,
      "the units of this file differ from the units of {}; all files of a figure must have the same units",
      first_source);
}

std::string only_file(const std::vector<std::string>& files, const std::string& rule) {
  if (files.size() == 1) return files.front();
  throw InputError("FILES", "{} files are given; {}; give one file", files.size(), rule);
}

std::vector<Json> PlotInputs::studies() const {
  std::vector<Json> studies;
  for (const RunFile& run : runs) studies.push_back(run.study());
  for (const PlottedPrediction& plotted : predictions) studies.push_back(plotted.document.study);
  std::erase_if(studies, [](const Json& study) { return !study.is_object(); });
  return studies;
}

Results PlottedPrediction::results() const {
  return results_of(prediction(), document.scene ? &*document.scene : nullptr, document.swimmer);
}

PlotInputs read_plot_inputs(const std::vector<std::string>& files, const InputChoice& wanted) {
  ReadDocuments read = read_documents(files, "a run record or a prediction", document_to_draw);
  const int count = read.count();
  int left_out = read.failures;
  std::vector<SourceDocument>& documents = read.documents;
  if (documents.empty()) report_left_out("beadswim-plot", left_out, count);
  PlotInputs inputs{.units = units_of(documents.front().document)};
  for (const SourceDocument& file : documents)
    require_same_units(units_of(file.document), file.source, inputs.units, documents.front().source);
  const InputChoice choice = resolve_methods(wanted, documents);
  inputs.methods = choice.methods;
  std::optional<InputError> reason;
  for (SourceDocument& file : documents) {
    try {
      if (auto* run = std::get_if<RunRecord>(&file.document)) {
        append(std::move(*run), file.source, choice.cycle, inputs);
        continue;
      }
      const auto& document = std::get<PredictionDocument>(file.document);
      if (choice.methods.empty()) {
        inputs.predictions.push_back(plotted(document, file.source, best_prediction(document, file.source)));
        add_method(inputs.predictions.back().prediction(), inputs.methods);
      }
      append_named(document, file.source, choice.methods, inputs.predictions);
      append_named(document, file.source, {choice.relative_to}, inputs.references);
    } catch (const InputError& error) {
      if (!reason) reason = error;
      ++left_out;
    }
  }
  if (reason && inputs.runs.empty() && inputs.predictions.empty()) throw *reason;
  report_left_out("beadswim-plot", left_out, count);
  return inputs;
}

}  // namespace beadswim
