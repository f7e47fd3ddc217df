#pragma once

#include <string>
#include <vector>

#include "abscissa.hpp"
#include "beadswim/figure/figure.hpp"
#include "plot_inputs.hpp"

// Curves through the predictions of a method.

namespace beadswim {

struct PlacedPrediction {
  double x = 0;  ///< its abscissa
  PlottedPrediction plotted;
};

/// A method's predictions in order of the abscissa.
struct MethodPredictions {
  std::string method;
  std::vector<PlacedPrediction> predictions;
};

/// In the order of inputs.methods. Throws InputError if a prediction does not say its abscissa.
std::vector<MethodPredictions> predictions_by_method(const PlotInputs& inputs, Abscissa abscissa);

struct CurvePoint {
  double x = 0, y = 0;
  bool usable = true;
};

/// The curve through the points, styled as `style`: usable stretches plain, the others faint. Few points are
/// marked one by one.
std::vector<Series> curve_series(const std::vector<CurvePoint>& points, const Series& style);

/// Shape of the points of the method at that position: open, so that runs, filled, stand out.
int method_shape(std::size_t position);

}  // namespace beadswim
