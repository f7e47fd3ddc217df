#include "stroke_figure.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/units.hpp"
#include "curves.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

/// One number of a swimmer's stroke, and how it is drawn.
struct StrokeNumber {
  ComparedQuantity quantity;
  std::size_t position;  ///< among the quantity's numbers
  std::string symbol;
  int colour;

  double in(const Swimming& swimming) const { return swimming.at(quantity)[position]; }
};

using StrokeNumbers = std::vector<StrokeNumber>;

const StrokeNumbers amplitudes{{ComparedQuantity::arm_amplitudes, 0, "d₁", 0},
                               {ComparedQuantity::arm_amplitudes, 1, "d₂", 1}};
const StrokeNumbers phase_shift{{ComparedQuantity::sin_phase_shift, 0, "sin(δ₁ − δ₂)", 2}};

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
    throw InputError(
        "stroke",
        "no run with a whole cycle is given; add a run record, or draw predictions with --against "
        "amplitude-ratio or phase");
  }
  return range;
}

/// shape: different for runs, or groups of them, that are told apart.
Series empty_run_series(const std::string& label, std::size_t shape, const StrokeNumber& number) {
  return {.label = fmt::format("{}, {}", number.symbol, label),
          .mark = Mark::points,
          .colour = number.colour,
          .shape = static_cast<int>(shape)};
}

Series run_by_cycle(const PlotInputs& inputs, std::size_t run_index, const StrokeNumber& number) {
  const RunRecord& record = inputs.runs[run_index].record;
  Series series = empty_run_series(run_label(inputs, inputs.runs[run_index]), run_index, number);
  for (const SwimmerRecord& swimmer : record.swimmers) {
    for (const CycleStatistics& cycle : swimmer.cycles) {
      series.x.push_back(cycle.index);
      series.y.push_back(number.in(swimming_in(cycle, record.domain)));
    }
  }
  return series;
}

/// A level line that reaches past the first and the last cycle.
Series level_line(const PlotInputs& inputs, std::size_t index, const StrokeNumber& number,
                  const CycleRange& cycles) {
  constexpr double overhang = 0.4;  // of a cycle
  const Prediction& prediction = inputs.predictions[index].prediction;
  const double value = number.in(swimming_of(prediction));
  return {.label = fmt::format("{}, {}", number.symbol, prediction.method),
          .x = {cycles.first - overhang, cycles.last + overhang},
          .y = {value, value},
          .mark = Mark::line,
          .colour = number.colour,
          .dash = static_cast<int>(index)};
}

Panel panel_by_cycle(const PlotInputs& inputs, const StrokeNumbers& numbers, const AxisLabel& y_label) {
  const CycleRange cycles = cycles_of(inputs);
  Panel panel{.x_label = {"cycle"}, .y_label = y_label, .x_ticks = TickKind::integers};
  for (const StrokeNumber& number : numbers) {
    for (std::size_t i = 0; i < inputs.runs.size(); ++i) {
      panel.series.push_back(run_by_cycle(inputs, i, number));
    }
    for (std::size_t i = 0; i < inputs.predictions.size(); ++i) {
      panel.series.push_back(level_line(inputs, i, number, cycles));
    }
  }
  return panel;
}

/// What the panels' x axis is.
struct Sweep {
  Abscissa abscissa;
  CycleChoice cycle;
};

Series runs_in_sweep(const RunGroup& group, std::size_t shape, const StrokeNumber& number,
                     const Sweep& sweep) {
  Series series = empty_run_series(group.label, shape, number);
  for (const PlottedRun* run : group.runs) {
    for (const SwimmerRecord& swimmer : run->record.swimmers) {
      series.x.push_back(abscissa_of(*run, swimmer, sweep.abscissa, sweep.cycle));
      series.y.push_back(number.in(swimming_of(run->record, swimmer, sweep.cycle, run->source)));
    }
  }
  return series;
}

std::vector<Series> method_in_sweep(const MethodPredictions& method, std::size_t position,
                                    const StrokeNumber& number) {
  std::vector<CurvePoint> points;
  for (const PlacedPrediction& placed : method.predictions) {
    const Prediction& prediction = placed.plotted.prediction;
    points.push_back({placed.x, number.in(swimming_of(prediction)), prediction.usable});
  }
  return curve_series(points, {.label = fmt::format("{}, {}", number.symbol, method.method),
                               .colour = number.colour,
                               .shape = method_shape(position),
                               .dash = static_cast<int>(position)});
}

Panel panel_in_sweep(const PlotInputs& inputs, const std::vector<RunGroup>& groups,
                     const StrokeNumbers& numbers, const AxisLabel& y_label, const Sweep& sweep) {
  Panel panel{.x_label = axis_label(sweep.abscissa, inputs.units), .y_label = y_label};
  const auto methods = predictions_by_method(inputs, sweep.abscissa);
  for (const StrokeNumber& number : numbers) {
    for (std::size_t g = 0; g < groups.size(); ++g)
      panel.series.push_back(runs_in_sweep(groups[g], g, number, sweep));
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const auto curve = method_in_sweep(methods[i], i, number);
      panel.series.insert(panel.series.end(), curve.begin(), curve.end());
    }
  }
  return panel;
}

}  // namespace

Figure stroke_by_cycle(const PlotInputs& inputs) {
  return {.title = "Stroke by cycle",
          .panels = {panel_by_cycle(inputs, amplitudes, amplitude_label(inputs)),
                     panel_by_cycle(inputs, phase_shift, phase_shift_label)},
          .notes = run_notes(inputs)};
}

Figure stroke_against(const PlotInputs& inputs, Abscissa abscissa, const CycleChoice& cycle) {
  const Sweep sweep{abscissa, cycle};
  const std::vector<RunGroup> groups = runs_by_setting(inputs);
  std::vector<std::string> notes = prediction_notes(inputs, abscissa);
  const auto more = group_notes(groups);
  notes.insert(notes.end(), more.begin(), more.end());
  return {.title = "Stroke against " + axis_label(abscissa, inputs.units).quantity,
          .panels = {panel_in_sweep(inputs, groups, amplitudes, amplitude_label(inputs), sweep),
                     panel_in_sweep(inputs, groups, phase_shift, phase_shift_label, sweep)},
          .notes = notes};
}

}  // namespace beadswim
