#include "plot_labels.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>
#include <utility>

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

/// Which fluid the predictions are for: "unbounded fluid; inertia-corrected in the layout's box".
std::string fluid_text(const std::vector<PlottedPrediction>& predictions) {
  std::set<std::string> boxed, open;
  for (const PlottedPrediction& plotted : predictions) {
    const auto fluid = text_setting(plotted.prediction, "fluid");
    if (!fluid) return {};
    (*fluid == "unbounded" ? open : boxed).insert(plotted.prediction.method);
  }
  if (boxed.empty()) return "unbounded fluid";
  if (open.empty()) return "in the layout's box";
  return fmt::format("unbounded fluid; {} in the layout's box", fmt::join(boxed, ", "));
}

/// "4800", or "1000 to 10000".
std::string range_text(const std::vector<const PlottedRun*>& runs, int digits,
                       const std::function<double(const RunRecord&)>& number) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PlottedRun* run : runs) {
    low = std::min(low, number(run->record));
    high = std::max(high, number(run->record));
  }
  const std::string first = fmt::format("{:.{}g}", low, digits), last = fmt::format("{:.{}g}", high, digits);
  return first == last ? first : first + " to " + last;
}

/// What sets a lattice run apart, in words; its relaxation time as asked for, before it was fitted to the
/// period, as far as two digits tell.
using SettingTexts = std::array<std::string, 6>;

SettingTexts setting_of(const RunRecord& record) {
  SettingTexts setting{record.model};
  if (const auto& resolution = record.resolution) {
    setting[1] = resolution->bead_boundary;
    setting[2] = fmt::format("{:g} cells per radius", resolution->cells_per_radius);
    setting[3] = fmt::format("τ = {:.2g}", resolution->relaxation_time);
    setting[4] = resolution->precision;
  }
  if (record.domain) {
    const Vec3& box = record.domain->lengths;
    setting[5] = fmt::format("box {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
  }
  return setting;
}

/// On runs of one setting.
std::string note_on(const std::string& label, const std::vector<const PlottedRun*>& runs) {
  std::string note = fmt::format(
      "{}: T = {}, δ/λ = {}, Re = {}", label,
      range_text(runs, 6, [](const RunRecord& record) { return record.driving.period; }),
      range_text(runs, 3,
                 [](const RunRecord& record) { return record.dimensionless.penetration_depth_over_radius; }),
      range_text(runs, 2, [](const RunRecord& record) { return record.dimensionless.reynolds_bead; }));
  const RunRecord& record = runs.front()->record;
  const SettingTexts setting = setting_of(record);
  if (const auto& resolution = record.resolution) {
    note += fmt::format("; {}, τ = {}, {}, {}", setting[2],
                        range_text(runs, 4, [](const RunRecord& r) { return r.resolution->relaxation_time; }),
                        resolution->bead_boundary, resolution->precision);
  }
  if (!setting[5].empty()) note += "; " + setting[5];
  return note;
}

}  // namespace

std::string run_label(const PlotInputs& inputs, const PlottedRun& run) {
  if (inputs.runs.size() == 1) return run.record.model;
  return fmt::format("{} {}", run.record.model, std::filesystem::path(run.source).filename().string());
}

std::vector<std::string> run_notes(const PlotInputs& inputs) {
  std::vector<std::string> notes;
  for (const PlottedRun& run : inputs.runs) notes.push_back(note_on(run_label(inputs, run), {&run}));
  return notes;
}

std::vector<RunGroup> runs_by_setting(const PlotInputs& inputs) {
  std::vector<std::pair<SettingTexts, std::vector<const PlottedRun*>>> groups;
  for (const PlottedRun& run : inputs.runs) {
    const SettingTexts setting = setting_of(run.record);
    auto group = std::ranges::find(groups, setting, [](const auto& each) { return each.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {setting, {}});
    group->second.push_back(&run);
  }
  std::vector<RunGroup> result;
  for (const auto& [setting, runs] : groups) {
    std::vector<std::string> parts;
    for (std::size_t p = 1; p < setting.size(); ++p) {  // the model is in every label
      const auto same = [&, part = setting[p]](const auto& each) { return each.first[p] == part; };
      if (!setting[p].empty() && !std::ranges::all_of(groups, same)) parts.push_back(setting[p]);
    }
    const std::string& model = runs.front()->record.model;
    result.push_back({parts.empty() ? model : fmt::format("{} {}", model, fmt::join(parts, ", ")), runs});
  }
  return result;
}

std::vector<std::string> group_notes(const std::vector<RunGroup>& groups) {
  std::vector<std::string> notes;
  for (const RunGroup& group : groups) notes.push_back(note_on(group.label, group.runs));
  return notes;
}

std::vector<std::string> prediction_notes(const PlotInputs& inputs, Abscissa abscissa) {
  if (inputs.predictions.empty()) return {};
  std::vector<std::string> texts, notes;
  for (const Parameter& parameter : parameters) {
    const std::string text = parameter_text(inputs.predictions, parameter);
    if (!text.empty() && parameter.key != to_text(abscissa)) texts.push_back(text);
  }
  if (const std::string fluid = fluid_text(inputs.predictions); !fluid.empty()) texts.push_back(fluid);
  if (!texts.empty()) notes.push_back(fmt::format("Predictions: {}", fmt::join(texts, ", ")));
  const auto usable = [](const PlottedPrediction& plotted) { return plotted.prediction.usable; };
  if (!std::all_of(inputs.predictions.begin(), inputs.predictions.end(), usable)) {
    notes.push_back("Thin and pale: predictions that are marked as not usable; their validity says why");
  }
  return notes;
}

}  // namespace beadswim
