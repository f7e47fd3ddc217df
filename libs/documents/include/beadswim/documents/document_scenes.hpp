#pragma once

#include <vector>

#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/scene/scene_differences.hpp"

namespace beadswim {

/// Returns the differences between the scenes of a run and its reference, which must have the same units. If
/// one of the documents contains no scene, compares the properties that both state: a run record states
/// domain, swimmers and driving, a prediction the driving of its swimmer.
std::vector<SceneDifference> scene_differences(const RunRecord& run, const SwimmingDocument& reference);

/// Returns the difference in words, for example "period 2000 instead of 4800": the value of the reference
/// instead of the value of the run.
std::string in_words(const SceneDifference& difference);

}  // namespace beadswim
