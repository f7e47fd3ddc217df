#include "plot_labels.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "beadswim/documents/study_text.hpp"

namespace beadswim {
namespace {

struct Parameter {
  const char* key;
  const char* symbol;
  const char* unit = "";  ///< begins with a space
};

constexpr std::array parameters{Parameter{"period", "T"}, Parameter{"separation_ratio", "l/λ"},
                                Parameter{"amplitude", "A"}, Parameter{"amplitude_ratio", "A/B"},
                                Parameter{.key = "phase", .symbol = "α", .unit = " rad"}};

/// Returns a parameter and its range, "T = 4800" or "T = 1000 to 10000". Returns an empty text if a
/// prediction does not state the parameter.
std::string parameter_text(const std::vector<PlottedPrediction>& predictions, const Parameter& parameter) {
  std::vector<double> values;
  for (const PlottedPrediction& plotted : predictions) {
    const auto value = number_setting(plotted.prediction, parameter.key);
    if (!value) return {};
    values.push_back(*value);
  }
  return fmt::format("{} = {}{}", parameter.symbol, range_text(values, 4), parameter.unit);
}

/// Returns the fluid of predictions as text. `fluid`: their setting "fluid".
std::string name_of_fluid(const std::string& fluid) {
  constexpr std::string_view half_space = "half-space", unbounded = "unbounded";
  if (fluid.starts_with(half_space)) return "fluid over a wall" + fluid.substr(half_space.size());
  if (fluid.starts_with(unbounded)) return "unbounded fluid" + fluid.substr(unbounded.size());
  return "the layout's box";
}

/// Returns the fluids for which predictions were made, for example "unbounded fluid; inertia-corrected in the
/// layout's box". The fluid of most methods comes first, without their names.
std::string fluid_text(const std::vector<PlottedPrediction>& predictions) {
  std::map<std::string, std::set<std::string>> methods;  // by fluid
  std::set<std::string> names;
  std::size_t pairs = 0;
  for (const PlottedPrediction& plotted : predictions) {
    const auto fluid = text_setting(plotted.prediction, "fluid");
    if (!fluid) return {};
    pairs += methods[name_of_fluid(*fluid)].insert(plotted.prediction.method).second ? 1 : 0;
    names.insert(plotted.prediction.method);
  }
  if (methods.empty()) return {};
  const bool has_method_one_fluid = pairs == names.size();
  const auto usual = std::ranges::max_element(
      methods, {}, [](const auto& of_fluid) { return std::pair(of_fluid.second.size(), of_fluid.first); });
  std::string text = usual->first == "the layout's box" ? "in the layout's box" : usual->first;
  for (auto other = methods.begin(); other != methods.end(); ++other) {
    if (other == usual) continue;
    text += has_method_one_fluid
                ? fmt::format("; {} in {}", summarise_names(other->second, "methods"), other->first)
                : "; " + other->first;
  }
  return text;
}

/// Returns the range of a quantity over all runs that have it.
std::string run_range(const PlotInputs& inputs, int digits,
                      const std::function<std::optional<double>(const RunRecord&)>& number) {
  std::vector<double> numbers;
  for (const PlottedRun& run : inputs.runs) {
    if (const auto value = number(run.record)) numbers.push_back(*value);
  }
  return range_text(numbers, digits);
}

/// Texts for model, bead boundary, resolution, relaxation time, precision and box of a run; a text is empty
/// if the run has no such setting.
using SettingTexts = std::array<std::string, 6>;

/// Returns the settings of a run as texts. The relaxation time has only two digits, because each run adjusts
/// the requested value slightly to its period.
SettingTexts setting_of(const RunRecord& record) {
  SettingTexts setting{record.model};
  if (const auto& resolution = record.resolution) {
    setting[1] = resolution->bead_boundary;
    setting[2] = fmt::format("{:g} cells per radius", resolution->cells_per_radius);
    setting[3] = fmt::format("τ = {:.2g}", resolution->relaxation_time);
    setting[4] = resolution->precision;
  }
  if (record.domain != Domain{}) setting[5] = in_words(record.domain);
  return setting;
}

/// Returns the text of the setting at this position if all runs have the same; otherwise an empty text.
std::string shared_setting(const PlotInputs& inputs, std::size_t position) {
  const std::string first = setting_of(inputs.runs.front().record)[position];
  const auto is_first = [&](const PlottedRun& run) { return setting_of(run.record)[position] == first; };
  return std::ranges::all_of(inputs.runs, is_first) ? first : "";
}

/// Returns the texts that are not empty, separated by commas.
std::string join_texts(std::vector<std::string> texts) {
  std::erase(texts, "");
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string lattice_text(const PlotInputs& inputs) {
  const auto has_lattice = [](const PlottedRun& run) { return run.record.resolution.has_value(); };
  if (std::ranges::none_of(inputs.runs, has_lattice)) return {};
  const auto cells = [](const RunRecord& record) {
    return record.resolution ? std::optional(record.resolution->cells_per_radius) : std::nullopt;
  };
  const auto relaxation_time = [](const RunRecord& record) {
    return record.resolution ? std::optional(record.resolution->relaxation_time) : std::nullopt;
  };
  return join_texts({run_range(inputs, 4, cells) + " cells per radius",
                     "τ = " + run_range(inputs, 4, relaxation_time), shared_setting(inputs, 1),
                     shared_setting(inputs, 4)});
}

}  // namespace

std::string varied_text(const PlotInputs& inputs, const Json& study) {
  if (!study.is_object()) return {};
  std::map<std::string, std::set<Json>> values;
  for (const Json& other : studies_of(inputs))
    for (const auto& [name, value] : other.items()) values[name].insert(value);
  Json varied = Json::object();
  for (const auto& [name, value] : study.items())
    if (values[name].size() > 1) varied[name] = value;
  return varied.empty() ? "" : ", " + study_text(varied, 4);
}

std::string run_label(const PlotInputs& inputs, const PlottedRun& run) {
  if (inputs.runs.size() == 1) return run.record.model;
  const std::string varied = varied_text(inputs, study_of(run));
  if (!varied.empty()) return run.record.model + varied;
  return fmt::format("{} {}", run.record.model, std::filesystem::path(run.source).filename().string());
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string range_text(const std::vector<double>& numbers, int digits) {
  if (numbers.empty()) return {};
  const auto [low, high] = std::ranges::minmax(numbers);
  const std::string first = fmt::format("{:.{}g}", low, digits), last = fmt::format("{:.{}g}", high, digits);
  return first == last ? first : first + " to " + last;
}

std::string cycles_text(const std::vector<double>& cycles) {
  const std::string range = range_text(cycles, 4);
  return range + (range == "1" ? " cycle" : " cycles");
}

std::string summarise_names(const std::set<std::string>& names, const std::string& plural) {
  constexpr std::size_t max_names = 3;
  if (names.size() > max_names) return fmt::format("{} {}", names.size(), plural);
  return fmt::format("{}", fmt::join(names, ", "));
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

Note run_note(const PlotInputs& inputs, std::optional<AbscissaKind> abscissa) {
  if (inputs.runs.empty()) return {};
  const auto period = [](const RunRecord& record) { return std::optional(record.driving.period); };
  const auto if_known = [](double number) { return number > 0 ? std::optional(number) : std::nullopt; };
  const auto depth = [&](const RunRecord& record) {
    return if_known(record.dimensionless.penetration_depth_over_radius);
  };
  const auto reynolds = [&](const RunRecord& record) { return if_known(record.dimensionless.reynolds_bead); };
  const auto named = [](const std::string& name, const std::string& range) {
    return range.empty() ? "" : name + " = " + range;
  };
  const std::string reynolds_text = named("Re", run_range(inputs, 2, reynolds));
  std::string text =
      "Runs: " + join_texts({abscissa == AbscissaKind::period ? "" : named("T", run_range(inputs, 6, period)),
                             abscissa ? "" : named("δ/λ", run_range(inputs, 3, depth)), reynolds_text});
  if (const std::string lattice = lattice_text(inputs); !lattice.empty()) text += "; " + lattice;
  if (const std::string box = shared_setting(inputs, 5); !box.empty()) text += "; " + box;
  return {
      .text = text,
      .summary = reynolds_text.empty() ? "" : fmt::format("{} runs: {}", inputs.runs.size(), reynolds_text)};
}

std::vector<Note> prediction_notes(const PlotInputs& inputs, AbscissaKind abscissa) {
  if (inputs.predictions.empty()) return {};
  std::vector<std::string> texts;
  for (const Parameter& parameter : parameters) {
    if (parameter.key != to_text(abscissa)) texts.push_back(parameter_text(inputs.predictions, parameter));
  }
  const std::string fluid = fluid_text(inputs.predictions);
  texts.push_back(fluid);
  std::vector<Note> notes;
  if (const std::string text = join_texts(texts); !text.empty()) {
    notes.push_back(
        {.text = "Predictions: " + text, .summary = "Predictions: " + join_texts({texts.front(), fluid})});
  }
  const auto usable = [](const PlottedPrediction& plotted) { return plotted.prediction.usable; };
  if (!std::ranges::all_of(inputs.predictions, usable))
    notes.push_back({.text = "Thin and pale: unusable predictions."});
  return notes;
}

Note reading_note(const PlotInputs& inputs) {
  if (inputs.runs.empty()) return {.text = "Theories agree where their lines coincide."};
  if (inputs.predictions.empty()) return {.text = "Each mark is one swimmer of a run."};
  return {.text = "Marks are runs; marks on a line agree with that prediction."};
}

}  // namespace beadswim
