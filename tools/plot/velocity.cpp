#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "abscissa.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/documents/study_result.hpp"
#include "beadswim/figure/curves.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Figures of the velocity along the swimmer's axis, relative to the mean flow. Runs are drawn as marks, and
// predictions as curves. With --relative-to METHOD, the figure shows the difference between each velocity and
// the prediction by this method at the same period or separation, in percent of the prediction.

namespace beadswim {
namespace {

struct VelocityFlags {
  MethodChoice methods;
  std::string cycle = "last";
  Axes axes = Axes::automatic;
};

/// Returns the prediction by the reference method at the value x on the horizontal axis. Throws InputError if
/// there is no such prediction, or if there are several with different velocities. `source`: file whose
/// velocity is compared with the prediction, for the message.
const Prediction& reference_at(const PlotInputs& inputs, Abscissa abscissa, double x,
                               const std::string& source) {
  constexpr double tolerance = 1e-9;  // relative; both abscissas are copies of one number in the layout
  const PlottedPrediction* found = nullptr;
  for (const PlottedPrediction& reference : inputs.references) {
    if (std::abs(abscissa_of(reference, abscissa) - x) > tolerance * std::abs(x)) continue;
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

/// Returns the relative difference 100 (v / v_reference - 1) [%].
double relative_difference(double velocity, const Prediction& reference) {
  return 100 * (velocity / reference.velocity - 1);
}

bool is_relative(const PlotInputs& inputs) {
  return !inputs.references.empty();
}

std::vector<PointGroup> run_points(const PlotInputs& inputs, const std::vector<RunGroup>& groups,
                                   Abscissa abscissa, const CycleChoice& cycle) {
  if (is_relative(inputs) && abscissa != Abscissa::period && !inputs.runs.empty()) {
    throw InputError(inputs.runs.front().source,
                     "the file is a run record, and with --relative-to run records can be drawn only with "
                     "--against period; leave out this file or --relative-to");
  }
  std::vector<PointGroup> all;
  for (const RunGroup& group : groups) {
    PointGroup points{group.label};
    for (const PlottedRun* run : group.runs) {
      for (const SwimmerRecord& swimmer : run->record.swimmers) {
        const double x = abscissa_of(*run, swimmer, abscissa, cycle);
        const ResultValue velocity =
            results_of(run->record, swimmer, StudyResult::velocity, cycle, run->source).front();
        points.x.push_back(x);
        if (is_relative(inputs)) {
          const Prediction& reference = reference_at(inputs, abscissa, x, run->source);
          points.y.push_back(relative_difference(velocity.value, reference));
          points.errors.push_back(100 * velocity.error / std::abs(reference.velocity));
        } else {
          points.y.push_back(velocity.value);
          points.errors.push_back(velocity.error);
        }
      }
    }
    all.push_back(std::move(points));
  }
  return all;
}

CurvePoint curve_point(const PlotInputs& inputs, Abscissa abscissa, const PlacedPrediction& placed) {
  const auto& [x, plotted] = placed;
  const Prediction& prediction = plotted.prediction;
  const double error = results_of(prediction, StudyResult::velocity).front().error;
  if (!is_relative(inputs))
    return {.x = x, .y = prediction.velocity, .usable = prediction.usable, .error = error};
  const Prediction& reference = reference_at(inputs, abscissa, x, plotted.source);
  return {.x = x,
          .y = relative_difference(prediction.velocity, reference),
          .usable = prediction.usable && reference.usable,
          .error = 100 * error / std::abs(reference.velocity)};
}

std::vector<Curve> prediction_curves(const PlotInputs& inputs, Abscissa abscissa) {
  std::vector<Curve> curves;
  for (const auto& [method, predictions] : predictions_by_method(inputs, abscissa)) {
    curves.push_back({method});
    for (const PlacedPrediction& placed : predictions)
      curves.back().points.push_back(curve_point(inputs, abscissa, placed));
  }
  return curves;
}

std::string title_of(const PlotInputs& inputs, Abscissa abscissa) {
  const std::string against = abscissa == Abscissa::period ? "driving period" : "separation of the beads";
  if (!is_relative(inputs)) return "Swimming velocity against " + against;
  return fmt::format("Swimming velocity relative to {}, against {}",
                     inputs.references.front().prediction.method, against);
}

AxisLabel velocity_label(const PlotInputs& inputs) {
  if (!is_relative(inputs)) return {"velocity", velocity_unit(inputs.units)};
  return {"difference in velocity", "%"};
}

Note velocity_reading_note(const PlotInputs& inputs) {
  if (!is_relative(inputs)) return reading_note(inputs);
  return {.text = fmt::format("Marks and lines at 0 % agree with {}.",
                              inputs.references.front().prediction.method)};
}

Figure velocity_figure(const PlotInputs& inputs, Abscissa abscissa, const VelocityFlags& flags) {
  const std::vector<RunGroup> groups = runs_by_setting(inputs);
  Panel panel{.x_label = axis_label(abscissa, inputs.units), .y_label = velocity_label(inputs)};
  append_points_and_curves(run_points(inputs, groups, abscissa, parse_cycle_choice(flags.cycle)),
                           prediction_curves(inputs, abscissa), std::nullopt, panel);
  set_axes(flags.axes, abscissa == Abscissa::separation_ratio ? Axes::log_log : Axes::log_y, panel);
  std::vector<Note> notes{velocity_reading_note(inputs)};
  std::ranges::move(prediction_notes(inputs, abscissa), std::back_inserter(notes));
  if (has_omitted_values(panel)) notes.push_back({.text = "Lines break where the velocity is not positive."});
  notes.push_back(run_note(inputs, abscissa));
  return {.title = title_of(inputs, abscissa), .panels = {std::move(panel)}, .notes = notes};
}

Drawing add_velocity_flags(CLI::App& command, Abscissa abscissa) {
  const auto flags = std::make_shared<VelocityFlags>();
  add_methods(command, flags->methods.methods);
  add_cycle(command, flags->cycle);
  command
      .add_option("--relative-to", flags->methods.relative_to,
                  "Theory method with which each velocity is compared: the figure shows the relative "
                  "difference from its prediction at the same period or separation [%]")
      ->type_name("METHOD")
      ->default_str("none");
  add_choice(command, "--axes", flags->axes,
             std::string("Axes; auto is ") + (abscissa == Abscissa::separation_ratio ? "log-log" : "log-y") +
                 " where velocities are positive and span over two decades, else linear");
  return [flags, abscissa](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    return Drawn(velocity_figure(read_plot_inputs(files.inputs, flags->methods, cycle), abscissa, *flags));
  };
}

}  // namespace

Drawing add_period_flags(CLI::App& command) {
  return add_velocity_flags(command, Abscissa::period);
}

Drawing add_separation_flags(CLI::App& command) {
  return add_velocity_flags(command, Abscissa::separation_ratio);
}

}  // namespace beadswim
