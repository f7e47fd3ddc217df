#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "measured_stroke.hpp"
#include "theory_request.hpp"

namespace beadswim {

/// Predicts velocity and stroke of one swimmer of a layout by the requested methods. `source`: name of the
/// layout in messages. `measured`: stroke for the methods that need a measured stroke. Throws InputError if:
///   - the layout does not contain the requested swimmer;
///   - the request names no swimmer, and the swimmers differ;
///   - theory, or a method that the request names, cannot treat the swimmer;
///   - `measured` is given, but its run had another period or other units, or no method uses the stroke.
PredictionDocument predict_layout(const LayoutDocument& document, const std::string& source,
                                  const TheoryRequest& request,
                                  const std::optional<MeasuredStroke>& measured);

}  // namespace beadswim
