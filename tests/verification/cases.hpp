#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim::verification {

/// How much of a case is measured.
enum class Extent {
  whole,  ///< for docs/verification.md: minutes
  brief,  ///< for ctest: seconds
};

/// Takes one record: "case", "scheme", "tau", parameters, "measured", "reference", "error" and more.
using Emit = std::function<void(const Json&)>;

/// One phenomenon: measured for one scheme, and what the records of all schemes say, in Markdown.
struct Case {
  std::string name;
  void (*measure)(BeadScheme, Extent, const Emit&);
  std::string (*report)(const std::vector<Json>& records);
};

const std::vector<Case>& all_cases();

/// docs/verification.md from records in any order.
std::string verification_page(const std::vector<Json>& records);

void measure_array_drag(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_array_drag(const std::vector<Json>& records);

void measure_hydrodynamic_radius(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_hydrodynamic_radius(const std::vector<Json>& records);

void measure_torque(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_torque(const std::vector<Json>& records);

void measure_collinear_spheres(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_collinear_spheres(const std::vector<Json>& records);

void measure_sedimentation(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_sedimentation(const std::vector<Json>& records);

void measure_oscillation(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_oscillation(const std::vector<Json>& records);

void measure_galilean_invariance(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_galilean_invariance(const std::vector<Json>& records);

void measure_conservation(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_conservation(const std::vector<Json>& records);

void measure_near_contact(BeadScheme scheme, Extent extent, const Emit& emit);
std::string report_near_contact(const std::vector<Json>& records);

}  // namespace beadswim::verification
