#include "beadswim/compare/swarm_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;

/// One along x, its middle bead there.
PicturedSwimmer swimmer_at(const Vec3& middle, int colour) {
  const Vec3 arm(20, 0, 0);
  return {.beads = {middle - arm, middle, middle + arm}, .radii = {4, 4, 4}, .colour = colour};
}

SwarmPicture picture_of(std::vector<PicturedSwimmer> swimmers) {
  return {.title = "swarm", .box = Vec3(120, 80, 60), .swimmers = std::move(swimmers)};
}

struct Disc {
  int colour = 0;
  double x = 0, y = 0, radius = 0;
};

/// In the order of drawing.
std::vector<Disc> discs(const std::string& svg) {
  static const std::regex circle(R"re(<circle class="b(\d)" cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)")re");
  std::vector<Disc> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at) {
    found.push_back({std::stoi((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3]), std::stod((*at)[4])});
  }
  return found;
}

std::vector<Disc> discs_of(const std::vector<PicturedSwimmer>& swimmers) {
  return discs(swarm_picture_to_svg(picture_of(swimmers)));
}

TEST(SwarmPicture, SamePictureGivesTheSameBytes) {
  const SwarmPicture picture = picture_of({swimmer_at({60, 40, 30}, 0), swimmer_at({60, 10, 30}, 1)});
  EXPECT_EQ(swarm_picture_to_svg(picture), swarm_picture_to_svg(picture));
}

TEST(SwarmPicture, XIsToTheRightAndZUp) {
  const auto row = discs_of({swimmer_at({60, 40, 30}, 0)});
  ASSERT_EQ(row.size(), 3U);
  EXPECT_LT(std::min(row[0].x, row[2].x), row[1].x);
  EXPECT_GT(std::max(row[0].x, row[2].x), row[1].x);
  const auto column = discs_of({swimmer_at({60, 40, 10}, 0), swimmer_at({60, 40, 50}, 1)});
  ASSERT_EQ(column.size(), 6U);
  for (const Disc& low : column) {
    for (const Disc& high : column) {
      if (low.colour == 0 && high.colour == 1) {
        EXPECT_GT(low.y, high.y);
      }
    }
  }
}

// The wrong order would show the swarm's far side in front.
TEST(SwarmPicture, NearBeadsAreDrawnLastAndLarger) {
  for (const bool near_first : {true, false}) {
    const PicturedSwimmer near = swimmer_at({60, 10, 30}, 0), far = swimmer_at({60, 70, 30}, 1);
    const auto all = near_first ? discs_of({near, far}) : discs_of({far, near});
    ASSERT_EQ(all.size(), 6U);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(all[i].colour, i < 3 ? 1 : 0);
    EXPECT_GT(all[5].radius, 1.1 * all[0].radius);
  }
}

TEST(SwarmPicture, ColoursWrapRound) {
  EXPECT_EQ(discs_of({swimmer_at({60, 40, 30}, 8)})[0].colour, 1);
}

// What sticks out of a periodic box belongs to the page too.
TEST(SwarmPicture, AllIsOnThePage) {
  const std::string svg = swarm_picture_to_svg(
      picture_of({swimmer_at({0, 0, 0}, 0), swimmer_at({120, 80, 60}, 1), swimmer_at({120, 0, 0}, 2)}));
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex(R"re(width="([\d.]+)" height="([\d.]+)")re")));
  for (const Disc& disc : discs(svg)) {
    EXPECT_GT(disc.x - disc.radius, 0);
    EXPECT_GT(disc.y - disc.radius, 0);
    EXPECT_LT(disc.x + disc.radius, std::stod(size[1]));
    EXPECT_LT(disc.y + disc.radius, std::stod(size[2]));
  }
}

TEST(SwarmPicture, KeysAndNotesAreWritten) {
  SwarmPicture picture = picture_of({swimmer_at({60, 40, 30}, 0)});
  picture.keys = {{"a & b", 0}, {"c", 1}};
  picture.notes = {"one box"};
  const std::string svg = swarm_picture_to_svg(picture);
  EXPECT_THAT(svg, HasSubstr(">a &amp; b<"));
  EXPECT_THAT(svg, HasSubstr(">one box<"));
  EXPECT_EQ(discs(svg).size(), 5U);
}

TEST(SwarmPicture, RefusesAnEmptySwarm) {
  EXPECT_THROW(swarm_picture_to_svg(picture_of({})), InputError);
}

}  // namespace
}  // namespace beadswim
