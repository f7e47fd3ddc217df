#include "beadswim/compare/diffusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "beadswim/core/keyed_random.hpp"

namespace beadswim {
namespace {

/// Returns the path of a swimmer with the speed v along its axis, whose place and axis diffuse.
SwimmerPath random_path(std::uint64_t seed, int intervals, double v, double diffusion, double rotation) {
  KeyedRandom random(seed, 0, 0);
  SwimmerPath path;
  Vec3 place = Vec3::Zero(), axis = Vec3::UnitX();
  constexpr int parts = 10;
  for (int n = 0; n <= intervals * parts; ++n) {
    if (n % parts == 0) {
      path.places.push_back(place);
      path.axes.push_back(axis);
    }
    const double h = 1.0 / parts;
    const Vec3 before = axis;
    axis = (axis + std::sqrt(2 * rotation * h) * random.normal3().cross(axis)).normalized();
    place += h * v * (before + axis) / 2 + std::sqrt(2 * diffusion * h) * random.normal3();
  }
  return path;
}

// D = D_0 + v^2/(6 D_r) for windows longer than the persistence time. Stated errors hold in 95 of 100 runs.
TEST(Diffusion, IsThatOfARandomWalkWithItsError) {
  constexpr double v = 0.3, D = 0.05, Dr = 0.05;
  int right_diffusion = 0, right_rotation = 0, right_velocity = 0;
  constexpr int runs = 300;
  for (int run = 0; run < runs; ++run) {
    std::vector<SwimmerPath> paths;
    for (int s = 0; s < 4; ++s) paths.push_back(random_path(4 * run + s + 1, 2000, v, D, Dr));
    const DiffusionStatistics found = diffusion_statistics(paths, 1);
    ASSERT_TRUE(found.lag && found.mean_velocity && found.rotational_diffusion && found.persistence_time);
    // Ballistic start of a window: factor 1 - (1 - exp(-2 Dr tau))/(2 Dr tau).
    const double x = 2 * Dr * *found.lag, effective = D + v * v / (6 * Dr) * (1 - (1 - std::exp(-x)) / x);
    const auto within = [](const MeanAndError<double>& mean, double exact) {
      return std::abs(mean.mean - exact) < 2 * mean.standard_error;
    };
    right_diffusion += within(*found.effective_diffusion, effective);
    right_rotation += within(*found.rotational_diffusion, Dr);
    right_velocity += std::abs(found.mean_velocity->mean[1]) < 2 * found.mean_velocity->standard_error[1];
    EXPECT_LT(found.rotational_diffusion->standard_error, 0.1 * Dr);
  }
  EXPECT_GT(right_diffusion, 0.9 * runs);
  EXPECT_GT(right_rotation, 0.9 * runs);
  EXPECT_GT(right_velocity, 0.9 * runs);
}

TEST(Diffusion, NeedsTenWindowsAndMeanVelocityTwo) {
  const auto of = [](int intervals) {
    return diffusion_statistics(std::vector<SwimmerPath>{random_path(1, intervals, 0, 1, 0.1)}, 1);
  };
  EXPECT_FALSE(of(1).mean_velocity);
  ASSERT_TRUE(of(2).mean_velocity && of(9).mean_velocity && of(10).mean_velocity);
  EXPECT_FALSE(of(9).effective_diffusion);
  EXPECT_TRUE(of(10).effective_diffusion);
  EXPECT_FALSE(diffusion_statistics({}, 1).mean_velocity);
}

}  // namespace
}  // namespace beadswim
