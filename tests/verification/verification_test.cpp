#include <gtest/gtest.h>

#include <map>

#include "array_drag.hpp"
#include "beadswim/coupling/bead_corrections.hpp"
#include "cases.hpp"
#include "records.hpp"
#include "references.hpp"

// Measures the brief extent of each case, to check that docs/verification.md is still valid.

namespace beadswim::verification {
namespace {

const std::string docs = BEADSWIM_DOCS;

std::vector<Json> stored_records() {
  std::vector<Json> records;
  std::istringstream lines(read_text(docs + "/results/verification.jsonl"));
  for (std::string line; std::getline(lines, line);)
    records.push_back(parse_json(line, "verification.jsonl"));
  return records;
}

std::vector<Json> brief_records(const Case& measured, BeadScheme scheme) {
  std::vector<Json> records;
  measured.measure(scheme, Extent::brief, [&](const Json& r) { records.push_back(r); });
  return records;
}

// The limits are about twice the errors of staircase and cli.
class Verified : public testing::TestWithParam<std::tuple<Case, BeadScheme>> {};

TEST_P(Verified, StaysWithinItsLimits) {
  const auto& [measured, scheme] = GetParam();
  const std::vector<Json> records = brief_records(measured, scheme);
  ASSERT_FALSE(records.empty());
  for (const Json& r : records) {
    EXPECT_LT(std::abs(r["error"].get<double>()), measured.limits.error) << r;
    if (r.contains("spread")) {
      EXPECT_LT(r["spread"].get<double>(), measured.limits.spread) << r;
    }
  }
  EXPECT_NE(verification_page(records).find(to_text(scheme)), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(BeadsInFluid, Verified,
                         testing::Combine(testing::ValuesIn(all_cases()),
                                          testing::ValuesIn(all_values<BeadScheme>)),
                         [](const auto& info) {
                           std::string name =
                               std::get<0>(info.param).name + "_" + to_text(std::get<1>(info.param));
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

class RadiusCorrection : public testing::TestWithParam<BeadScheme> {};
INSTANTIATE_TEST_SUITE_P(Schemes, RadiusCorrection, testing::ValuesIn(all_values<BeadScheme>),
                         [](const auto& info) { return to_text(info.param); });

// In an array more dilute than that of the calibration, at a radius between those of its table. Catches a
// correction with the wrong sign, scheme or unit: without any, cli's drag is off by 6 %.
TEST_P(RadiusCorrection, BringsTheDragToThatOfTheRadius) {
  constexpr double radius = 2.1;
  constexpr int edge = 11, places = 8;
  const double corrected = corrected_radius(GetParam(), radius);
  double drag = 0;
  for (const Vec3& place : random_places(places))
    drag += array_drag({.phi = 0, .edge = edge, .radius = corrected}, place, 1.2, GetParam()) / places;
  const double phi = 4.0 / 3 * std::numbers::pi * std::pow(radius / edge, 3);
  // What is left is the scatter over places, of the mean of eight, twice; and what it differs by with phi.
  const double bound =
      GetParam() == BeadScheme::staircase ? 0.05 : (GetParam() == BeadScheme::cli ? 0.02 : 0.01);
  EXPECT_NEAR(corrected * drag / (radius * cubic_array_drag(phi)), 1, bound);
}

TEST(RadiusCorrection, GrowsWithTheRadiusAndIsConstantBeyondTheTable) {
  for (const BeadScheme scheme : all_values<BeadScheme>) {
    for (double radius = 1.1; radius < 30; radius += 0.37) {
      EXPECT_GT(corrected_radius(scheme, radius + 0.37), corrected_radius(scheme, radius));
    }
    const auto excess = [&](double radius) { return radius - corrected_radius(scheme, radius); };
    EXPECT_NEAR(excess(1.2), excess(1.4), 1e-12);
    EXPECT_NEAR(excess(25), excess(12.5), 1e-12);
  }
}

// The calibration is the stored measurement.
TEST(RadiusCorrection, IsThatOfTheStoredRecords) {
  int compared = 0;
  for (const Json& record : stored_records()) {
    if (record["case"] != "hydrodynamic-radius") continue;
    const BeadScheme scheme = from_text<BeadScheme>(record["scheme"].get<std::string>());
    constexpr double last_digit = 1e-4;
    const double radius = record["radius"], excess = record["excess"];
    EXPECT_NEAR(corrected_radius(scheme, radius + excess), radius, 0.61 * last_digit) << record;
    ++compared;
  }
  EXPECT_GT(compared, 60);
}

// Catches a page that was edited by hand, or not generated again after the records changed.
TEST(VerificationPage, IsMadeOfTheStoredRecords) {
  EXPECT_EQ(verification_page(stored_records()), read_text(docs + "/verification.md"));
}

// Catches a row whose values select no record of some scheme, or several.
TEST(VerificationPage, HasOneRecordPerRowAndScheme) {
  for (const Case& measured : all_cases()) {
    const std::vector<Json> records = where(stored_records(), {{"case", measured.name}});
    for (const Row& row : measured.law().rows) {
      for (const std::string& scheme : all_names<BeadScheme>()) {
        const std::vector<Json> found = where(where(records, row.values), {{"scheme", scheme}});
        EXPECT_EQ(found.size(), 1u) << measured.name << ", " << row.conditions << ", " << scheme;
      }
    }
  }
}

}  // namespace
}  // namespace beadswim::verification
