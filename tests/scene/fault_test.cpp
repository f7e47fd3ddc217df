#include "beadswim/scene/fault.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

// Catches a report that depends on the order in which ranks or beads are visited.
TEST(Faults, OfTheFirstStepKindAndBeadIsReported) {
  const std::array<Fault, 5> sorted{{{.kind = FaultKind::torn_arm, .step = 3, .bead = {7, 0}},
                                     {.kind = FaultKind::speed, .step = 4, .bead = {7, 1}},
                                     {.kind = FaultKind::torn_arm, .step = 4, .bead = {2, 1}},
                                     {.kind = FaultKind::torn_arm, .step = 4, .bead = {7, 0}, .value = 3},
                                     {.kind = FaultKind::torn_arm, .step = 4, .bead = {7, 0}, .value = 2}}};
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    std::optional<Fault> kept;
    for (std::size_t n = sorted.size(); n-- > first;) keep_first(kept, sorted[n]);
    for (std::size_t n = first; n < sorted.size(); ++n) keep_first(kept, sorted[n]);
    EXPECT_FALSE(comes_before(sorted[first], *kept) || comes_before(*kept, sorted[first])) << first;
  }
}

// An arm may reach twice its rest length. Catches the limit of another arm, and numbers that are none.
TEST(Faults, OfATornArmNameItsBeads) {
  const SwimmerType type = paper_single().types.begin()->second;
  const double rest = type.bonds[1].rest_length;
  const auto torn_at = [&](double length) {
    return torn_arm(type, 5,
                    [&](int b) { return b == 2 ? Vec3(length, 0, 0) : Vec3(-rest * (1 - b), 0, 0); });
  };
  EXPECT_FALSE(torn_at(1.99 * rest));
  const std::optional<Fault> torn = torn_at(2.5 * rest);
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->bead, (BeadName{5, 1}));
  EXPECT_EQ(torn->other, (BeadName{5, 2}));
  EXPECT_NEAR(torn->value, 2.5, 1e-12);
  EXPECT_TRUE(torn_at(NAN));
}

}  // namespace
}  // namespace beadswim
