#include "result_series.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/scene/units.hpp"
#include "plot_labels.hpp"
#include "variable_label.hpp"

namespace beadswim {
namespace {

/// Returns the value of a quantity of a study. Throws InputError if the document has no such quantity.
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

/// Returns the smaller mean arm length in the chosen cycles, divided by the smallest bead radius of the scene
/// or, in an older record without it, of a lattice run.
double separation_of(const RunFile& run, const SwimmerRecord& swimmer, const CycleChoice& choice) {
  const auto cycles = select_cycles(swimmer.cycles, choice, run.source);
  std::array<double, 2> arms{};
  for (const CycleStatistics& cycle : cycles) {
    if (cycle.arm_means.size() != 2)
      throw InputError(run.source, "the swimmer does not have two arms; leave this file out");
    for (std::size_t arm = 0; arm < 2; ++arm) arms[arm] += cycle.arm_means[arm];
  }
  const auto& [scene, resolution] = std::tie(run.record.scene, run.record.resolution);
  if (!scene && !resolution)
    throw InputError(
        run.source,
        "the run record lacks the bead radius, which is needed for the separation ratio l/λ; leave "
        "this file out");
  return std::min(arms[0], arms[1]) / static_cast<double>(cycles.size()) /
         (scene ? smallest_radius(*scene) : resolution->cells_per_radius * resolution->cell_size);
}

/// Returns the value on the horizontal axis for a swimmer in a run. Throws InputError if the run record does
/// not contain the quantity. For B = 0, A/B is infinite and is not drawn.
double abscissa_of(const RunFile& run, const SwimmerRecord& swimmer, const Abscissa& abscissa,
                   const CycleChoice& cycle) {
  const auto& driving = run.record.driving;
  if (abscissa.kind == AbscissaKind::study)
    return number_in_study(run.study(), abscissa.study, run.source, "--x");
  if (abscissa.kind == AbscissaKind::period) return driving.period;
  if (abscissa.kind == AbscissaKind::separation_ratio) return separation_of(run, swimmer, cycle);
  const bool is_phase = abscissa.kind == AbscissaKind::phase;
  if (driving.amplitude && (!is_phase || driving.phase))
    return is_phase ? *driving.phase : (*driving.amplitude)[0] / (*driving.amplitude)[1];
  throw InputError(run.source,
                   "the run record lacks the {}, the abscissa of the figure; leave the run out, or draw the "
                   "figure with --against cycle",
                   axis_label(abscissa, run.record.units).quantity);
}

/// Returns the smallest number of digits, at least 4, with which the values of a quantity of the study have
/// different texts.
int study_digits(const PlotInputs& inputs, const std::string& name) {
  std::set<double> values;
  for (const Json& study : inputs.studies())
    if (study.contains(name) && study[name].is_number()) values.insert(study[name].get<double>());
  for (int digits = 4; digits < 17; ++digits) {
    std::set<std::string> texts;
    for (const double value : values) texts.insert(fmt::format("{:.{}g}", value, digits));
    if (texts.size() == values.size()) return digits;
  }
  return 17;
}

/// Returns what varies in the studies of all inputs, with the values in `study`: ", period = 2400, radius =
/// 4"; empty if nothing does.
std::string varied_text(const PlotInputs& inputs, const Json& study) {
  if (!study.is_object()) return {};
  std::map<std::string, std::set<Json>> values;
  for (const Json& other : inputs.studies())
    for (const auto& [name, value] : other.items()) values[name].insert(value);
  Json varied = Json::object();
  for (const auto& [name, value] : study.items())
    if (values[name].size() > 1) varied[name] = value;
  return varied.empty() ? "" : ", " + study_text(varied, 4);
}

/// Returns the label of a run: "lbm"; for several runs with what varies in their studies, or "lbm FILE".
std::string run_label(const PlotInputs& inputs, const RunFile& run) {
  if (inputs.runs.size() == 1) return run.record.model;
  const std::string varied = varied_text(inputs, run.study());
  if (!varied.empty()) return run.record.model + varied;
  return fmt::format("{} {}", run.record.model, std::filesystem::path(run.source).filename().string());
}

/// Returns the name of a swimmer's type. Throws InputError if the scene is unknown.
std::string type_of(const std::optional<Layout>& scene, int id, const std::string& source) {
  if (!scene)
    throw InputError(source,
                     "the document does not state the types of the swimmers, as it has no scene; "
                     "leave it out, or use another value of --group-by");
  return std::ranges::find(scene->swimmers, id, &Swimmer::id)->type;
}

/// Returns a point for each swimmer of a run in each cycle. Uncertainties belong to the last one.
ResultSeries series_by_cycle(const PlotInputs& inputs, const RunFile& run) {
  ResultSeries series{run_label(inputs, run)};
  for (const SwimmerRecord& swimmer : run.record.swimmers) {
    for (const CycleStatistics& cycle : swimmer.cycles) {
      CycleChoice choice;
      if (&cycle != &swimmer.cycles.back()) choice = {CycleChoice::Kind::index, cycle.index};
      series.points.push_back({static_cast<double>(cycle.index),
                               results_of(run.record, swimmer, choice, run.source), true, run.source});
    }
  }
  return series;
}

/// Returns the points of a series that have the number; with a fixed colour, NaN for the others.
std::vector<CurvePoint> points_of(const ResultSeries& series, const DrawnNumber& drawn,
                                  const Relation& relation) {
  std::vector<CurvePoint> points;
  for (const ResultPoint& point : series.points) {
    const auto found = point.results.find(drawn.quantity);
    if (found != point.results.end() && drawn.number < found->second.numbers.size()) {
      const ResultValue& value = found->second;
      points.push_back({point.x, value.numbers[drawn.number], point.usable, value.error(drawn.number)});
      if (relation) points.back() = relation(point, points.back());
    } else if (drawn.colour) {
      points.push_back({.x = point.x, .y = NAN, .usable = point.usable});
    }
  }
  return points;
}

std::vector<Curve> curves_of(const std::vector<ResultSeries>& all, const std::vector<DrawnNumber>& numbers,
                             const Relation& relation) {
  std::vector<Curve> curves;
  for (const ResultSeries& series : all)
    for (const DrawnNumber& drawn : numbers)
      if (std::vector<CurvePoint> points = points_of(series, drawn, relation); !points.empty())
        curves.push_back({drawn.before + series.label + drawn.after, std::move(points)});
  return curves;
}

}  // namespace

AxisLabel axis_label(const Abscissa& abscissa, const Units& units) {
  constexpr std::array labels{"period T", "separation of neighbouring beads over their radius, l/λ",
                              "ratio of the driving amplitudes, A/B", "phase of the driving, α"};
  const bool is_study = abscissa.kind == AbscissaKind::study;
  if (is_study) return variable_label(abscissa.study, units);
  return {labels[static_cast<std::size_t>(abscissa.kind)],
          variable_label(to_text(abscissa.kind), units).unit};
}

AxisLabel result_label(ResultQuantity quantity, const Units& units) {
  return {std::string(row_of(quantity).label), unit_of(quantity, units)};
}

double number_in_study(const Json& study, const std::string& name, const std::string& source,
                       const std::string& flag) {
  const Json value = study_value(study, name, source, flag);
  if (value.is_number()) return value.get<double>();
  throw InputError(flag, "\"{}\" is the word {} in {}, not a number; use it with --group-by", name,
                   value.dump(), source);
}

double abscissa_of(const PlottedPrediction& plotted, const Abscissa& abscissa) {
  if (abscissa.kind == AbscissaKind::study)
    return number_in_study(plotted.document.study, abscissa.study, plotted.source, "--x");
  const std::string key = to_text(abscissa.kind);
  if (const auto value = find_setting<double>(plotted.prediction(), key)) return *value;
  const std::string hint =
      abscissa.kind == AbscissaKind::amplitude_ratio ? " (it is left out where B = 0)" : "";
  throw InputError(plotted.source,
                   "the prediction by {} lacks the setting \"{}\", which is the abscissa of the figure{}; "
                   "leave the prediction out, or predict again with beadswim-theory",
                   plotted.prediction().method, key, hint);
}

DrawnResults results_against(const PlotInputs& inputs, const Abscissa& abscissa, const CycleChoice& cycle,
                             const std::string& group_by) {
  const int digits = study_digits(inputs, group_by);
  const std::string group_name = variable_label(group_by, inputs.units).quantity;
  const auto group_of = [&](const Json& study, const std::optional<Layout>& scene, int swimmer,
                            const std::string& source) -> std::string {
    if (group_by.empty()) return {};
    if (group_by == by_swimmer) return fmt::format("{}", swimmer);
    if (group_by == by_type) return type_of(scene, swimmer, source);
    return study_value_text(study_value(study, group_by, source, "--group-by"), digits);
  };
  const auto add = [&](std::string label, const std::string& group, ResultPoint point,
                       std::vector<ResultSeries>& all) {
    if (!group_by.empty()) label += fmt::format(", {} = {}", group_name, group);
    auto found = std::ranges::find(all, label, &ResultSeries::label);
    if (found == all.end()) found = all.insert(found, ResultSeries{label});
    found->points.push_back(std::move(point));
  };
  DrawnResults drawn;
  const std::vector<std::string> settings = setting_labels(inputs.runs);
  std::vector<std::size_t> order(settings.size());  // of runs; those of one setting follow one another
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(
      order, {}, [&](std::size_t r) { return std::ranges::find(settings, settings[r]) - settings.begin(); });
  for (const std::size_t r : order) {
    const RunFile& run = inputs.runs[r];
    const auto add_point = [&](const std::string& group, const SwimmerRecord& swimmer,
                               const Results& results) {
      add(settings[r], group,
          {abscissa_of(run, swimmer, abscissa, cycle), results, true, run.source, run.study()}, drawn.runs);
    };
    std::map<std::string, std::vector<Results>> of_types;
    for (const SwimmerRecord& swimmer : run.record.swimmers) {
      const Results results = results_of(run.record, swimmer, cycle, run.source);
      const std::string group = group_of(run.study(), run.record.scene, swimmer.id, run.source);
      if (group_by == by_type)
        of_types[group].push_back(results);
      else
        add_point(group, swimmer, results);
    }
    for (const auto& [type, results] : of_types)
      add_point(type, run.record.swimmers.front(), mean_of(results));
  }
  for (const std::string& method : inputs.methods) {
    std::vector<ResultSeries> of_method;
    for (const PlottedPrediction& plotted : inputs.predictions)
      if (const PredictionDocument& document = plotted.document; plotted.prediction().method == method)
        add(method, group_of(document.study, document.scene, document.swimmer, plotted.source),
            {abscissa_of(plotted, abscissa), plotted.results(), plotted.prediction().usable, plotted.source,
             document.study},
            of_method);
    for (ResultSeries& series : of_method) std::ranges::stable_sort(series.points, {}, &ResultPoint::x);
    std::ranges::move(of_method, std::back_inserter(drawn.predictions));
  }
  return drawn;
}

void average_over(const std::string& asked, const PlotInputs& inputs, DrawnResults& drawn) {
  const std::vector<Json> studies = inputs.studies();
  const auto has = [&](const std::string& name) {
    return std::ranges::any_of(studies, [&](const Json& study) { return study.contains(name); });
  };
  const std::string name = !has(asked) && has("/" + asked) ? "/" + asked : asked;
  if (!has(name))
    throw InputError("--mean-over",
                     "\"{}\" is not varied in any file; name what beadswim-layout vary has varied", asked);
  for (auto* all : {&drawn.runs, &drawn.predictions})
    for (ResultSeries& series : *all) {
      std::vector<std::vector<ResultPoint>> groups;
      for (ResultPoint& point : series.points) {
        if (point.study.is_object()) point.study.erase(name);
        const auto group = std::ranges::find_if(groups, [&](const auto& each) {
          return each.front().x == point.x && each.front().study == point.study;
        });
        (group == groups.end() ? groups.emplace_back() : *group).push_back(std::move(point));
      }
      series.points.clear();
      for (std::vector<ResultPoint>& group : groups) {
        ResultPoint& point = series.points.emplace_back(group.front());
        if (all == &drawn.predictions) continue;
        std::vector<Results> results;
        for (const ResultPoint& each : group) results.push_back(each.results);
        point.results = mean_with_errors(results);
      }
    }
}

DrawnResults results_by_cycle(const PlotInputs& inputs) {
  constexpr double overhang = 0.4;  // [cycles]
  DrawnResults drawn;
  std::vector<double> cycles;
  for (const RunFile& run : inputs.runs) {
    drawn.runs.push_back(series_by_cycle(inputs, run));
    for (const ResultPoint& point : drawn.runs.back().points) cycles.push_back(point.x);
  }
  for (const PlottedPrediction& plotted : inputs.predictions)
    drawn.predictions.push_back({plotted.prediction().method + varied_text(inputs, plotted.document.study),
                                 {{0, plotted.results(), plotted.prediction().usable, plotted.source}}});
  if (!cycles.empty())
    drawn.level = {std::ranges::min(cycles) - overhang, std::ranges::max(cycles) + overhang};
  return drawn;
}

std::size_t max_numbers(const DrawnResults& drawn, ResultQuantity quantity) {
  std::size_t numbers = 0;
  for (const auto* all : {&drawn.runs, &drawn.predictions})
    for (const ResultSeries& series : *all)
      for (const ResultPoint& point : series.points)
        numbers = std::max(numbers, count_numbers(point.results, quantity));
  return numbers;
}

void append(const DrawnResults& drawn, const std::vector<DrawnNumber>& numbers, Panel& panel,
            const Relation& relation) {
  const std::optional<int> colour = numbers.empty() ? std::nullopt : numbers.front().colour;
  const std::vector<Curve> marks = curves_of(drawn.runs, numbers, relation);
  const std::vector<Curve> curves = curves_of(drawn.predictions, numbers, relation);
  append_marks_and_curves(marks, drawn.level ? std::vector<Curve>() : curves, colour, panel);
  if (drawn.level) append_levels(curves, drawn.level->first, drawn.level->second, colour.value_or(0), panel);
}

}  // namespace beadswim
