#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "beadswim/core/error.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"
#include "result_series.hpp"

// Figures of velocity and stroke against the driving, the separation of the beads or the cycle.

namespace beadswim {
namespace {

// --- Velocity. With --relative-to METHOD, the figure shows the difference between each velocity and the
// prediction by this method at the same period or separation, in percent of the prediction.

struct VelocityFlags {
  ResultFlags results;
  Axes axes = Axes::automatic;
};

/// Returns the prediction by the reference method at the value x on the horizontal axis. Throws InputError if
/// there is no such prediction, or if there are several with different velocities. `source`: file whose
/// velocity is compared with the prediction, for the message.
const Prediction& reference_at(const PlotInputs& inputs, AbscissaKind abscissa, double x,
                               const std::string& source) {
  constexpr double tolerance = 1e-9;  // relative; both abscissas are copies of one number in the layout
  const PlottedPrediction* found = nullptr;
  for (const PlottedPrediction& reference : inputs.references) {
    if (std::abs(abscissa_of(reference, {abscissa}) - x) > tolerance * std::abs(x)) continue;
    if (found != nullptr && found->prediction.velocity != reference.prediction.velocity) {
      throw InputError(reference.source,
                       fmt::format("the predicted velocity differs from the velocity in {}, although both "
                                   "predictions are by {} at {} = {:g}; give only one of the two files",
                                   found->source, reference.prediction.method, to_text(abscissa), x));
    }
    found = &reference;
  }
  if (found != nullptr) return found->prediction;
  throw InputError(
      source,
      fmt::format(
          "there is no prediction by {} at {} = {:g} to compare the velocity with; add such a prediction",
          inputs.references.front().prediction.method, to_text(abscissa), x));
}

/// Returns the relation to the reference: 100 (v / v_reference - 1) [%].
Relation relation_to_reference(const PlotInputs& inputs, AbscissaKind abscissa) {
  return [&inputs, abscissa](const ResultPoint& point, const CurvePoint& velocity) {
    const Prediction& reference = reference_at(inputs, abscissa, point.x, point.source);
    return CurvePoint{.x = point.x,
                      .y = 100 * (velocity.y / reference.velocity - 1),
                      .usable = velocity.usable && reference.usable,
                      .error = 100 * velocity.error / std::abs(reference.velocity)};
  };
}

Figure velocity_figure(const PlotInputs& inputs, AbscissaKind abscissa, const VelocityFlags& flags) {
  const std::string& relative_to = flags.results.methods.relative_to;
  const bool is_relative = !relative_to.empty(), by_period = abscissa == AbscissaKind::period;
  if (is_relative && !by_period && !inputs.runs.empty())
    throw InputError(inputs.runs.front().source,
                     "the file is a run record, and with --relative-to run records can be drawn only with "
                     "--against period; leave out this file or --relative-to");
  const ResultQuantity velocity = ResultQuantity::velocity;
  Panel panel{.x_label = axis_label({abscissa}, inputs.units),
              .y_label = is_relative ? AxisLabel{"difference in velocity", "%"}
                                     : result_label(velocity, inputs.units)};
  append(results_against(inputs, {.abscissa = {abscissa}, .cycle = flags.results.cycle_choice()}),
         {{.quantity = velocity}}, panel, is_relative ? relation_to_reference(inputs, abscissa) : Relation());
  set_axes(flags.axes, by_period ? Axes::log_y : Axes::log_log, panel);
  std::vector<Note> notes{reading_note(inputs)};
  if (is_relative) notes.front().text = fmt::format("Marks and lines at 0 % agree with {}.", relative_to);
  std::ranges::move(prediction_notes(inputs, abscissa), std::back_inserter(notes));
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where the velocity is not positive."});
  notes.push_back(run_note(inputs, abscissa));
  const std::string relative = is_relative ? fmt::format(" relative to {},", relative_to) : "";
  return {.title = fmt::format("Swimming velocity{} against {}", relative,
                               by_period ? "driving period" : "separation of the beads"),
          .panels = {std::move(panel)},
          .notes = notes};
}

Drawing add_velocity_flags(CLI::App& command, AbscissaKind abscissa) {
  const auto flags = std::make_shared<VelocityFlags>();
  add_result_flags(command, flags->results);
  command
      .add_option("--relative-to", flags->results.methods.relative_to,
                  "Theory method with which each velocity is compared: the figure shows the relative "
                  "difference from its prediction at the same period or separation [%]")
      ->type_name("METHOD")
      ->default_str("none");
  add_choice(command, "--axes", flags->axes,
             std::string("Axes; auto is ") + (abscissa == AbscissaKind::period ? "log-y" : "log-log") +
                 " where velocities are positive and span over two decades, else linear");
  return [flags, abscissa](const PlotFiles& files) {
    return Drawn(
        velocity_figure(read_plot_inputs(files.inputs, flags->results.methods, flags->results.cycle_choice()),
                        abscissa, *flags));
  };
}

// --- Stroke: arm amplitudes, and the sine of the phase shift, sin(δ₁ - δ₂)

struct StrokeFlags {
  ResultFlags results;
  std::optional<AbscissaKind> against{};  ///< nullopt: the cycle
  std::vector<int> bonds;                 ///< numbers from 1; empty: all bonds
};

/// Returns a whole number in subscript digits.
std::string subscript(int number) {
  constexpr std::array digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string text;
  for (const char digit : std::to_string(number)) text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

/// Returns the arm amplitudes of the bonds in `wanted` (numbers from 1), or, if it is empty, of all bonds.
std::vector<DrawnNumber> amplitudes_of(std::vector<int> wanted, std::size_t bonds) {
  constexpr std::size_t max_drawn = 7;  // colours that readers can distinguish
  if (wanted.empty()) {
    wanted.resize(bonds);
    std::iota(wanted.begin(), wanted.end(), 1);
  }
  if (wanted.size() > max_drawn)
    throw InputError("--bonds", fmt::format("the figure would show {} bonds, but at most {} can be "
                                            "distinguished; name fewer bonds, for example --bonds 1,2",
                                            wanted.size(), max_drawn));
  std::vector<DrawnNumber> amplitudes;
  for (const int bond : wanted) {
    if (bond > static_cast<int>(bonds))
      throw InputError("--bonds", fmt::format("no swimmer has a bond {}; the swimmers have the bonds 1 to {}",
                                              bond, bonds));
    amplitudes.push_back({.quantity = ResultQuantity::arm_amplitudes,
                          .number = static_cast<std::size_t>(bond - 1),
                          .before = "d" + subscript(bond) + ", ",
                          .colour = static_cast<int>(amplitudes.size())});
  }
  return amplitudes;
}

/// Appends the panel of the numbers. Legends omit series of swimmers that lack the bonds of the panel.
void add_panel(const DrawnResults& drawn, const std::vector<DrawnNumber>& numbers, const Units& units,
               Figure& figure) {
  Panel panel{.x_label = {}, .y_label = result_label(numbers.front().quantity, units)};
  for (const DrawnNumber& number : numbers) append(drawn, {number}, panel);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  for (Series& series : panel.series)
    if (std::ranges::none_of(series.y, is_finite)) series.label.clear();
  figure.panels.push_back(std::move(panel));
}

void add_panels(const DrawnResults& drawn, const StrokeFlags& flags, const Units& units, Figure& figure) {
  const std::size_t bonds = max_numbers(drawn, ResultQuantity::arm_amplitudes);
  if (bonds == 0)
    throw InputError("stroke",
                     "no swimmer has a bond, and so none has a stroke; draw its motion with beadswim-plot "
                     "trajectories");
  add_panel(drawn, amplitudes_of(flags.bonds, bonds), units, figure);
  if (bonds == 1) return;
  add_panel(drawn, {{.quantity = ResultQuantity::sin_phase_shift, .before = "sin(δ₁ − δ₂), ", .colour = 2}},
            units, figure);
}

Figure stroke_by_cycle(const PlotInputs& inputs, const StrokeFlags& flags) {
  const DrawnResults drawn = results_by_cycle(inputs);
  if (!drawn.level)
    throw InputError("stroke",
                     "no run with a complete cycle is given; add the record of such a run, or draw "
                     "predictions with --against amplitude-ratio or phase");
  Figure figure{.title = "Stroke by cycle", .panels = {}};
  add_panels(drawn, flags, inputs.units, figure);
  for (Panel& panel : figure.panels) {
    panel.x_label = {"cycle"};
    panel.x_ticks = TickKind::integers;
  }
  figure.notes = {
      {.text = inputs.predictions.empty()
                   ? "Marks are cycles of runs. The stroke is periodic where marks have equal height."
                   : "Marks are cycles of runs, horizontal lines are predictions. Marks that approach a line "
                     "agree with its prediction."},
      run_note(inputs, std::nullopt)};
  return figure;
}

Figure stroke_against(const PlotInputs& inputs, const StrokeFlags& flags, AbscissaKind abscissa) {
  const AxisLabel x_label = axis_label({abscissa}, inputs.units);
  Figure figure{.title = "Stroke against " + x_label.quantity, .panels = {}};
  add_panels(results_against(inputs, {.abscissa = {abscissa}, .cycle = flags.results.cycle_choice()}), flags,
             inputs.units, figure);
  for (Panel& panel : figure.panels) panel.x_label = x_label;
  figure.notes = prediction_notes(inputs, abscissa);
  figure.notes.insert(figure.notes.begin(), reading_note(inputs));
  figure.notes.push_back(run_note(inputs, abscissa));
  return figure;
}

}  // namespace

Drawing add_period_flags(CLI::App& command) {
  return add_velocity_flags(command, AbscissaKind::period);
}

Drawing add_separation_flags(CLI::App& command) {
  return add_velocity_flags(command, AbscissaKind::separation_ratio);
}

Drawing add_stroke_flags(CLI::App& command) {
  const auto flags = std::make_shared<StrokeFlags>();
  add_result_flags(command, flags->results);
  add_word(command, "--against", {"cycle", "amplitude-ratio", "phase"}, "cycle",
           "Quantity on the horizontal axis: the cycle (predictions are then horizontal lines), the ratio "
           "A/B of the driving amplitudes, or the driving phase alpha",
           [flags](const std::string& word) {
             flags->against.reset();
             if (word != "cycle")
               flags->against = word == "phase" ? AbscissaKind::phase : AbscissaKind::amplitude_ratio;
           });
  add_whole_numbers(command, "--bonds", flags->bonds, number_list({}, whole_positive()),
                    "Numbers of the bonds whose arm amplitudes are drawn, from 1")
      ->type_name("N,...")
      ->default_str("all");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = flags->results.cycle_choice();
    const PlotInputs inputs =
        read_plot_inputs(files.inputs, flags->results.methods, flags->against ? cycle : CycleChoice{});
    return Drawn(flags->against ? stroke_against(inputs, *flags, *flags->against)
                                : stroke_by_cycle(inputs, *flags));
  };
}

}  // namespace beadswim
