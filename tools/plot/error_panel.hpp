#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// An error and what it cost.
struct ErrorPoint {
  std::string name;    ///< as notes call it
  std::string source;  ///< as errors call it
  double cost = 0;     ///< [s]
  double error = 0;    ///< relative
};

/// Points that a line joins, in this order.
struct ErrorSeries {
  std::string label;
  std::vector<ErrorPoint> points;
};

struct ErrorPanel {
  Panel panel;
  std::vector<std::string> notes;  ///< that name the points of the front
};

double root_mean_square(const std::vector<double>& values);

/// Errors of a quantity in percent against their costs, both logarithmic. A faint line joins the points than
/// which none is both cheaper and more exact (Pareto's front); the uncertainty, relative, is a level. Throws
/// InputError for a point that no logarithmic axis holds.
ErrorPanel error_panel(const std::vector<ErrorSeries>& all, const std::string& quantity,
                       const std::string& cost, std::optional<double> uncertainty);

}  // namespace beadswim
