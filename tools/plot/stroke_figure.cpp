#include "stroke_figure.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// One number of a swimmer's stroke, and how it is drawn.
struct StrokeNumber {
  ComparedQuantity quantity;
  std::size_t position;  ///< among the quantity's numbers
  std::string symbol;
  int colour;
};

const StrokeNumber amplitude1{ComparedQuantity::arm_amplitudes, 0, "d₁", 0};
const StrokeNumber amplitude2{ComparedQuantity::arm_amplitudes, 1, "d₂", 1};
const StrokeNumber phase_shift{ComparedQuantity::sin_phase_shift, 0, "sin(δ₁ − δ₂)", 2};

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
  if (range.first == 0) throw InputError("stroke", "no run with a whole cycle is given; add a run record");
  return range;
}

Series run_series(const PlotInputs& inputs, std::size_t run_index, const StrokeNumber& number) {
  const PlottedRun& run = inputs.runs[run_index];
  Series series{.label = fmt::format("{}, {}", number.symbol, run_label(inputs, run)),
                .mark = Mark::points,
                .colour = number.colour,
                .shape = static_cast<int>(run_index)};
  for (const SwimmerRecord& swimmer : run.record.swimmers) {
    for (const CycleStatistics& cycle : swimmer.cycles) {
      series.x.push_back(cycle.index);
      series.y.push_back(swimming_in(cycle, run.record.periodic_axes()).at(number.quantity)[number.position]);
    }
  }
  return series;
}

/// A level line that reaches past the first and the last cycle.
Series prediction_series(const PlotInputs& inputs, std::size_t index, const StrokeNumber& number,
                         const CycleRange& cycles) {
  constexpr double overhang = 0.4;  // of a cycle
  const Prediction& prediction = inputs.predictions[index].prediction;
  const double value = swimming_of(prediction).at(number.quantity)[number.position];
  return {.label = fmt::format("{}, {}", number.symbol, prediction.method),
          .x = {cycles.first - overhang, cycles.last + overhang},
          .y = {value, value},
          .mark = Mark::line,
          .colour = number.colour,
          .dash = static_cast<int>(index)};
}

Panel stroke_panel(const PlotInputs& inputs, const std::vector<StrokeNumber>& numbers,
                   const AxisLabel& y_label) {
  const CycleRange cycles = cycles_of(inputs);
  Panel panel{.x_label = {"cycle"}, .y_label = y_label, .x_ticks = TickKind::integers};
  for (const StrokeNumber& number : numbers) {
    for (std::size_t i = 0; i < inputs.runs.size(); ++i) {
      panel.series.push_back(run_series(inputs, i, number));
    }
    for (std::size_t i = 0; i < inputs.predictions.size(); ++i) {
      panel.series.push_back(prediction_series(inputs, i, number, cycles));
    }
  }
  return panel;
}

}  // namespace

Figure stroke_figure(const PlotInputs& inputs) {
  const AxisLabel amplitude{"arm amplitude", length_unit(inputs.units)};
  return {.title = "Stroke by cycle",
          .panels = {stroke_panel(inputs, {amplitude1, amplitude2}, amplitude),
                     stroke_panel(inputs, {phase_shift}, {"sine of the phase shift"})},
          .notes = run_notes(inputs)};
}

}  // namespace beadswim
