#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "abscissa.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/figure/curves.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Figures of the arm amplitudes and of the sine of the phase shift, sin(δ₁ - δ₂), against the cycle or a
// driving parameter.

namespace beadswim {
namespace {

/// One number of a swimmer's stroke, with its symbol and colour in the figure.
struct StrokeNumber {
  ComparedQuantity quantity;
  std::size_t position;  ///< index among the numbers of `quantity`
  std::string symbol;
  int colour;

  /// Returns the number; NaN, which is not drawn, if the swimmer has too few bonds.
  double in(const ComparedValues& swimming) const {
    const auto numbers = swimming.find(quantity);
    if (numbers == swimming.end() || position >= numbers->second.size()) return NAN;
    return numbers->second[position];
  }
  /// Returns the absolute uncertainty of the number; 0 if `uncertainties`, which are relative, lack it.
  double error_in(const ComparedValues& swimming, const ComparedValues& uncertainties) const {
    const double relative = in(uncertainties);
    return std::isfinite(relative) ? relative * std::abs(in(swimming)) : 0;
  }
  std::string label(const std::string& source) const { return fmt::format("{}, {}", symbol, source); }
};

using StrokeNumbers = std::vector<StrokeNumber>;

const StrokeNumbers phase_shift{
    {.quantity = ComparedQuantity::sin_phase_shift, .position = 0, .symbol = "sin(δ₁ − δ₂)", .colour = 2}};

/// Returns the largest number of bonds of a swimmer. Throws InputError if no swimmer has a bond.
std::size_t max_bonds(const std::vector<ComparedValues>& strokes) {
  std::size_t bonds = 0;
  for (const ComparedValues& stroke : strokes)
    bonds = std::max(bonds, stroke.at(ComparedQuantity::arm_amplitudes).size());
  if (bonds > 0) return bonds;
  throw InputError("stroke",
                   "no swimmer has a bond, and so none has a stroke; draw its motion with beadswim-plot "
                   "trajectories");
}

/// Returns velocity and stroke of all predictions.
std::vector<ComparedValues> predicted_strokes(const PlotInputs& inputs) {
  std::vector<ComparedValues> strokes;
  for (const PlottedPrediction& plotted : inputs.predictions)
    strokes.push_back(swimming_of(plotted.prediction));
  return strokes;
}

/// Returns a whole number in subscript digits.
std::string subscript(int number) {
  constexpr std::array digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  for (const char digit : std::to_string(number)) text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

/// Returns the arm amplitudes of the bonds in `wanted` (numbers from 1), or, if it is empty, of all bonds.
StrokeNumbers amplitudes_of(std::vector<int> wanted, std::size_t bonds) {
  constexpr std::size_t max_drawn = 7;  // colours that readers can distinguish
  if (wanted.empty()) {
    wanted.resize(bonds);
    std::iota(wanted.begin(), wanted.end(), 1);
  }
  if (wanted.size() > max_drawn)
    throw InputError("--bonds", fmt::format("the figure would show {} bonds, but at most {} can be "
                                            "distinguished; name fewer bonds, for example --bonds 1,2",
                                            wanted.size(), max_drawn));
  StrokeNumbers amplitudes;
  for (const int bond : wanted) {
    if (bond > static_cast<int>(bonds))
      throw InputError("--bonds", fmt::format("no swimmer has a bond {}; the swimmers have the bonds 1 to {}",
                                              bond, bonds));
    amplitudes.push_back({.quantity = ComparedQuantity::arm_amplitudes,
                          .position = static_cast<std::size_t>(bond - 1),
                          .symbol = "d" + subscript(bond),
                          .colour = static_cast<int>(amplitudes.size())});
  }
  return amplitudes;
}

AxisLabel amplitude_label(const PlotInputs& inputs) {
  return {"arm amplitude", length_unit(inputs.units)};
}

const AxisLabel phase_shift_label{"sine of the phase shift"};

struct CycleRange {
  int first = 0, last = 0;
};

CycleRange cycles_of(const PlotInputs& inputs) {
  CycleRange range;
  for (const PlottedRun& run : inputs.runs) {
    for (const SwimmerRecord& swimmer : run.record.swimmers) {
      for (const CycleStatistics& cycle : swimmer.cycles) {
        range.first = range.first == 0 ? cycle.index : std::min(range.first, cycle.index);
        range.last = std::max(range.last, cycle.index);
      }
    }
  }
  if (range.first == 0) {
    throw InputError("stroke",
                     "no run with a complete cycle is given; add the record of such a run, or draw "
                     "predictions with --against amplitude-ratio or phase");
  }
  return range;
}

/// Returns one point for each swimmer of a run in each cycle.
PointGroup points_by_cycle(const PlotInputs& inputs, const PlottedRun& run, const StrokeNumber& number) {
  PointGroup points{number.label(run_label(inputs, run))};
  for (const SwimmerRecord& swimmer : run.record.swimmers) {
    for (const CycleStatistics& cycle : swimmer.cycles) {
      const ComparedValues swimming = evaluate_compared_values(cycle, run.record.domain.box);
      const bool is_last = &cycle == &swimmer.cycles.back();
      points.x.push_back(cycle.index);
      points.y.push_back(number.in(swimming));
      points.errors.push_back(is_last ? number.error_in(swimming, stated_errors_of(run.record, swimmer, {}))
                                      : 0);
    }
  }
  return points;
}

/// Returns the panel with the cycle on the horizontal axis. Predictions are horizontal lines that extend
/// beyond the first and the last cycle.
Panel panel_by_cycle(const PlotInputs& inputs, const StrokeNumbers& numbers, const AxisLabel& y_label,
                     const CycleRange& cycles) {
  constexpr double overhang = 0.4;  // [cycles]
  Panel panel{.x_label = {"cycle"}, .y_label = y_label, .x_ticks = TickKind::integers};
  for (const StrokeNumber& number : numbers) {
    std::vector<PointGroup> runs;
    for (const PlottedRun& run : inputs.runs) runs.push_back(points_by_cycle(inputs, run, number));
    append_points_and_curves(runs, {}, number.colour, panel);
    std::vector<Level> levels;
    for (const PlottedPrediction& plotted : inputs.predictions) {
      const ComparedValues swimming = swimming_of(plotted.prediction);
      levels.push_back({number.label(plotted.prediction.method + varied_text(inputs, plotted.study)),
                        number.in(swimming),
                        number.error_in(swimming, uncertainties_of(plotted.prediction))});
    }
    append_levels(levels, cycles.first - overhang, cycles.last + overhang, number.colour, panel);
  }
  return panel;
}

/// Quantity on the horizontal axis of the panels, and the cycle of each run whose stroke is drawn.
struct Sweep {
  Abscissa abscissa;
  CycleChoice cycle;
};

PointGroup points_in_sweep(const RunGroup& group, const StrokeNumber& number, const Sweep& sweep) {
  PointGroup points{number.label(group.label)};
  for (const PlottedRun* run : group.runs) {
    for (const SwimmerRecord& swimmer : run->record.swimmers) {
      points.x.push_back(abscissa_of(*run, swimmer, sweep.abscissa, sweep.cycle));
      const ComparedValues swimming = swimming_of(run->record, swimmer, sweep.cycle, run->source);
      points.y.push_back(number.in(swimming));
      points.errors.push_back(number.error_in(swimming, stated_errors_of(run->record, swimmer, sweep.cycle)));
    }
  }
  return points;
}

Panel panel_in_sweep(const PlotInputs& inputs, const std::vector<RunGroup>& groups,
                     const StrokeNumbers& numbers, const AxisLabel& y_label, const Sweep& sweep) {
  Panel panel{.x_label = axis_label(sweep.abscissa, inputs.units), .y_label = y_label};
  const auto methods = predictions_by_method(inputs, sweep.abscissa);
  for (const StrokeNumber& number : numbers) {
    std::vector<PointGroup> points;
    for (const RunGroup& group : groups) points.push_back(points_in_sweep(group, number, sweep));
    std::vector<Curve> curves;
    for (const auto& [method, predictions] : methods) {
      curves.push_back({number.label(method)});
      for (const auto& [x, plotted] : predictions) {
        const Prediction& prediction = plotted.prediction;
        const ComparedValues swimming = swimming_of(prediction);
        curves.back().points.push_back({.x = x,
                                        .y = number.in(swimming),
                                        .usable = prediction.usable,
                                        .error = number.error_in(swimming, uncertainties_of(prediction))});
      }
    }
    append_points_and_curves(points, curves, number.colour, panel);
  }
  return panel;
}

Note cycles_note(const PlotInputs& inputs) {
  if (inputs.predictions.empty())
    return {.text = "Marks are cycles of runs. The stroke is periodic where marks have equal height."};
  return {.text =
              "Marks are cycles of runs, horizontal lines are predictions. Marks that approach a line agree "
              "with its prediction."};
}

/// Removes the legend entries of swimmers that lack the bonds of the panel.
void hide_empty_series(Panel& panel) {
  const auto is_finite = [](double number) { return std::isfinite(number); };
  for (Series& series : panel.series)
    if (std::ranges::none_of(series.y, is_finite)) series.label.clear();
}

/// Returns the panels of the figure: arm amplitudes, and the phase shift if a swimmer has two bonds.
///   shown    numbers from 1 of the bonds to draw; empty: all
///   strokes  all strokes of the figure
///   draw     draw(numbers, y_label) returns the panel of these numbers
std::vector<Panel> stroke_panels(const PlotInputs& inputs, const std::vector<int>& shown,
                                 const std::vector<ComparedValues>& strokes, auto&& draw) {
  const std::size_t bonds = max_bonds(strokes);
  std::vector<Panel> panels{draw(amplitudes_of(shown, bonds), amplitude_label(inputs))};
  if (bonds > 1) panels.push_back(draw(phase_shift, phase_shift_label));
  std::ranges::for_each(panels, hide_empty_series);
  return panels;
}

Figure stroke_by_cycle(const PlotInputs& inputs, const std::vector<int>& shown) {
  const CycleRange range = cycles_of(inputs);
  std::vector<ComparedValues> strokes = predicted_strokes(inputs);
  for (const PlottedRun& run : inputs.runs)
    for (const SwimmerRecord& swimmer : run.record.swimmers)
      for (const CycleStatistics& cycle : swimmer.cycles)
        strokes.push_back(evaluate_compared_values(cycle, run.record.domain.box));
  const auto panel = [&](const StrokeNumbers& numbers, const AxisLabel& y_label) {
    return panel_by_cycle(inputs, numbers, y_label, range);
  };
  return {.title = "Stroke by cycle",
          .panels = stroke_panels(inputs, shown, strokes, panel),
          .notes = {cycles_note(inputs), run_note(inputs, std::nullopt)}};
}

Figure stroke_against(const PlotInputs& inputs, const std::vector<int>& shown, const Sweep& sweep) {
  const Abscissa abscissa = sweep.abscissa;
  std::vector<ComparedValues> strokes = predicted_strokes(inputs);
  for (const PlottedRun& run : inputs.runs)
    for (const SwimmerRecord& swimmer : run.record.swimmers)
      strokes.push_back(swimming_of(run.record, swimmer, sweep.cycle, run.source));
  const std::vector<RunGroup> groups = runs_by_setting(inputs);
  std::vector<Note> notes{reading_note(inputs)};
  std::ranges::move(prediction_notes(inputs, abscissa), std::back_inserter(notes));
  notes.push_back(run_note(inputs, abscissa));
  const auto panel = [&](const StrokeNumbers& numbers, const AxisLabel& y_label) {
    return panel_in_sweep(inputs, groups, numbers, y_label, sweep);
  };
  return {.title = "Stroke against " + axis_label(abscissa, inputs.units).quantity,
          .panels = stroke_panels(inputs, shown, strokes, panel),
          .notes = notes};
}

}  // namespace

Drawing add_stroke_flags(CLI::App& command) {
  struct Flags {
    std::vector<std::string> methods;
    std::string cycle = "last";
    std::optional<Abscissa> against;
    std::vector<int> bonds;  ///< numbers from 1; empty: all bonds
  };
  const auto flags = std::make_shared<Flags>();
  add_methods(command, flags->methods);
  add_cycle(command, flags->cycle);
  add_word(command, "--against", {"cycle", "amplitude-ratio", "phase"}, "cycle",
           "Quantity on the horizontal axis: the cycle (predictions are then horizontal lines), the ratio "
           "A/B of the driving amplitudes, or the driving phase alpha",
           [flags](const std::string& word) {
             flags->against.reset();
             if (word != "cycle")
               flags->against = word == "phase" ? Abscissa::phase : Abscissa::amplitude_ratio;
           });
  command
      .add_option_function<std::string>(
          "--bonds", [flags](const std::string& text) { flags->bonds = parse_whole_numbers(text); },
          "Numbers of the bonds whose arm amplitudes are drawn, from 1")
      ->type_name("N,...")
      ->check(number_list({}, whole_positive()))
      ->default_str("all");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    const PlotInputs inputs =
        read_plot_inputs(files.inputs, {flags->methods}, flags->against ? cycle : CycleChoice{});
    return Drawn(flags->against ? stroke_against(inputs, flags->bonds, {*flags->against, cycle})
                                : stroke_by_cycle(inputs, flags->bonds));
  };
}

}  // namespace beadswim
