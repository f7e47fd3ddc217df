#pragma once

#include <string>

#include "beadswim/compare/cycle_choice.hpp"
#include "beadswim/compare/result_quantity.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/theory/prediction.hpp"

// Results of swimmers in runs and predictions: what programs compare, draw, search and limit. A new result is
// an enumerator and a row in compare/result_quantity.hpp, and its computation in results.cpp.

namespace beadswim {

/// Returns the unit for figures: "um/s", "lattice units", or "" if there is none.
std::string unit_of(ResultQuantity quantity, const Units& units);

/// Uncertainties of the results of a run, which are known for its last cycle only.
enum class RunUncertainty {
  of_cycle,             ///< as the record states them for the swimmer
  with_expected_error,  ///< as above, with the expected error of the run if the record states it
};

/// Returns the results of a swimmer of a run, means over the chosen cycles. With thermal noise, the last
/// cycle stands for all but the first, and uncertainties are standard errors. Throws InputError if the run
/// lacks a chosen cycle. `source`: name of the record in messages.
Results results_of(const RunRecord& run, const SwimmerRecord& swimmer, const CycleChoice& choice,
                   const std::string& source,
                   RunUncertainty uncertainty = RunUncertainty::with_expected_error);

/// Returns the arithmetic mean of each number and of relative uncertainties; a quantity that one element
/// lacks is unknown. `all`: not empty.
Results mean_of(const std::vector<Results>& all);

/// Returns the mean of results of runs that differ in their noise alone, with its standard error.
Results mean_with_errors(const std::vector<Results>& all);

/// Returns the axis of the swimmer in the box, for which a prediction states vectors; nullopt if the scene is
/// unknown (nullptr), or if the axis is not that of the scene, because the drives turn the swimmer.
std::optional<Vec3> predicted_axis(const Prediction& prediction, const Layout* scene, int swimmer);

/// Returns the results of a prediction for a swimmer. `scene`: nullptr if unknown; then there is no gap.
/// `swimmer`: id of the swimmer in the scene.
Results results_of(const Prediction& prediction, const Layout* scene, int swimmer);

}  // namespace beadswim
