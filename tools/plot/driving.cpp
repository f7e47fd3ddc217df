#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

#include "beadswim/core/error.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Figures of velocity and stroke against the driving, the separation of the beads or the cycle.

namespace beadswim {
namespace {

// --- Velocity. With --relative-to METHOD, the figure shows the difference between each velocity and the
// prediction by this method at the same period or separation, in percent of the prediction.

struct VelocityFlags {
  InputChoice choice;
  Axes axes = Axes::automatic;
};

/// Returns the relation to the prediction by the reference method at the same value on the horizontal axis:
/// 100 (v / v_reference - 1) [%]. It throws InputError if there is no such prediction, or if there are
/// several with different velocities.
Relation relation_to_reference(const PlotInputs& inputs, AbscissaKind abscissa) {
  return [&inputs, abscissa](const ResultPoint& point, const CurvePoint& velocity) {
    constexpr double tolerance = 1e-9;  // relative; both abscissas are copies of one number in the layout
    const PlottedPrediction* found = nullptr;
    for (const PlottedPrediction& reference : inputs.references) {
      if (std::abs(abscissa_of(reference, {abscissa}) - point.x) > tolerance * std::abs(point.x)) continue;
      if (found != nullptr && found->prediction().velocity != reference.prediction().velocity)
        throw InputError(reference.source,
                         "the predicted velocity differs from the velocity in {}, although both predictions "
                         "are by {} at {} = {:g}; give only one of the two files",
                         found->source, reference.prediction().method, to_text(abscissa), point.x);
      found = &reference;
    }
    if (found == nullptr)
      throw InputError(
          point.source,
          "there is no prediction by {} at {} = {:g} to compare the velocity with; add such a prediction",
          inputs.references.front().prediction().method, to_text(abscissa), point.x);
    const Prediction& reference = found->prediction();
    return CurvePoint{.x = point.x,
                      .y = 100 * (velocity.y / reference.velocity - 1),
                      .usable = velocity.usable && reference.usable,
                      .error = 100 * velocity.error / std::abs(reference.velocity)};
  };
}

Figure velocity_figure(const PlotInputs& inputs, AbscissaKind abscissa, const VelocityFlags& flags) {
  const std::string& relative_to = flags.choice.relative_to;
  const bool is_relative = !relative_to.empty(), by_period = abscissa == AbscissaKind::period;
  if (is_relative && !by_period && !inputs.runs.empty())
    throw InputError(inputs.runs.front().source,
                     "the file is a run record, and with --relative-to run records can be drawn only with "
                     "--against period; leave out this file or --relative-to");
  Panel panel{.x_label = axis_label({abscissa}, inputs.units),
              .y_label = is_relative ? AxisLabel{"difference in velocity", "%"}
                                     : result_label(ResultQuantity::velocity, inputs.units)};
  append(results_against(inputs, {abscissa}, flags.choice.cycle), {{.quantity = ResultQuantity::velocity}},
         panel, is_relative ? relation_to_reference(inputs, abscissa) : Relation());
  set_axes(flags.axes, by_period ? Axes::log_y : Axes::log_log, panel);
  std::vector<Note> notes = notes_against(inputs, abscissa);
  if (is_relative) notes.front().text = fmt::format("Marks and lines at 0 % agree with {}.", relative_to);
  if (has_omitted_values(panel))
    notes.insert(notes.end() - 1, {.text = "Lines break where the velocity is not positive."});
  const std::string relative = is_relative ? fmt::format(" relative to {},", relative_to) : "";
  return {.title = fmt::format("Swimming velocity{} against {}", relative,
                               by_period ? "driving period" : "separation of the beads"),
          .panels = {std::move(panel)},
          .notes = notes};
}

// --- Stroke: arm amplitudes, and the sine of the phase shift, sin(δ₁ - δ₂)

struct StrokeFlags {
  InputChoice choice;
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
    throw InputError("--bonds",
                     "the figure would show {} bonds, but at most {} can be distinguished; name fewer bonds, "
                     "for example --bonds 1,2",
                     wanted.size(), max_drawn);
  std::vector<DrawnNumber> amplitudes;
  for (const int bond : wanted) {
    if (bond > static_cast<int>(bonds))
      throw InputError("--bonds", "no swimmer has a bond {}; the swimmers have the bonds 1 to {}", bond,
                       bonds);
    amplitudes.push_back({.quantity = ResultQuantity::arm_amplitudes,
                          .number = static_cast<std::size_t>(bond - 1),
                          .before = "d" + subscript(bond) + ", ",
                          .colour = static_cast<int>(amplitudes.size())});
  }
  return amplitudes;
}

/// Appends the panel of the numbers. Legends omit series of swimmers that lack the bonds of the panel.
void add_panel(const DrawnResults& drawn, const std::vector<DrawnNumber>& numbers, Panel panel,
               Figure& figure) {
  for (const DrawnNumber& number : numbers) append(drawn, {number}, panel);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  for (Series& series : panel.series)
    if (std::ranges::none_of(series.y, is_finite)) series.label.clear();
  figure.panels.push_back(std::move(panel));
}

Figure stroke_figure(const PlotInputs& inputs, const StrokeFlags& flags) {
  const bool by_cycle = !flags.against;
  const DrawnResults drawn =
      by_cycle ? results_by_cycle(inputs) : results_against(inputs, {*flags.against}, flags.choice.cycle);
  if (by_cycle && !drawn.level)
    throw InputError("stroke",
                     "no run with a complete cycle is given; add the record of such a run, or draw "
                     "predictions with --against amplitude-ratio or phase");
  const std::size_t bonds = max_numbers(drawn, ResultQuantity::arm_amplitudes);
  if (bonds == 0)
    throw InputError("stroke",
                     "no swimmer has a bond, and so none has a stroke; draw its motion with beadswim-plot "
                     "trajectories");
  const auto panel_of = [&](ResultQuantity quantity) {
    return Panel{.x_label = by_cycle ? AxisLabel{"cycle"} : axis_label({*flags.against}, inputs.units),
                 .y_label = result_label(quantity, inputs.units),
                 .x_ticks = by_cycle ? TickKind::integers : TickKind::any};
  };
  Figure figure{.title = by_cycle ? "Stroke by cycle"
                                  : "Stroke against " + axis_label({*flags.against}, inputs.units).quantity,
                .panels = {}};
  add_panel(drawn, amplitudes_of(flags.bonds, bonds), panel_of(ResultQuantity::arm_amplitudes), figure);
  if (bonds > 1)
    add_panel(drawn, {{.quantity = ResultQuantity::sin_phase_shift, .before = "sin(δ₁ − δ₂), ", .colour = 2}},
              panel_of(ResultQuantity::sin_phase_shift), figure);
  if (!by_cycle) {
    figure.notes = notes_against(inputs, *flags.against);
    return figure;
  }
  figure.notes = {
      {.text = inputs.predictions.empty()
                   ? "Marks are cycles of runs. The stroke is periodic where marks have equal height."
                   : "Marks are cycles of runs, horizontal lines are predictions. Marks that approach a line "
                     "agree with its prediction."},
      run_note(inputs, std::nullopt)};
  return figure;
}

}  // namespace

DrawFigure add_velocity_flags(CLI::App& command, AbscissaKind abscissa) {
  const auto flags = std::make_shared<VelocityFlags>();
  add_result_flags(command, flags->choice);
  add_value(command, "--relative-to", flags->choice.relative_to, {.name = "METHOD", .initial = "none"},
            "Theory method with which each velocity is compared: the figure shows the relative difference "
            "from its prediction at the same period or separation [%]");
  add_choice(command, "--axes", flags->axes,
             std::string("Axes; auto is ") + (abscissa == AbscissaKind::period ? "log-y" : "log-log") +
                 " where velocities are positive and span over two decades, else linear");
  return [flags, abscissa](const PlotFiles& files) {
    return draw(velocity_figure(read_plot_inputs(files.inputs, flags->choice), abscissa, *flags));
  };
}

DrawFigure add_stroke_flags(CLI::App& command) {
  const auto flags = std::make_shared<StrokeFlags>();
  add_result_flags(command, flags->choice);
  add_word(command, "--against", {"cycle", "amplitude-ratio", "phase"}, "cycle",
           "Quantity on the horizontal axis: the cycle (predictions are then horizontal lines), the ratio "
           "A/B of the driving amplitudes, or the driving phase alpha",
           [flags](const std::string& word) {
             flags->against.reset();
             if (word != "cycle")
               flags->against = word == "phase" ? AbscissaKind::phase : AbscissaKind::amplitude_ratio;
           });
  add_list(command, "--bonds", flags->bonds, {"N,...", number_list({}, whole_positive()), "all"},
           "Numbers of the bonds whose arm amplitudes are drawn, from 1");
  return [flags](const PlotFiles& files) {
    InputChoice choice = flags->choice;
    if (!flags->against) choice.cycle = {};  // all cycles are drawn
    return draw(stroke_figure(read_plot_inputs(files.inputs, choice), *flags));
  };
}

}  // namespace beadswim
