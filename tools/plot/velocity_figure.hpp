#pragma once

#include "abscissa.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

enum class Axes {
  automatic,  ///< logarithmic where positive velocities span over two decades; the separation then, too
  linear,
  log_y,
  log_log,
};

template <>
inline constexpr auto name_table<Axes> = std::to_array<NamedValue<Axes>>({{Axes::automatic, "auto"},
                                                                          {Axes::linear, "linear"},
                                                                          {Axes::log_y, "log-y"},
                                                                          {Axes::log_log, "log-log"}});

struct VelocityFigureOptions {
  Abscissa abscissa = Abscissa::period;
  CycleChoice cycle{};  ///< of the runs
  Axes axes = Axes::automatic;
};

/// Velocity along the axis, against the fluid: runs as points, one series a model; predictions joined in
/// order of the abscissa, one curve a method, faint where not usable. With inputs.references, the difference
/// of all from them at the same abscissa, in percent. Throws InputError.
Figure velocity_figure(const PlotInputs& inputs, const VelocityFigureOptions& options);

}  // namespace beadswim
