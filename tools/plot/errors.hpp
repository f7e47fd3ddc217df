#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "beadswim/compare/errors_by_setting.hpp"
#include "beadswim/figure/figure.hpp"

// Errors and costs of runs, from run records or from verdicts, and their figure.

namespace beadswim {

/// Errors and costs of the runs of one scene.
struct SceneErrors {
  std::vector<ErrorsOfSetting> settings;
  std::string title{};  ///< title of the panels, if the figure shows several scenes
  std::map<ResultQuantity, double> uncertainties{};  ///< relative, of the reference, where it states them
};

/// Returns a figure of errors in percent as a function of their costs, on logarithmic axes, with a panel per
/// scene for velocity and for arm amplitudes, or for `only` one of them, if errors of the quantity are known.
/// A line connects the points of a setting, which looks alike in all panels. A faint line connects the Pareto
/// front: the points for which no other point is both cheaper and more accurate. The uncertainty of the
/// reference is a horizontal line; errors below it are not ranked. Below the panels are the given `notes`,
/// and one note per panel that names the most accurate point. `cost` is the label of the cost axis. Points
/// whose cost or error is not positive and finite are left out and counted in a note. Throws InputError if a
/// panel has no other points.
Figure error_figure(const std::vector<SceneErrors>& scenes, std::optional<ResultQuantity> only,
                    const std::string& cost, std::vector<Note> notes);

/// Reads verdicts. Each is a setting with the name of its file: its cost, and the root mean square of all
/// errors of velocity and arm amplitudes, relative to the method that determined the verdict or to the method
/// that `named` names. `drawn`: these methods. Throws InputError if a verdict does not contain the named
/// method or its cost, if `named` has more than one name, or if no verdict compares these quantities.
std::vector<ErrorsOfSetting> read_verdicts(const std::vector<std::string>& files,
                                           const std::vector<std::string>& named,
                                           std::set<std::string>& drawn);

}  // namespace beadswim
