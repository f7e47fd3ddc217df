#pragma once

#include <string>

#include "beadswim/documents/results.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

namespace beadswim {

/// Axes of a map: two quantities of a study.
struct MapSettings {
  std::string x, y;
  ScaleKind x_scale = ScaleKind::linear, y_scale = ScaleKind::linear;
  ResultQuantity colour{};  ///< result that colours show
  CycleChoice cycle{};
};

/// Returns a map of the result, with a rectangle per layout of the study and a panel per arm. Throws
/// InputError if two inputs have a value at one point.
Figure map_figure(const PlotInputs& inputs, const MapSettings& settings);

}  // namespace beadswim
