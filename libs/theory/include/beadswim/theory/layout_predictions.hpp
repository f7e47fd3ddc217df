#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/theory/prediction.hpp"

// Predictions for one swimmer of a layout by several methods.

namespace beadswim {

/// A theory method that cannot treat the swimmer, and the reason.
struct LeftOutMethod {
  std::string method;
  std::string reason;

  BEADSWIM_FIELDS(method, reason)
};

/// Predictions for one swimmer of a layout.
struct LayoutPredictions {
  Units units;      ///< units of the layout, used for all quantities of the predictions
  int swimmer = 0;  ///< id of the swimmer in the layout
  std::vector<Prediction> predictions{};
  std::vector<LeftOutMethod> left_out{};
  std::vector<std::string> warnings{};  ///< beads that touch, or driving too strong for some methods
};

/// Stroke of a swimmer that a run measured, with units and driving period of the run.
struct MeasuredStroke {
  std::string source;  ///< path of the run record, for messages
  Units units;
  double period = 0;  ///< period of the driving [time]
  Stroke stroke;
};

/// Stands for all methods that can treat the swimmer, in PredictionRequest::methods.
constexpr const char* all_methods = "all";

/// What is to be predicted.
struct PredictionRequest {
  std::vector<std::string> methods{all_methods};
  std::optional<int> swimmer{};  ///< id; nullopt: all swimmers must have the same parameters
  double tolerance = 0.05;       ///< relative error of second-order methods above which there is a warning
  std::optional<MeasuredStroke> measured{};  ///< for the methods that need a measured stroke
};

/// Returns true if predictions for one swimmer of a layout are valid for another, as both have the same
/// parameters and, where these matter, the same orientation and height. `a`, `b`: ids; false if one is
/// unknown.
bool are_predicted_alike(const Layout& layout, int a, int b);

/// Predicts velocity and stroke of one swimmer of a layout by the requested methods. `source`: name of the
/// layout in messages. Throws InputError if:
///   - the layout does not contain the requested swimmer;
///   - the request names no swimmer, and the swimmers differ;
///   - theory, or a method that the request names, cannot treat the swimmer;
///   - a measured stroke is given, but its run had another period or other units, or no method uses it.
LayoutPredictions predict_layout(const Layout& layout, const std::string& source,
                                 const PredictionRequest& request);

}  // namespace beadswim
