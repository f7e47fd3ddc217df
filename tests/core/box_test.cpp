#include "beadswim/core/box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace beadswim {
namespace {

const Box channel{.lengths = {8, 5, 30},
                  .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::no_slip}};

// Catches a position that is wrapped at a wall, and one that is truncated toward zero.
TEST(Box, WrapsPeriodicCoordinatesAlone) {
  EXPECT_EQ(image_number({-1, -1, 95}, channel), Vec3(-1, 0, 0));
  EXPECT_EQ(wrapped({-1, -1, 95}, channel), Vec3(7, -1, 95));
  EXPECT_EQ(wrapped({17, 6, 3}, channel), Vec3(1, 6, 3));
  EXPECT_EQ(wrapped({17, 6, 3}, std::nullopt), Vec3(17, 6, 3));
}

// Catches coordinates that rounding puts on the upper end of the box, or below its lower end.
TEST(Box, WrapsCoordinatesIntoTheHalfOpenBox) {
  for (const double length : {6.0, 0.1, 1e-3 / 3, 49.0, 1e150}) {
    const Box box{.lengths = Vec3::Constant(length), .boundary = {}};
    for (const double multiple : {-3.0, -1.0, 0.0, 1.0, 7.0, 1e6}) {
      const double end = multiple * length;
      for (const double x :
           {end, std::nextafter(end, -HUGE_VAL), std::nextafter(end, HUGE_VAL), end - 1e-25 * length}) {
        const double inside = wrapped({x, 0, 0}, box)[0], image = image_number({x, 0, 0}, box)[0];
        EXPECT_GE(inside, 0) << x << " in " << length;
        EXPECT_LT(inside, length) << x << " in " << length;
        EXPECT_NEAR(inside + image * length, x, 1e-15 * std::max(length, std::abs(x)));
      }
    }
  }
}

// Catches a separation that is taken through a wall.
TEST(Box, SeparationIsToTheNearestPeriodicImage) {
  EXPECT_EQ(nearest_separation({1, 0, 1}, {7, 5, 29}, channel), Vec3(-2, 5, 28));
  EXPECT_EQ(nearest_separation({1, 0, 1}, {7, 5, 29}, std::nullopt), Vec3(6, 5, 28));
}

// Catches a mirror at the wrong end of the box, or along a periodic axis.
TEST(Box, FreeSlipWallsAreMirrors) {
  std::vector<Vec3> vectors{{1, 2, 3}};
  add_mirror_images(channel, vectors);
  EXPECT_EQ(vectors, (std::vector<Vec3>{{1, 2, 3}, {1, -2, 3}}));
  EXPECT_EQ(mirrored_lengths(channel), Vec3(8, 10, 30));
  EXPECT_EQ(mirrored_lengths(std::nullopt), Vec3::Zero());
}

}  // namespace
}  // namespace beadswim
