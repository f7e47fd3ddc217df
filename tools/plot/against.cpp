#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"
#include "result_series.hpp"

// Figures of a study: a result against a quantity that beadswim-layout vary has varied, or a map of a result
// over two such quantities, with a rectangle per layout.

namespace beadswim {

enum class LogAxes { none, x, y, xy };

template <>
inline constexpr auto name_table<LogAxes> = std::to_array<NamedValue<LogAxes>>(
    {{LogAxes::none, "none"}, {LogAxes::x, "x"}, {LogAxes::y, "y"}, {LogAxes::xy, "xy"}});

namespace {

struct AgainstFlags {
  std::string x, x_label, group_by, mean_over;
  std::string y = "velocity";            ///< a result; for a map a quantity of the study
  std::optional<ResultQuantity> colour;  ///< result that a map shows
  LogAxes log = LogAxes::none;
  InputChoice choice;
};

/// Returns a panel without data, which has the scales of the flags.
Panel empty_panel(const AgainstFlags& flags, const Units& units, const AxisLabel& y_label) {
  const auto scale = [&](LogAxes axis) {
    return flags.log == axis || flags.log == LogAxes::xy ? ScaleKind::logarithmic : ScaleKind::linear;
  };
  return {.x_label = flags.x_label.empty() ? axis_label({.study = flags.x}, units) : AxisLabel{flags.x_label},
          .y_label = y_label,
          .x_scale = scale(LogAxes::x),
          .y_scale = scale(LogAxes::y)};
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

bool has_errors(const Series& series) {
  return std::ranges::any_of(series.errors, [](double error) { return error > 0; });
}

Figure against_figure(const PlotInputs& inputs, ResultQuantity quantity, const AgainstFlags& flags) {
  Panel panel = empty_panel(flags, inputs.units, result_label(quantity, inputs.units));
  DrawnResults drawn = results_against(inputs, {.study = flags.x}, flags.choice.cycle, flags.group_by);
  if (!flags.mean_over.empty()) average_over(flags.mean_over, inputs, drawn);
  std::vector<DrawnNumber> numbers;
  for (std::size_t i = 0; i < max_numbers(drawn, quantity); ++i) {
    const std::string symbol = arm_symbol(quantity, i);
    numbers.push_back({.quantity = quantity, .number = i, .after = symbol.empty() ? "" : ", " + symbol});
  }
  append(drawn, numbers, panel);
  std::vector<Note> notes{reading_note(inputs)};
  if (flags.group_by == by_type && !inputs.runs.empty())
    notes.front() = {.text = "Marks are means over the swimmers of a type in a run."};
  if (!flags.mean_over.empty())
    notes.front() = {.text = fmt::format("Marks are means over {}, with standard errors.", flags.mean_over)};
  else if (std::ranges::any_of(panel.series, has_errors))
    notes.push_back({.text = "Bars and bands: uncertainties that runs and predictions state."});
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where values are not positive."});
  const std::string title =
      capitalised(fmt::format("{} against {}", panel.y_label.quantity, panel.x_label.quantity));
  return {.title = title, .panels = {std::move(panel)}, .notes = notes};
}

using Point = std::pair<double, double>;

/// Values of a map at their points (x, y), one element per number of the result.
using MapValues = std::vector<std::map<Point, double>>;

/// Adds the values of a document. Throws InputError if there is a value at its point already.
void add_to_map(const Results& results, const Json& study, const AgainstFlags& flags,
                const std::string& source, MapValues& map) {
  const Point point{number_in_study(study, flags.x, source, "--x"),
                    number_in_study(study, flags.y, source, "--y")};
  const std::size_t count = count_numbers(results, *flags.colour);
  map.resize(std::max(map.size(), count));
  for (std::size_t i = 0; i < count; ++i) {
    if (map[i].emplace(point, *number_of(results, *flags.colour, i)).second) continue;
    throw InputError(source,
                     "a second value for {} = {:g}, {} = {:g}; a map shows one value per point: name one "
                     "method with --method, or files of one study and one model",
                     flags.x, point.first, flags.y, point.second);
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

/// Returns the rectangles of a panel whose scales are set. Throws InputError if a logarithmic axis would have
/// places that are not positive.
std::vector<MapCell> cells_of(const std::map<Point, double>& values, const Panel& panel) {
  if (values.empty()) return {};
  std::set<double> xs, ys;
  for (const auto& [point, value] : values) {
    xs.insert(point.first);
    ys.insert(point.second);
  }
  for (const auto& [places, scale] : {std::pair(&xs, panel.x_scale), std::pair(&ys, panel.y_scale)})
    if (scale == ScaleKind::logarithmic && *places->begin() <= 0)
      throw InputError("--log", "a logarithmic axis needs values above 0; leave the flag out");
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

Figure map_figure(const PlotInputs& inputs, const AgainstFlags& flags) {
  MapValues map;
  for (const auto& run : inputs.runs)
    add_to_map(results_of(run.record, run.record.swimmers.front(), flags.choice.cycle, run.source),
               run.study(), flags, run.source, map);
  for (const PlottedPrediction& plotted : inputs.predictions)
    add_to_map(plotted.results(), plotted.document.study, flags, plotted.source, map);
  if (map.empty()) map.emplace_back();  // a panel, whose drawing says that there is no value
  const auto [quantity, unit] = result_label(*flags.colour, inputs.units);
  const std::string by = inputs.runs.empty() ? inputs.methods.front() : inputs.runs.front().record.model;
  const AxisLabel y_label = axis_label({.study = flags.y}, inputs.units);
  const std::string x_name = empty_panel(flags, inputs.units, y_label).x_label.quantity;
  Figure figure{.title = capitalised(fmt::format("{} against {} and {}", quantity, x_name, y_label.quantity)),
                .panels = {},
                .notes = {{.text = fmt::format("Each rectangle is one layout of the study, by {}.", by)}}};
  for (std::size_t i = 0; i < map.size(); ++i) {
    Panel panel = empty_panel(flags, inputs.units, y_label);
    const std::string symbol = arm_symbol(*flags.colour, i);
    panel.value_label = {symbol.empty() ? quantity : symbol, unit};
    panel.cells = cells_of(map[i], panel);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

ResultQuantity result_named(const std::string& name) {
  if (const auto result = value_named<ResultQuantity>(name)) return *result;
  throw InputError("--y", "{}; a second quantity of the study needs --colour",
                   format_unknown_name(name, all_names<ResultQuantity>()));
}

Figure drawn_figure(const PlotFiles& files, const AgainstFlags& flags) {
  if (!flags.colour) {
    const ResultQuantity result = result_named(flags.y);
    return against_figure(read_plot_inputs(files.inputs, flags.choice), result, flags);
  }
  for (const auto& [flag, value] :
       {std::pair("--group-by", &flags.group_by), std::pair("--mean-over", &flags.mean_over)})
    if (!value->empty()) throw InputError(flag, "a map shows one value per point; leave the flag out");
  return map_figure(read_plot_inputs(files.inputs, flags.choice), flags);
}

}  // namespace

DrawFigure add_against_flags(CLI::App& command) {
  const auto flags = std::make_shared<AgainstFlags>();
  add_value(command, "--x", flags->x, {"NAME"},
            "Quantity of the study on the horizontal axis, as beadswim-layout vary names it")
      ->required();
  add_value(command, "--y", flags->y, {"NAME"},
            "Result, from the list below, on the vertical axis; with --colour a second quantity of the "
            "study, for a map");
  add_choice(command, "--colour", flags->colour, "Result, from the list below, that a map shows by colours")
      ->type_name("NAME");
  add_value(command, "--x-label", flags->x_label,
            {.name = "TEXT", .initial = "name and unit of the quantity"}, "Label of the horizontal axis");
  add_value(command, "--group-by", flags->group_by, {.name = "NAME|swimmer|type", .initial = "none"},
            "Quantity of the study for whose values separate curves and marks are drawn; or swimmer, for "
            "each id; or type, for means over its swimmers");
  add_value(command, "--mean-over", flags->mean_over, {.name = "NAME", .initial = "none"},
            "Quantity of the study, such as seed, over whose values means with standard errors are drawn");
  add_choice(command, "--log", flags->log, "Logarithmic axes");
  add_result_flags(command, flags->choice);
  command.footer("Results:\n" + wrapped(joined(all_names<ResultQuantity>(), ", "), 2) + "\n");
  return [flags](const PlotFiles& files) { return draw(drawn_figure(files, *flags)); };
}

}  // namespace beadswim
