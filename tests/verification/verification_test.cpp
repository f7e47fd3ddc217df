#include <gtest/gtest.h>

#include <map>

#include "cases.hpp"
#include "records.hpp"
#include "references.hpp"
#include "schemes.hpp"

// The brief part of each case, so that docs/verification.md cannot rot: the whole is in docs/results.

namespace beadswim::verification {
namespace {

std::vector<Json> records_of(const std::string& name, BeadScheme scheme) {
  std::vector<Json> records;
  for (const Case& one : all_cases()) {
    if (one.name != name) continue;
    one.measure(scheme, Extent::brief, [&](const Json& r) { records.push_back(r); });
  }
  return records;
}

/// Greatest errors of a case in its brief part, of any scheme: twice what the staircase and cli have.
struct Bound {
  std::string name;
  double error, spread;
};

class Verified : public testing::TestWithParam<std::tuple<Bound, BeadScheme>> {};

TEST_P(Verified, StaysWithinItsBounds) {
  const auto& [bound, scheme] = GetParam();
  const std::vector<Json> records = records_of(bound.name, scheme);
  ASSERT_FALSE(records.empty());
  for (const Json& r : records) {
    EXPECT_LT(std::abs(r["error"].get<double>()), bound.error) << r;
    if (r.contains("spread")) {
      EXPECT_LT(r["spread"].get<double>(), bound.spread) << r;
    }
  }
  EXPECT_NE(verification_page(records).find(name_of(scheme)), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    BeadsInFluid, Verified,
    testing::Combine(testing::Values(Bound{"array-drag", 0.06, 0.04}, Bound{"torque", 0.06, 0.03},
                                     Bound{"collinear-spheres", 0.06, 0.01},
                                     Bound{"sedimentation", 0.03, 0.02}, Bound{"oscillation", 0.04, 0.01},
                                     Bound{"galilean-invariance", 0.002, 0}, Bound{"conservation", 1e-12, 0}),
                     testing::ValuesIn(all_schemes)),
    [](const auto& info) {
      std::string name = std::get<0>(info.param).name + "_" + name_of(std::get<1>(info.param));
      std::ranges::replace(name, '-', '_');
      return name;
    });

// Catches a coefficient with a wrong digit: two independent sources, and Hasimoto's series where it holds.
TEST(CubicArrayDrag, AgreesWithZickAndHomsyAndHasimoto) {
  constexpr double printed_digits = 2e-4;
  for (const PrintedDrag& printed : zick_homsy)
    EXPECT_NEAR(cubic_array_drag(printed.phi) / printed.drag, 1, printed_digits + 5e-4 / printed.drag);
  EXPECT_NEAR(cubic_array_drag(1e-3) / dilute_array_drag(1e-3), 1, 1e-5);
}

// The page is what the program makes of the stored records.
TEST(VerificationPage, IsMadeOfTheStoredRecords) {
  const std::string docs = BEADSWIM_DOCS;
  std::vector<Json> records;
  std::istringstream lines(read_text(docs + "/results/verification.jsonl"));
  for (std::string line; std::getline(lines, line);)
    records.push_back(parse_json(line, "verification.jsonl"));
  EXPECT_EQ(verification_page(records), read_text(docs + "/verification.md"));
}

}  // namespace
}  // namespace beadswim::verification
