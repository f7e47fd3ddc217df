#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"

namespace beadswim {

/// Error and cost of a run.
struct ErrorPoint {
  std::string name;    ///< name of the run in a note
  std::string source;  ///< file of the run, for error messages
  double cost = 0;     ///< [s]
  double error = 0;    ///< relative error
};

/// Points that are connected by a line in this order.
struct ErrorSeries {
  std::string label;
  std::vector<ErrorPoint> points;
};

/// Errors of one quantity in one scene.
struct QuantityErrors {
  std::string quantity;
  std::vector<ErrorSeries> series;
  std::optional<double> uncertainty{};  ///< relative uncertainty of the reference
  std::string scene{};                  ///< title of the panel, if the figure shows several scenes
};

/// Returns a figure with one panel per element of `quantities`, which shows errors in percent as a function
/// of their costs, on logarithmic axes. Series with equal labels look alike. A faint line connects the Pareto
/// front: the points for which no other point is both cheaper and more accurate. The uncertainty of the
/// reference is a horizontal line; errors below it are not ranked. Below the panels are the given `notes`,
/// and one note per panel that names the most accurate point. `cost` is the label of the
/// cost axis. Points whose cost or error is not positive and finite are left out and counted in a note.
/// Throws InputError if a panel has no other points.
Figure error_figure(const std::vector<QuantityErrors>& quantities, const std::string& cost,
                    std::vector<Note> notes);

}  // namespace beadswim
