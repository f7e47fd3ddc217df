#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/documents/study_result.hpp"
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
  StudyResult y = StudyResult::velocity;
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

double abscissa(const Json& study, const AgainstFlags& flags, const std::string& source) {
  const Json value = study_value(study, flags.x, source, "--x");
  if (value.is_number()) return value.get<double>();
  throw InputError("--x", fmt::format("\"{}\" is the word {} in {}, not a number; use it with --group-by",
                                      flags.x, value.dump(), source));
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
  return fmt::format(
      ", {} = {}", flags.group_by,
      value.is_string() ? value.get<std::string>() : fmt::format("{:.{}g}", value.get<double>(), digits));
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

AxisLabel study_label(const AgainstFlags& flags, const Units& units) {
  if (flags.x == "period") return {"period", time_unit(units)};
  if (flags.x == "radius" || flags.x == "arm") return {flags.x, length_unit(units)};
  if (flags.x == "phase") return {"phase", "rad"};
  return {flags.x};
}

Figure against_figure(const PlotInputs& inputs, const AgainstFlags& flags) {
  Panel panel{.x_label = study_label(flags, inputs.units), .y_label = label_of(flags.y, inputs.units)};
  append_points_and_curves(run_points(inputs, flags), prediction_curves(inputs, flags), std::nullopt, panel);
  if (flags.log == LogAxes::x || flags.log == LogAxes::xy) panel.x_scale = ScaleKind::logarithmic;
  if (flags.log == LogAxes::y || flags.log == LogAxes::xy) panel.y_scale = ScaleKind::logarithmic;
  std::vector<Note> notes{reading_note(inputs),
                          {.text = "Bars and bands: uncertainties that runs and predictions state."}};
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where values are not positive."});
  std::string title = fmt::format("{} against {}", panel.y_label.quantity, flags.x);
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
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
  add_choice(command, "--y", flags->y, "Result on the vertical axis");
  command
      .add_option("--group-by", flags->group_by,
                  "Quantity of the study for whose values separate curves and marks are drawn")
      ->type_name("NAME")
      ->default_str("none");
  add_choice(command, "--log", flags->log, "Logarithmic axes");
  add_methods(command, flags->methods.methods);
  add_cycle(command, flags->cycle);
  return [flags](const PlotFiles& files) {
    parse_cycle_choice(flags->cycle);
    return against_figure(read_plot_inputs(files.inputs, flags->methods), *flags);
  };
}

}  // namespace beadswim
