#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"
#include "records.hpp"

namespace beadswim::verification {

/// Number of measurements of a case.
enum class Extent {
  whole,  ///< for docs/verification.md: minutes
  brief,  ///< for ctest: seconds
};

/// Function that receives one record: "case", "scheme", "tau", parameters, "measured", "reference", "error"
/// and other values.
using Emit = std::function<void(const Json&)>;

/// Function that returns the text for one record in a cell of a table.
using Print = std::string (*)(const Json& record);

/// Row of a table. `values` select one record for each scheme of the bead boundary.
struct Row {
  std::string conditions;
  Json values;
  Print print = error_and_spread;
};

/// A physical law that beads in the fluid must obey, with the two tables of its section in
/// docs/verification.md.
struct Law {
  std::string title;
  std::string claim;      ///< defines the quantity
  std::string reference;  ///< exact value, with its source
  std::string test;       ///< conditions that the brief extent measures
  std::string quantity = "Error ± standard deviation [%]";
  std::vector<Row> rows{};
};

/// Upper bounds of "error" and "spread" in the brief extent, for all schemes. A bound of zero means that no
/// spread is measured.
struct Limits {
  double error = 0, spread = 0;
};

/// Measurement for one scheme of the bead boundary, the law that it verifies, and its limits.
struct Case {
  std::string name;
  void (*measure)(BeadScheme, Extent, const Emit&);
  Law (*law)();
  Limits limits;
};

const std::vector<Case>& all_cases();

/// Returns the page docs/verification.md, made from the records, which can be in any order.
std::string verification_page(const std::vector<Json>& records);

void measure_array_drag(BeadScheme scheme, Extent extent, const Emit& emit);
Law array_drag_law();

void measure_hydrodynamic_radius(BeadScheme scheme, Extent extent, const Emit& emit);
Law hydrodynamic_radius_law();

void measure_torque(BeadScheme scheme, Extent extent, const Emit& emit);
Law torque_law();

void measure_collinear_spheres(BeadScheme scheme, Extent extent, const Emit& emit);
Law collinear_spheres_law();

void measure_sedimentation(BeadScheme scheme, Extent extent, const Emit& emit);
Law sedimentation_law();

void measure_oscillation(BeadScheme scheme, Extent extent, const Emit& emit);
Law oscillation_law();

void measure_galilean_invariance(BeadScheme scheme, Extent extent, const Emit& emit);
Law galilean_invariance_law();

void measure_conservation(BeadScheme scheme, Extent extent, const Emit& emit);
Law conservation_law();

void measure_near_contact(BeadScheme scheme, Extent extent, const Emit& emit);
Law near_contact_law();

}  // namespace beadswim::verification
