#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/documents/study_result.hpp"
#include "beadswim/documents/study_text.hpp"
#include "beadswim/figure/curves.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Figures of a study: a result against a quantity that beadswim-layout vary has varied. Runs are drawn as
// marks with the uncertainty that they state, predictions as curves with theirs.

namespace beadswim {

enum class LogAxes { none, x, y, xy };

template <>
inline constexpr auto name_table<LogAxes> = std::to_array<NamedValue<LogAxes>>(
    {{LogAxes::none, "none"}, {LogAxes::x, "x"}, {LogAxes::y, "y"}, {LogAxes::xy, "xy"}});

namespace {

struct AgainstFlags {
  std::string x, group_by, cycle = "last";
  std::string y_name = "velocity";        ///< a result; for a map a quantity of the study
  StudyResult y = StudyResult::velocity;  ///< result on the vertical axis
  std::optional<StudyResult> colour;      ///< result that a map shows
  LogAxes log = LogAxes::none;
  MethodChoice methods;
};

AxisLabel label_of(StudyResult result, const Units& units) {
  const auto unit = [&](const std::string& named, const std::string& lattice) {
    return units.lattice ? lattice : named;
  };
  switch (result) {
    case StudyResult::velocity:
      return {"velocity", velocity_unit(units)};
    case StudyResult::efficiency:
      return {"Lighthill efficiency"};
    case StudyResult::power: {
      const std::string &mass = units.mass.name, &length = units.length.name, &time = units.time.name;
      return {"mean power of the drives", unit(fmt::format("{} {}²/{}³", mass, length, time), "")};
    }
    case StudyResult::arm_amplitudes:
      return {"arm amplitude", length_unit(units)};
    case StudyResult::angular_velocity:
      return {"angular velocity", unit("rad/" + units.time.name, "")};
  }
  return {};
}

/// Returns the value of a quantity of the study. Throws InputError if the document has no such quantity.
Json study_value(const Json& study, const std::string& name, const std::string& source,
                 const std::string& flag) {
  if (study.is_object() && study.contains(name)) return study[name];
  std::vector<std::string> names;
  for (const auto& [each, value] : study.items()) names.push_back(each);
  throw InputError(
      flag,
      names.empty()
          ? fmt::format("{} belongs to no study; make its layout with beadswim-layout vary", source)
          : fmt::format("\"{}\" is not varied in {}: {}", name, source, format_unknown_name(name, names)));
}

double number_in_study(const Json& study, const std::string& name, const std::string& source,
                       const std::string& flag) {
  const Json value = study_value(study, name, source, flag);
  if (value.is_number()) return value.get<double>();
  throw InputError(flag, fmt::format("\"{}\" is the word {} in {}, not a number; use it with --group-by",
                                     name, value.dump(), source));
}

double abscissa(const Json& study, const AgainstFlags& flags, const std::string& source) {
  return number_in_study(study, flags.x, source, "--x");
}

/// Returns the smallest number of digits, at least 4, with which the values of --group-by have different
/// texts.
int group_digits(const PlotInputs& inputs, const std::string& name) {
  std::set<double> values;
  const auto add = [&](const Json& study) {
    if (study.is_object() && study.contains(name) && study[name].is_number())
      values.insert(study[name].get<double>());
  };
  for (const PlottedRun& run : inputs.runs) add(run.record.study.value_or(Json()));
  for (const PlottedPrediction& plotted : inputs.predictions) add(plotted.study);
  for (int digits = 4; digits < 17; ++digits) {
    std::set<std::string> texts;
    for (const double value : values) texts.insert(fmt::format("{:.{}g}", value, digits));
    if (texts.size() == values.size()) return digits;
  }
  return 17;
}

/// Returns ", NAME = VALUE" for the groups of --group-by, with `digits` digits of numbers.
std::string group_label(const Json& study, const AgainstFlags& flags, int digits, const std::string& source) {
  if (flags.group_by.empty()) return "";
  const Json value = study_value(study, flags.group_by, source, "--group-by");
  return fmt::format(", {} = {}", flags.group_by, study_value_text(value, digits));
}

std::string part_label(const std::string& part) {
  return part.empty() ? "" : ", " + part;
}

/// Adds to `named` a list under `label`, in the order of first use, and returns the list.
template <class List>
List& list_named(std::vector<List>& named, const std::string& label) {
  const auto found = std::ranges::find(named, label, &List::label);
  return found == named.end() ? named.emplace_back(List{label}) : *found;
}

std::vector<PointGroup> run_points(const PlotInputs& inputs, const AgainstFlags& flags) {
  std::vector<PointGroup> groups;
  const int digits = group_digits(inputs, flags.group_by);
  const CycleChoice cycle = parse_cycle_choice(flags.cycle);
  for (const RunGroup& setting : runs_by_setting(inputs)) {
    for (const PlottedRun* run : setting.runs) {
      const Json study = run->record.study.value_or(Json());
      for (const SwimmerRecord& swimmer : run->record.swimmers) {
        for (const ResultValue& value : results_of(run->record, swimmer, flags.y, cycle, run->source)) {
          PointGroup& group =
              list_named(groups, setting.label + group_label(study, flags, digits, run->source) +
                                     part_label(value.part));
          group.x.push_back(abscissa(study, flags, run->source));
          group.y.push_back(value.value);
          group.errors.push_back(value.error);
        }
      }
    }
  }
  return groups;
}

std::vector<Curve> prediction_curves(const PlotInputs& inputs, const AgainstFlags& flags) {
  std::vector<Curve> curves;
  const int digits = group_digits(inputs, flags.group_by);
  for (const std::string& method : inputs.methods) {
    for (const PlottedPrediction& plotted : inputs.predictions) {
      if (plotted.prediction.method != method) continue;
      for (const ResultValue& value : results_of(plotted.prediction, flags.y)) {
        Curve& curve = list_named(curves, method + group_label(plotted.study, flags, digits, plotted.source) +
                                              part_label(value.part));
        curve.points.push_back({.x = abscissa(plotted.study, flags, plotted.source),
                                .y = value.value,
                                .usable = plotted.prediction.usable,
                                .error = value.error});
      }
    }
  }
  for (Curve& curve : curves) std::ranges::stable_sort(curve.points, {}, &CurvePoint::x);
  return curves;
}

AxisLabel study_label(const std::string& name, const Units& units) {
  if (name == "period") return {"period", time_unit(units)};
  if (name == "radius" || name == "arm") return {name, length_unit(units)};
  if (name == "phase") return {"phase", "rad"};
  return {name};
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

ScaleKind x_scale(LogAxes log) {
  return log == LogAxes::x || log == LogAxes::xy ? ScaleKind::logarithmic : ScaleKind::linear;
}

ScaleKind y_scale(LogAxes log) {
  return log == LogAxes::y || log == LogAxes::xy ? ScaleKind::logarithmic : ScaleKind::linear;
}

/// Values of a map, by the part of the result ("" or the arm) and the point (x, y).
using MapValues = std::map<std::string, std::map<std::pair<double, double>, double>>;

/// Adds the values of a document. Throws InputError if there is a value at its point already.
void add_to_map(const std::vector<ResultValue>& values, const Json& study, const AgainstFlags& flags,
                const std::string& source, MapValues& map) {
  const std::pair point{number_in_study(study, flags.x, source, "--x"),
                        number_in_study(study, flags.y_name, source, "--y")};
  for (const ResultValue& value : values) {
    if (map[value.part].emplace(point, value.value).second) continue;
    throw InputError(source,
                     fmt::format("a second value for {} = {:g}, {} = {:g}; a map shows one value per point: "
                                 "name one method with --method, or files of one study and one model",
                                 flags.x, point.first, flags.y_name, point.second));
  }
}

/// Returns the edges between sorted places and beyond the first and the last, in the middle between
/// neighbours on an axis of this scale.
std::vector<double> edges_of(const std::set<double>& places, ScaleKind scale) {
  const bool is_log = scale == ScaleKind::logarithmic;
  std::vector<double> at, edges;
  for (const double place : places) at.push_back(is_log ? std::log(place) : place);
  const auto spacing = [&](std::size_t i) { return at.size() > 1 ? at[i + 1] - at[i] : 1; };
  edges.push_back(at.front() - spacing(0) / 2);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) edges.push_back((at[i] + at[i + 1]) / 2);
  edges.push_back(at.back() + spacing(at.size() > 1 ? at.size() - 2 : 0) / 2);
  if (is_log)
    for (double& edge : edges) edge = std::exp(edge);
  return edges;
}

std::vector<MapCell> cells_of(const std::map<std::pair<double, double>, double>& values, const Panel& panel) {
  std::set<double> xs, ys;
  for (const auto& [point, value] : values) {
    xs.insert(point.first);
    ys.insert(point.second);
  }
  const std::vector<double> x_edges = edges_of(xs, panel.x_scale), y_edges = edges_of(ys, panel.y_scale);
  std::vector<MapCell> cells;
  for (const auto& [point, value] : values) {
    if (!std::isfinite(value)) continue;
    const auto i = static_cast<std::size_t>(std::distance(xs.begin(), xs.find(point.first)));
    const auto j = static_cast<std::size_t>(std::distance(ys.begin(), ys.find(point.second)));
    cells.push_back({.x = point.first,
                     .y = point.second,
                     .value = value,
                     .x_low = x_edges[i],
                     .x_high = x_edges[i + 1],
                     .y_low = y_edges[j],
                     .y_high = y_edges[j + 1]});
  }
  return cells;
}

/// Throws InputError if a logarithmic axis would have places that are not positive.
void require_positive(const MapValues& map, const AgainstFlags& flags) {
  const bool log_x = x_scale(flags.log) == ScaleKind::logarithmic;
  const bool log_y = y_scale(flags.log) == ScaleKind::logarithmic;
  for (const auto& [part, values] : map)
    for (const auto& [point, value] : values)
      if ((log_x && point.first <= 0) || (log_y && point.second <= 0))
        throw InputError("--log", "a logarithmic axis needs values above 0; leave the flag out");
}

Figure map_figure(const PlotInputs& inputs, const AgainstFlags& flags) {
  MapValues map;
  const CycleChoice cycle = parse_cycle_choice(flags.cycle);
  for (const PlottedRun& run : inputs.runs)
    add_to_map(results_of(run.record, run.record.swimmers.front(), *flags.colour, cycle, run.source),
               run.record.study.value_or(Json()), flags, run.source, map);
  for (const PlottedPrediction& plotted : inputs.predictions)
    add_to_map(results_of(plotted.prediction, *flags.colour), plotted.study, flags, plotted.source, map);
  require_positive(map, flags);
  const AxisLabel result = label_of(*flags.colour, inputs.units);
  Figure figure{
      .title = capitalised(fmt::format("{} against {} and {}", result.quantity, flags.x, flags.y_name)),
      .panels = {},
      .notes = {}};
  for (const auto& [part, values] : map) {
    Panel panel{.x_label = study_label(flags.x, inputs.units),
                .y_label = study_label(flags.y_name, inputs.units)};
    panel.x_scale = x_scale(flags.log);
    panel.y_scale = y_scale(flags.log);
    panel.value_label = {part.empty() ? result.quantity : part, result.unit};
    panel.cells = cells_of(values, panel);
    figure.panels.push_back(std::move(panel));
  }
  const std::string by = inputs.runs.empty() ? inputs.methods.front() : inputs.runs.front().record.model;
  figure.notes.push_back({.text = fmt::format("Each rectangle is one layout of the study, by {}.", by)});
  return figure;
}

Figure against_figure(const PlotInputs& inputs, const AgainstFlags& flags) {
  Panel panel{.x_label = study_label(flags.x, inputs.units), .y_label = label_of(flags.y, inputs.units)};
  append_points_and_curves(run_points(inputs, flags), prediction_curves(inputs, flags), std::nullopt, panel);
  panel.x_scale = x_scale(flags.log);
  panel.y_scale = y_scale(flags.log);
  std::vector<Note> notes{reading_note(inputs)};
  const auto has_errors = [](const Series& series) {
    return std::ranges::any_of(series.errors, [](double error) { return error > 0; });
  };
  if (std::ranges::any_of(panel.series, has_errors))
    notes.push_back({.text = "Bars and bands: uncertainties that runs and predictions state."});
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where values are not positive."});
  const std::string title = capitalised(fmt::format("{} against {}", panel.y_label.quantity, flags.x));
  return {.title = title, .panels = {std::move(panel)}, .notes = notes};
}

}  // namespace

Drawing add_against_flags(CLI::App& command) {
  const auto flags = std::make_shared<AgainstFlags>();
  command
      .add_option("--x", flags->x,
                  "Quantity of the study on the horizontal axis, as beadswim-layout vary names it")
      ->type_name("NAME")
      ->required();
  command
      .add_option("--y", flags->y_name,
                  "Result on the vertical axis; with --colour a second quantity of the study, for a map")
      ->type_name("velocity|efficiency|power|arm_amplitudes|angular_velocity|NAME")
      ->capture_default_str();
  add_choice(command, "--colour", flags->colour, "Result that a map shows by colours");
  command
      .add_option("--group-by", flags->group_by,
                  "Quantity of the study for whose values separate curves and marks are drawn")
      ->type_name("NAME")
      ->default_str("none");
  add_choice(command, "--log", flags->log, "Logarithmic axes");
  add_methods(command, flags->methods.methods);
  add_cycle(command, flags->cycle);
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    if (flags->colour) {
      if (!flags->group_by.empty())
        throw InputError("--group-by", "a map shows one value per point; leave the flag out");
      return map_figure(read_plot_inputs(files.inputs, flags->methods, cycle), *flags);
    }
    const auto result = value_named<StudyResult>(flags->y_name);
    if (!result)
      throw InputError("--y", fmt::format("{}; a second quantity of the study needs --colour",
                                          format_unknown_name(flags->y_name, all_names<StudyResult>())));
    flags->y = *result;
    return against_figure(read_plot_inputs(files.inputs, flags->methods, cycle), *flags);
  };
}

}  // namespace beadswim
