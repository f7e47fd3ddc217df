#pragma once

#include <optional>
#include <string>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/prediction_document.hpp"
#include "measured_stroke.hpp"
#include "theory_request.hpp"

namespace beadswim {

/// What the methods asked for say of the layout's swimmer. `source` names the layout in messages.
/// Throws InputError if the layout has no such swimmer, or has different ones and none is named; if theory
/// cannot treat it; or if a method named cannot.
PredictionDocument predict_layout(const LayoutDocument& document, const std::string& source,
                                  const TheoryRequest& request,
                                  const std::optional<MeasuredStroke>& measured);

}  // namespace beadswim
