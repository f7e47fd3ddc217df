#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"
#include "result_series.hpp"
#include "study_map.hpp"

// Figures of a study: a result against a quantity that beadswim-layout vary has varied.

namespace beadswim {

enum class LogAxes { none, x, y, xy };

template <>
inline constexpr auto name_table<LogAxes> = std::to_array<NamedValue<LogAxes>>(
    {{LogAxes::none, "none"}, {LogAxes::x, "x"}, {LogAxes::y, "y"}, {LogAxes::xy, "xy"}});

namespace {

struct AgainstFlags {
  std::string x, group_by;
  std::string y = "velocity";            ///< a result; for a map a quantity of the study
  std::optional<ResultQuantity> colour;  ///< result that a map shows
  LogAxes log = LogAxes::none;
  ResultFlags results;

  ScaleKind x_scale() const { return scale(log == LogAxes::x || log == LogAxes::xy); }
  ScaleKind y_scale() const { return scale(log == LogAxes::y || log == LogAxes::xy); }

 private:
  static ScaleKind scale(bool is_log) { return is_log ? ScaleKind::logarithmic : ScaleKind::linear; }
};

/// Returns all numbers of a quantity that the figure draws.
std::vector<DrawnNumber> numbers_of(ResultQuantity quantity, const DrawnResults& drawn) {
  std::vector<DrawnNumber> numbers;
  for (std::size_t i = 0; i < max_numbers(drawn, quantity); ++i) {
    const std::string symbol = arm_symbol(quantity, i);
    numbers.push_back({.quantity = quantity, .number = i, .after = symbol.empty() ? "" : ", " + symbol});
  }
  return numbers;
}

bool has_errors(const Series& series) {
  return std::ranges::any_of(series.errors, [](double error) { return error > 0; });
}

Figure against_figure(const PlotInputs& inputs, ResultQuantity quantity, const AgainstFlags& flags) {
  const Abscissa abscissa{.study = flags.x};
  Panel panel{.x_label = axis_label(abscissa, inputs.units),
              .y_label = result_label(quantity, inputs.units),
              .x_scale = flags.x_scale(),
              .y_scale = flags.y_scale()};
  const DrawnResults drawn = results_against(
      inputs, {.abscissa = abscissa, .cycle = flags.results.cycle_choice(), .group_by = flags.group_by});
  append(drawn, numbers_of(quantity, drawn), panel);
  std::vector<Note> notes{reading_note(inputs)};
  if (std::ranges::any_of(panel.series, has_errors))
    notes.push_back({.text = "Bars and bands: uncertainties that runs and predictions state."});
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where values are not positive."});
  const std::string title = capitalised(fmt::format("{} against {}", panel.y_label.quantity, flags.x));
  return {.title = title, .panels = {std::move(panel)}, .notes = notes};
}

ResultQuantity result_named(const std::string& name) {
  if (const auto result = value_named<ResultQuantity>(name)) return *result;
  throw InputError("--y", fmt::format("{}; a second quantity of the study needs --colour",
                                      format_unknown_name(name, all_names<ResultQuantity>())));
}

Figure drawn_figure(const PlotFiles& files, const AgainstFlags& flags) {
  const CycleChoice cycle = flags.results.cycle_choice();
  if (!flags.colour) {
    const ResultQuantity result = result_named(flags.y);
    return against_figure(read_plot_inputs(files.inputs, flags.results.methods, cycle), result, flags);
  }
  if (!flags.group_by.empty())
    throw InputError("--group-by", "a map shows one value per point; leave the flag out");
  return map_figure(read_plot_inputs(files.inputs, flags.results.methods, cycle), {.x = flags.x,
                                                                                   .y = flags.y,
                                                                                   .x_scale = flags.x_scale(),
                                                                                   .y_scale = flags.y_scale(),
                                                                                   .colour = *flags.colour,
                                                                                   .cycle = cycle});
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
      .add_option("--y", flags->y,
                  "Result, from the list below, on the vertical axis; with --colour a second quantity of the "
                  "study, for a map")
      ->type_name("NAME")
      ->capture_default_str();
  add_choice(command, "--colour", flags->colour, "Result, from the list below, that a map shows by colours")
      ->type_name("NAME");
  command
      .add_option("--group-by", flags->group_by,
                  "Quantity of the study for whose values separate curves and marks are drawn")
      ->type_name("NAME")
      ->default_str("none");
  add_choice(command, "--log", flags->log, "Logarithmic axes");
  add_result_flags(command, flags->results);
  command.footer("Results:\n" + wrapped(fmt::format("{}", fmt::join(all_names<ResultQuantity>(), ", ")), 2) +
                 "\n");
  return [flags](const PlotFiles& files) { return Drawn(drawn_figure(files, *flags)); };
}

}  // namespace beadswim
