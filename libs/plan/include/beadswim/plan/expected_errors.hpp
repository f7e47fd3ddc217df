#pragma once

#include "beadswim/compare/expected_errors.hpp"
#include "beadswim/run/model.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Returns the expected errors of a planned run of the layout. Throws InputError with the reason if the
/// errors are not known.
ExpectedErrors expected_errors(const Layout& layout, const ModelPlan& plan);

/// Sets the expected errors of a planned run. Adds a warning if they are larger than `accepted` or not known.
void add_expected_errors(ModelPlan& plan, const Layout& layout, double accepted);

}  // namespace beadswim
