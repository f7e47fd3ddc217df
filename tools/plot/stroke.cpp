#include <fmt/core.h>

#include <algorithm>
#include <memory>

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

  double in(const ComparedValues& swimming) const {
    const auto numbers = swimming.find(quantity);
    if (numbers != swimming.end() && position < numbers->second.size()) return numbers->second[position];
    throw InputError("stroke",
                     "a swimmer has fewer than two bonds, but this figure shows the strokes of two arms; "
                     "leave its file out");
  }
  std::string label(const std::string& source) const { return fmt::format("{}, {}", symbol, source); }
};

using StrokeNumbers = std::vector<StrokeNumber>;

const StrokeNumbers amplitudes{
    {.quantity = ComparedQuantity::arm_amplitudes, .position = 0, .symbol = "d₁", .colour = 0},
    {.quantity = ComparedQuantity::arm_amplitudes, .position = 1, .symbol = "d₂", .colour = 1}};
const StrokeNumbers phase_shift{
    {.quantity = ComparedQuantity::sin_phase_shift, .position = 0, .symbol = "sin(δ₁ − δ₂)", .colour = 2}};

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
      points.x.push_back(cycle.index);
      points.y.push_back(number.in(evaluate_compared_values(cycle, run.record.domain)));
    }
  }
  return points;
}

/// Returns the panel with the cycle on the horizontal axis. Predictions are horizontal lines that extend
/// beyond the first and the last cycle.
Panel panel_by_cycle(const PlotInputs& inputs, const StrokeNumbers& numbers, const AxisLabel& y_label) {
  constexpr double overhang = 0.4;  // [cycles]
  const CycleRange cycles = cycles_of(inputs);
  Panel panel{.x_label = {"cycle"}, .y_label = y_label, .x_ticks = TickKind::integers};
  for (const StrokeNumber& number : numbers) {
    std::vector<PointGroup> runs;
    for (const PlottedRun& run : inputs.runs) runs.push_back(points_by_cycle(inputs, run, number));
    append_points_and_curves(runs, {}, number.colour, panel);
    std::vector<Level> levels;
    for (const auto& [source, prediction] : inputs.predictions)
      levels.push_back({number.label(prediction.method), number.in(swimming_of(prediction))});
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
      points.y.push_back(number.in(swimming_of(run->record, swimmer, sweep.cycle, run->source)));
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
        curves.back().points.push_back(
            {.x = x, .y = number.in(swimming_of(prediction)), .usable = prediction.usable});
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

Figure stroke_by_cycle(const PlotInputs& inputs) {
  return {.title = "Stroke by cycle",
          .panels = {panel_by_cycle(inputs, amplitudes, amplitude_label(inputs)),
                     panel_by_cycle(inputs, phase_shift, phase_shift_label)},
          .notes = {cycles_note(inputs), run_note(inputs, std::nullopt)}};
}

Figure stroke_against(const PlotInputs& inputs, Abscissa abscissa, const CycleChoice& cycle) {
  const Sweep sweep{abscissa, cycle};
  const std::vector<RunGroup> groups = runs_by_setting(inputs);
  std::vector<Note> notes{reading_note(inputs)};
  std::ranges::move(prediction_notes(inputs, abscissa), std::back_inserter(notes));
  notes.push_back(run_note(inputs, abscissa));
  return {.title = "Stroke against " + axis_label(abscissa, inputs.units).quantity,
          .panels = {panel_in_sweep(inputs, groups, amplitudes, amplitude_label(inputs), sweep),
                     panel_in_sweep(inputs, groups, phase_shift, phase_shift_label, sweep)},
          .notes = notes};
}

}  // namespace

Drawing add_stroke_flags(CLI::App& command) {
  struct Flags {
    std::vector<std::string> methods;
    std::string cycle = "last";
    std::optional<Abscissa> against;
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
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    const PlotInputs inputs = read_plot_inputs(files.inputs, {flags->methods});
    return figure_to_svg(flags->against ? stroke_against(inputs, *flags->against, cycle)
                                        : stroke_by_cycle(inputs));
  };
}

}  // namespace beadswim
