#include "plot_labels.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include "beadswim/core/joined.hpp"

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
    const auto value = find_setting<double>(plotted.prediction(), parameter.key);
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
    const auto fluid = find_setting<std::string>(plotted.prediction(), "fluid");
    if (!fluid) return {};
    pairs += methods[name_of_fluid(*fluid)].insert(plotted.prediction().method).second ? 1 : 0;
    names.insert(plotted.prediction().method);
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

/// Texts for bead boundary, resolution, relaxation time, precision and box of a run; a text is empty if the
/// run has no such setting.
using SettingTexts = std::array<std::string, 5>;

/// Returns the settings of a run as texts. The relaxation time has only two digits, because each run adjusts
/// the requested value slightly to its period.
SettingTexts setting_of(const RunRecord& record) {
  SettingTexts setting;
  if (const auto& resolution = record.resolution)
    setting = {resolution->bead_boundary, fmt::format("{:g} cells per radius", resolution->cells_per_radius),
               fmt::format("τ = {:.2g}", resolution->relaxation_time), resolution->precision};
  if (record.domain != Domain{}) setting.back() = in_words(record.domain);
  return setting;
}

/// Returns the settings that all runs have; the texts of others are empty.
SettingTexts shared_settings(const std::vector<RunFile>& runs) {
  SettingTexts shared;
  if (!runs.empty()) shared = setting_of(runs.front().record);
  for (const RunFile& run : runs) {
    const SettingTexts own = setting_of(run.record);
    for (std::size_t p = 0; p < shared.size(); ++p)
      if (own[p] != shared[p]) shared[p].clear();
  }
  return shared;
}

/// Returns the texts that are not empty, separated by commas.
std::string join_texts(std::vector<std::string> texts) {
  std::erase(texts, "");
  return joined(texts, ", ");
}

/// Returns "NAME = RANGE", or an empty text if there are no numbers.
std::string named_range(const std::string& name, const std::vector<double>& numbers, int digits) {
  return numbers.empty() ? "" : name + " = " + range_text(numbers, digits);
}

}  // namespace

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
  return joined(names, ", ");
}

std::vector<std::string> setting_labels(const std::vector<RunFile>& runs) {
  std::vector<std::string> labels;
  for (const SettingTexts shared = shared_settings(runs); const RunFile& run : runs) {
    SettingTexts differing = setting_of(run.record);
    for (std::size_t p = 0; p < shared.size(); ++p)
      if (differing[p] == shared[p]) differing[p].clear();
    const std::string text = join_texts({differing.begin(), differing.end()});
    labels.push_back(run.record.model + (text.empty() ? "" : " " + text));
  }
  return labels;
}

Note run_note(const PlotInputs& inputs, std::optional<AbscissaKind> abscissa) {
  if (inputs.runs.empty()) return {};
  std::vector<double> periods, depths, reynolds, cells, relaxation_times;
  for (const auto& [source, record] : inputs.runs) {
    periods.push_back(record.driving.period);
    const DimensionlessNumbers& numbers = record.dimensionless;
    if (numbers.penetration_depth_over_radius > 0) depths.push_back(numbers.penetration_depth_over_radius);
    if (numbers.reynolds_bead > 0) reynolds.push_back(numbers.reynolds_bead);
    if (!record.resolution) continue;
    cells.push_back(record.resolution->cells_per_radius);
    relaxation_times.push_back(record.resolution->relaxation_time);
  }
  const auto [bead_boundary, resolution, relaxation_time, precision, box] = shared_settings(inputs.runs);
  const std::string reynolds_text = named_range("Re", reynolds, 2);
  std::string text =
      "Runs: " + join_texts({abscissa == AbscissaKind::period ? "" : named_range("T", periods, 6),
                             abscissa ? "" : named_range("δ/λ", depths, 3), reynolds_text});
  if (!cells.empty())
    text += "; " + join_texts({range_text(cells, 4) + " cells per radius",
                               named_range("τ", relaxation_times, 4), bead_boundary, precision});
  if (!box.empty()) text += "; " + box;
  return {
      .text = text,
      .summary = reynolds_text.empty() ? "" : fmt::format("{} runs: {}", inputs.runs.size(), reynolds_text)};
}

Note reading_note(const PlotInputs& inputs) {
  if (inputs.runs.empty()) return {.text = "Theories agree where their lines coincide."};
  if (inputs.predictions.empty()) return {.text = "Each mark is one swimmer of a run."};
  return {.text = "Marks are runs; marks on a line agree with that prediction."};
}

std::vector<Note> notes_against(const PlotInputs& inputs, AbscissaKind abscissa) {
  std::vector<Note> notes{reading_note(inputs)};
  if (!inputs.predictions.empty()) {
    std::vector<std::string> texts;
    for (const Parameter& parameter : parameters) {
      if (parameter.key != to_text(abscissa)) texts.push_back(parameter_text(inputs.predictions, parameter));
    }
    texts.push_back(fluid_text(inputs.predictions));
    if (const std::string text = join_texts(texts); !text.empty())
      notes.push_back({.text = "Predictions: " + text,
                       .summary = "Predictions: " + join_texts({texts.front(), texts.back()})});
    const auto usable = [](const PlottedPrediction& plotted) { return plotted.prediction().usable; };
    if (!std::ranges::all_of(inputs.predictions, usable))
      notes.push_back({.text = "Thin and pale: unusable predictions."});
  }
  notes.push_back(run_note(inputs, abscissa));
  return notes;
}

}  // namespace beadswim
