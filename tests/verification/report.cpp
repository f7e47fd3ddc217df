#include <fmt/core.h>

#include "cases.hpp"
#include "records.hpp"

namespace beadswim::verification {
namespace {

std::string limit_text(double limit) {
  return limit < 1e-3 ? fmt::format("{:g}", limit) : fmt::format("{:g} %", 100 * limit);
}

std::string test_table(const Case& one, const Law& law) {
  const std::string spread = one.limits.spread > 0 ? " ± " + limit_text(one.limits.spread) : "";
  return fmt::format(
      "| Claim | Reference | Repeated by the test | Limit |\n|---|---|---|---|\n| {} | {} | {} | {}{} |\n",
      law.claim, law.reference, law.test, limit_text(one.limits.error), spread);
}

/// Returns one line of the table; an empty text if no record has the values of the row.
std::string table_line(const Row& row, const std::vector<Json>& records,
                       const std::vector<std::string>& schemes) {
  const std::vector<Json> of_row = where(records, row.values);
  if (of_row.empty()) return "";
  std::string line = "| " + row.conditions + " |";
  for (const std::string& scheme : schemes) {
    const std::vector<Json> found = where(of_row, {{"scheme", scheme}});
    line += found.empty() ? " |" : " " + row.print(found[0]) + " |";
  }
  return line + "\n";
}

std::string measured_table(const Law& law, const std::vector<Json>& records) {
  const std::vector<std::string> schemes = schemes_in(records);
  std::string text = "| " + law.quantity + " |", rule = "|---|";
  for (const std::string& scheme : schemes) {
    text += " " + scheme + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const Row& row : law.rows) text += table_line(row, records, schemes);
  return text;
}

constexpr const char* introduction =
    "# Verification: beads in the fluid\n\n"
    "The tables compare the four [bead boundaries](choosing-a-model.md) with exact results, at τ = 1.5 "
    "unless stated, as mean and standard deviation over 1 to 16 random positions. A row such as "
    "\"8 cells\" is for 8 cells per bead diameter. In drag and torque `mr` scatters least with the position "
    "of a bead within a cell, and its error is at most 1.2 % from 6 cells per diameter on.\n\n"
    "`beadswim-verification --report docs/results/verification.jsonl` prints this page; "
    "`docs/results/verification.sh` measures the records, which hold more conditions. `ctest -R "
    "verification_test` repeats a part of each case for every bead boundary, and fails beyond the limits of "
    "mean ± standard deviation.\n";

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{
      {"array-drag", measure_array_drag, array_drag_law, {.error = 0.06, .spread = 0.04}},
      {"hydrodynamic-radius",
       measure_hydrodynamic_radius,
       hydrodynamic_radius_law,
       {.error = 0.08, .spread = 0.05}},
      {"torque", measure_torque, torque_law, {.error = 0.06, .spread = 0.03}},
      {"collinear-spheres",
       measure_collinear_spheres,
       collinear_spheres_law,
       {.error = 0.06, .spread = 0.01}},
      {"sedimentation", measure_sedimentation, sedimentation_law, {.error = 0.03, .spread = 0.02}},
      {"oscillation", measure_oscillation, oscillation_law, {.error = 0.04, .spread = 0.01}},
      {"galilean-invariance", measure_galilean_invariance, galilean_invariance_law, {.error = 0.002}},
      {"conservation", measure_conservation, conservation_law, {.error = 1e-12}},
      {"near-contact", measure_near_contact, near_contact_law, {.error = 0.08, .spread = 0.1}},
  };
  return cases;
}

std::string verification_page(const std::vector<Json>& records) {
  std::string text = introduction;
  for (const Case& one : all_cases()) {
    const std::vector<Json> of_case = where(records, {{"case", one.name}});
    if (of_case.empty()) continue;
    const Law law = one.law();
    text += "\n## " + law.title + "\n\n" + test_table(one, law) + "\n" + measured_table(law, of_case);
  }
  return text;
}

}  // namespace beadswim::verification
