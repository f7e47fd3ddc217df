#include "plot_labels.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace beadswim {
namespace {

struct Parameter {
  const char* key;
  const char* symbol;
};

constexpr std::array parameters{Parameter{"period", "T"}, Parameter{"separation_ratio", "l/λ"},
                                Parameter{"amplitude", "A"}, Parameter{"amplitude_ratio", "A/B"},
                                Parameter{"phase", "α"}};

/// "T = 4800", or "T = 1000 to 10000"; empty if a prediction does not say.
std::string parameter_text(const std::vector<PlottedPrediction>& predictions, const Parameter& parameter) {
  std::vector<double> values;
  for (const PlottedPrediction& plotted : predictions) {
    const auto value = number_setting(plotted.prediction, parameter.key);
    if (!value) return {};
    values.push_back(*value);
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string first = fmt::format("{} = {:.4g}", parameter.symbol, *low);
  const std::string last = fmt::format("{} = {:.4g}", parameter.symbol, *high);
  return first == last ? first : first + fmt::format(" to {:.4g}", *high);
}

}  // namespace

std::string length_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name;
}

std::string velocity_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name + "/" + units.time.name;
}

std::string run_label(const PlotInputs& inputs, const PlottedRun& run) {
  if (inputs.runs.size() == 1) return run.record.model;
  return fmt::format("{} {}", run.record.model, std::filesystem::path(run.source).filename().string());
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

std::vector<std::string> prediction_notes(const PlotInputs& inputs, Abscissa abscissa) {
  if (inputs.predictions.empty()) return {};
  std::vector<std::string> texts, notes;
  for (const Parameter& parameter : parameters) {
    const std::string text = parameter_text(inputs.predictions, parameter);
    if (!text.empty() && parameter.key != key_of(abscissa)) texts.push_back(text);
  }
  if (!texts.empty()) notes.push_back(fmt::format("Predictions: {}", fmt::join(texts, ", ")));
  const auto usable = [](const PlottedPrediction& plotted) { return plotted.prediction.usable; };
  if (!std::all_of(inputs.predictions.begin(), inputs.predictions.end(), usable)) {
    notes.push_back("Thin and pale: predictions that are marked as not usable; their validity says why");
  }
  return notes;
}

}  // namespace beadswim
