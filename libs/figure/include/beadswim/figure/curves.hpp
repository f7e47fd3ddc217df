#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/figure.hpp"

// Series of a panel from numbers: measured points, predicted curves, and levels.

namespace beadswim {

/// Points of one label.
struct PointGroup {
  std::string label;
  std::vector<double> x{}, y{};
};

struct CurvePoint {
  double x = 0, y = 0;
  bool usable = true;
};

/// Points of one label that a line joins, in order of x.
struct Curve {
  std::string label;
  std::vector<CurvePoint> points{};
};

/// A value that holds for all x.
struct Level {
  std::string label;
  double y = 0;
};

/// Appends groups as filled points, then curves as lines, with open points where there are few. Stretches
/// that are not usable are faint. All have the same colour, or each its own if none is given.
void append_points_and_curves(const std::vector<PointGroup>& groups, const std::vector<Curve>& curves,
                              std::optional<int> colour, Panel& panel);

/// Appends level lines, told apart by their dashes.
void append_levels(const std::vector<Level>& levels, double from, double to, int colour, Panel& panel);

/// Makes lines of curves, which come by swimmer, then by bead. Colours tell swimmers apart and dashes their
/// beads; beads of one swimmer alone have colours, and swimmers of one bead each have dashes too, so that no
/// curve hides another.
void style_bead_curves(int num_beads, std::vector<Series>& curves);

enum class Axes {
  automatic,  ///< logarithmic where plain values are positive and span over two decades, else linear
  linear,
  log_y,
  log_log,
};

template <>
inline constexpr auto name_table<Axes> = std::to_array<NamedValue<Axes>>({{Axes::automatic, "auto"},
                                                                          {Axes::linear, "linear"},
                                                                          {Axes::log_y, "log-y"},
                                                                          {Axes::log_log, "log-log"}});

/// Sets the scales of a panel that has its series. `over_decades` is what automatic axes are, where they are
/// logarithmic.
void set_axes(Axes axes, Axes over_decades, Panel& panel);

/// Whether the y axis is logarithmic, so that values which are not positive are not drawn.
bool leaves_out_values(const Panel& panel);

}  // namespace beadswim
