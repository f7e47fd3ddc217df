#include "link_kernel.hpp"

#include <gtest/gtest.h>

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
  for (int k = 0; k < links; ++k) {
    batch.x[k] = place(random), batch.y[k] = place(random), batch.z[k] = place(random);
    batch.cx[k] = direction(random), batch.cy[k] = direction(random), batch.cz[k] = direction(random);
    batch.weight[k] = k % 3 == 0 ? 1.0 / 18 : 1.0 / 36;
    batch.outgoing[k] = deviation(random);
  }
  return batch;
}

constexpr LinkBead bead{
    .velocity = {0.01, -0.02, 0.003}, .angular_velocity = {0.001, 0.0005, -0.002}, .mass_source = 1e-4};

/// The kernels that this processor can run.
std::vector<LinkKernels> kernels() {
  std::vector<LinkKernels> kernels{{baseline::reflect_fp64, baseline::reflect_fp32}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v3"))
    kernels.push_back({x86_64_v3::reflect_fp64, x86_64_v3::reflect_fp32});
  if (__builtin_cpu_supports("x86-64-v4"))
    kernels.push_back({x86_64_v4::reflect_fp64, x86_64_v4::reflect_fp32});
#endif
  return kernels;
}

template <class Real>
class LinkKernelsOf : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(LinkKernelsOf, Reals);

// Catches a lane that is left out or counted twice, a fused multiply-add, and sums that depend on the lanes:
// the sums are those of the terms one by one.
TYPED_TEST(LinkKernelsOf, GiveTheSameBitsOnEveryInstructionSetAndLinkByLink) {
  for (const int links : {1, 7, 8, 9, 30, LinkBatch::most}) {
    LinkBatch expected = random_batch(links, links);
    LinkSums expected_sums;
    ASSERT_TRUE(kernels().front().template reflect<TypeParam>(expected, bead, expected_sums));
    std::array<OrderFreeSum, link_terms> one_by_one;
    for (int t = 0; t < link_terms; ++t) {
      for (int k = 0; k < links; ++k) one_by_one[t].add(expected.terms[t][k]);
    }
    for (const LinkKernels& each : kernels()) {
      LinkBatch batch = random_batch(links, links);
      LinkSums sums;
      sums.make_room(LinkBatch::most / LinkSums::lanes);
      ASSERT_TRUE(each.template reflect<TypeParam>(batch, bead, sums));
      const std::array<OrderFreeSum, link_terms> total = sums.take();
      for (int t = 0; t < link_terms; ++t) {
        EXPECT_EQ(total[t].coarse, one_by_one[t].coarse);
        EXPECT_EQ(total[t].fine, one_by_one[t].fine);
      }
      for (int k = 0; k < links; ++k) {
        EXPECT_EQ(batch.returned[k], expected.returned[k]);
        EXPECT_EQ(batch.returned[k], static_cast<double>(static_cast<TypeParam>(batch.returned[k])));
      }
    }
  }
}

// Catches a number that is not one, or is out of range, and slips into the sums.
TYPED_TEST(LinkKernelsOf, RefuseTermsThatDoNotFitAndAddNothing) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 2e3}) {
    for (const LinkKernels& each : kernels()) {
      LinkBatch batch = random_batch(20, 3);
      batch.outgoing[13] = bad;
      LinkSums sums;
      EXPECT_FALSE(each.template reflect<TypeParam>(batch, bead, sums));
      for (const OrderFreeSum& sum : sums.take()) EXPECT_EQ(sum.value(), 0);
    }
  }
}

}  // namespace
}  // namespace beadswim
