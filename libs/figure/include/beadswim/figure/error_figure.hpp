#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// An error and what it cost.
struct ErrorPoint {
  std::string name;    ///< in notes
  std::string source;  ///< in error messages
  double cost = 0;     ///< [s]
  double error = 0;    ///< relative
};

/// Points that a line joins, in this order.
struct ErrorSeries {
  std::string label;
  std::vector<ErrorPoint> points;
};

/// Errors of one quantity.
struct QuantityErrors {
  std::string quantity;
  std::vector<ErrorSeries> series;
  std::optional<double> uncertainty{};  ///< of the reference, relative
};

/// A panel for each quantity: its errors in percent against their costs, both logarithmic. A faint line joins
/// the points for which no other is both cheaper and more exact (Pareto's front), and a note names them; the
/// uncertainty is a level. `notes` come first. Throws InputError for a point that no logarithmic axis holds.
Figure error_figure(const std::vector<QuantityErrors>& quantities, const std::string& cost,
                    std::vector<std::string> notes);

}  // namespace beadswim
