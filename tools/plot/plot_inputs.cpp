#include "plot_inputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"

namespace beadswim {
namespace {

struct SourceDocument {
  std::string source;
  SwimmingDocument document;
};

const Units& units_of(const SwimmingDocument& document) {
  return std::visit([](const auto& alternative) -> const Units& { return alternative.units; }, document);
}

void require_same_units(const std::vector<SourceDocument>& documents) {
  const SourceDocument& first = documents.front();
  for (const SourceDocument& other : documents) {
    if (same_units(units_of(first.document), units_of(other.document))) continue;
    throw InputError(
        other.source,
        fmt::format("is in other units than {}; one figure holds one system of units", first.source));
  }
}

/// The best usable prediction, as beadswim-compare picks it.
std::vector<Prediction> best_prediction(const PredictionDocument& document, const std::string& source) {
  std::vector<Reference> references;
  for (const Prediction& prediction : document.predictions) {
    references.push_back({source, prediction.method, prediction.usable, swimming_of(prediction)});
  }
  const auto best = best_reference(references, compared_quantities);
  if (!best) throw InputError(source, "holds no usable method; name the methods to draw with --method");
  return {document.predictions[*best]};
}

std::vector<Prediction> named_predictions(const PredictionDocument& document,
                                          const std::vector<std::string>& methods) {
  std::vector<Prediction> chosen;
  for (const std::string& method : methods) {
    for (const Prediction& prediction : document.predictions) {
      if (prediction.method == method) chosen.push_back(prediction);
    }
  }
  return chosen;
}

std::vector<PlottedPrediction> plotted(const PredictionDocument& document, const std::string& source,
                                       const std::vector<std::string>& methods) {
  const auto period = driving_period(document);
  if (!period) throw InputError(source, "does not say the period of the driving in its settings");
  std::vector<PlottedPrediction> result;
  for (Prediction& prediction :
       methods.empty() ? best_prediction(document, source) : named_predictions(document, methods)) {
    result.push_back({source, std::move(prediction), *period});
  }
  return result;
}

/// A method that no prediction has is a slip of the pen.
void require_known(const std::vector<std::string>& methods, const std::vector<SourceDocument>& documents) {
  std::set<std::string> known;
  for (const SourceDocument& file : documents) {
    if (const auto* document = std::get_if<PredictionDocument>(&file.document)) {
      for (const Prediction& prediction : document->predictions) known.insert(prediction.method);
    }
  }
  for (const std::string& method : methods) {
    if (known.contains(method)) continue;
    throw InputError("--method", fmt::format("no prediction has \"{}\"; did you mean \"{}\"?", method,
                                             nearest_name(method, {known.begin(), known.end()})));
  }
}

std::vector<SourceDocument> read_documents(const std::vector<std::string>& files) {
  if (files.empty()) throw InputError("FILES", "no file given; name run records and predictions to draw");
  if (std::count(files.begin(), files.end(), "-") > 1) {
    throw InputError("-", "standard input can be read once; name files for the other inputs");
  }
  std::vector<SourceDocument> documents;
  for (const std::string& path : files) documents.push_back({source_name(path), read_swimming(path)});
  return documents;
}

}  // namespace

PlotInputs read_plot_inputs(const std::vector<std::string>& files, const std::vector<std::string>& methods) {
  std::vector<SourceDocument> documents = read_documents(files);
  require_same_units(documents);
  require_known(methods, documents);
  PlotInputs inputs;
  inputs.units = units_of(documents.front().document);
  for (SourceDocument& file : documents) {
    if (auto* run = std::get_if<RunRecord>(&file.document)) {
      inputs.runs.push_back({file.source, std::move(*run)});
      continue;
    }
    const auto more = plotted(std::get<PredictionDocument>(file.document), file.source, methods);
    inputs.predictions.insert(inputs.predictions.end(), more.begin(), more.end());
  }
  return inputs;
}

std::string length_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name;
}

std::string time_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.time.name;
}

std::string velocity_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name + "/" + units.time.name;
}

std::vector<std::string> run_notes(const PlotInputs& inputs) {
  std::vector<std::string> notes;
  for (const PlottedRun& run : inputs.runs) {
    const RunRecord& record = run.record;
    std::string note =
        fmt::format("{}: T = {:g}, δ/λ = {:.3g}, Re = {:.2g}", run_label(inputs, run), record.driving_period,
                    record.dimensionless.penetration_depth_over_radius, record.dimensionless.reynolds_bead);
    if (const auto& resolution = record.resolution) {
      note += fmt::format("; {:g} cells per radius, τ = {:.4g}, {}, {}", resolution->cells_per_radius,
                          resolution->relaxation_time, resolution->bead_boundary, resolution->precision);
    }
    if (record.domain) {
      const Vec3& box = record.domain->lengths;
      note += fmt::format("; box {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
    }
    notes.push_back(note);
  }
  return notes;
}

std::string run_label(const PlotInputs& inputs, const PlottedRun& run) {
  if (inputs.runs.size() == 1) return run.record.model;
  return fmt::format("{} {}", run.record.model, std::filesystem::path(run.source).filename().string());
}

}  // namespace beadswim
