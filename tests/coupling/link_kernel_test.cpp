#include "bead_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

namespace beadswim {
namespace {

LinkBatch random_batch(int links, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-7, 7), deviation(-0.02, 0.02);
  std::uniform_int_distribution<int> direction(-1, 1);
  LinkBatch batch{};
  batch.links = links;
  std::fill_n(batch.cx, LinkBatch::max_links, 1.0);
  for (int k = 0; k < links; ++k) {
    batch.x[k] = place(random), batch.y[k] = place(random), batch.z[k] = place(random);
    batch.cx[k] = k % 2 == 0 ? 1 : -1, batch.cy[k] = direction(random), batch.cz[k] = direction(random);
    batch.weight[k] = k % 3 == 0 ? 1.0 / 18 : 1.0 / 36;
    batch.outgoing[k] = deviation(random), batch.behind[k] = deviation(random);
    batch.arrived[k] = deviation(random), batch.two_behind[k] = deviation(random);
    batch.arrived_behind[k] = deviation(random), batch.speed[k] = deviation(random);
    batch.fluid_behind[k] = k % 3;
  }
  return batch;
}

constexpr KernelBead bead{.velocity = {0.01, -0.02, 0.003},
                          .angular_velocity = {0.001, 0.0005, -0.002},
                          .mass_source = 1e-4,
                          .radius = 6.5,
                          .slip = 0.4};

/// Returns the link kernels for all instruction sets that this processor supports.
std::vector<BeadKernels> kernels() {
  std::vector<BeadKernels> kernels{BeadKernels::baseline};
#ifdef BEADSWIM_ALL_INSTRUCTION_SETS
  if (__builtin_cpu_supports("x86-64-v3")) kernels.push_back(BeadKernels::x86_64_v3);
  if (__builtin_cpu_supports("x86-64-v4")) kernels.push_back(BeadKernels::x86_64_v4);
#endif
  return kernels;
}

template <BeadScheme scheme, class Real>
struct Kernel {
  static bool reflect(const BeadKernels& kernels, LinkBatch& batch, const KernelBead& bead, LinkSums& sums) {
    return kernels.reflect<Real>(scheme, batch, bead, sums);
  }
  using Number = Real;
};

template <class Kernel>
class LinkKernelsOf : public testing::Test {};
using AllKernels = testing::Types<Kernel<BeadScheme::staircase, double>, Kernel<BeadScheme::staircase, float>,
                                  Kernel<BeadScheme::cli, double>, Kernel<BeadScheme::cli, float>,
                                  Kernel<BeadScheme::mr, double>, Kernel<BeadScheme::mr, float>>;
TYPED_TEST_SUITE(LinkKernelsOf, AllKernels);

// Catches a lane that is left out or counted twice, a fused multiply-add, and sums that depend on the lanes:
// the sums are those of the terms one by one.
TYPED_TEST(LinkKernelsOf, GiveTheSameBitsOnEveryInstructionSetAndLinkByLink) {
  for (const int links : {1, 7, 8, 9, 30, LinkBatch::max_links}) {
    LinkBatch expected = random_batch(links, links);
    LinkSums expected_sums;
    ASSERT_TRUE(TypeParam::reflect(kernels().front(), expected, bead, expected_sums));
    std::array<OrderFreeSum, link_terms> one_by_one;
    for (int t = 0; t < link_terms; ++t) {
      for (int k = 0; k < links; ++k) one_by_one[t].add(expected.terms[t][k]);
    }
    for (const BeadKernels& each : kernels()) {
      LinkBatch batch = random_batch(links, links);
      LinkSums sums;
      sums.reserve_terms(LinkBatch::max_links / LinkSums::lanes);
      ASSERT_TRUE(TypeParam::reflect(each, batch, bead, sums));
      const std::array<OrderFreeSum, link_terms> total = sums.take();
      for (int t = 0; t < link_terms; ++t) {
        EXPECT_EQ(total[t].coarse, one_by_one[t].coarse);
        EXPECT_EQ(total[t].fine, one_by_one[t].fine);
      }
      for (int k = 0; k < links; ++k) {
        EXPECT_EQ(batch.returned[k], expected.returned[k]);
        EXPECT_EQ(batch.returned[k],
                  static_cast<double>(static_cast<typename TypeParam::Number>(batch.returned[k])));
      }
    }
  }
}

// Catches a number that is not one, or is out of range, and slips into the sums.
TYPED_TEST(LinkKernelsOf, RefuseTermsThatDoNotFitAndAddNothing) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 2e3}) {
    for (const BeadKernels& each : kernels()) {
      LinkBatch batch = random_batch(20, 3);
      batch.outgoing[13] = bad;
      LinkSums sums;
      EXPECT_FALSE(TypeParam::reflect(each, batch, bead, sums));
      for (const OrderFreeSum& sum : sums.take()) EXPECT_EQ(sum.value(), 0);
    }
  }
}

}  // namespace
}  // namespace beadswim
