#include "beadswim/figure/swimmer_sketch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <regex>

namespace beadswim {
namespace {

using testing::HasSubstr;

SwimmerSketch sketch() {
  return {.title = "swimmer",
          .radii = {4, 4, 4},
          .rest_lengths = {20, 20},
          .radius_labels = {"r1", "r2", "r3"},
          .force_labels = {"f1", "f2", "f3"},
          .length_labels = {"l1", "l2"},
          .spring_labels = {"k1", "k2"}};
}

struct Segment {
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
};

/// Returns the lines of this colour in the order in which the document draws them.
std::vector<Segment> lines(const std::string& svg, const std::string& colour) {
  const std::regex line(R"re(<line x1="([\d.]+)" y1="([\d.]+)" x2="([\d.]+)" y2="([\d.]+)" stroke=")re" +
                        colour);
  std::vector<Segment> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), line), end; at != end; ++at)
    found.push_back({std::stod((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3]), std::stod((*at)[4])});
  return found;
}

const std::string force_colour = "#D55E00";

TEST(SwimmerSketch, AllLabelsAreWritten) {
  const std::string svg = draw(sketch()).svg;
  for (const char* label : {"r1", "r2", "r3", "f1", "f2", "f3", "l1", "l2", "k1", "k2"})
    EXPECT_THAT(svg, HasSubstr(">" + std::string(label) + "<"));
}

// The sum of the forces is zero, so that the one on the middle bead must point the other way.
TEST(SwimmerSketch, MiddleForcePointsTheOtherWay) {
  const auto forces = lines(draw(sketch()).svg, force_colour);
  ASSERT_EQ(forces.size(), 3U);
  EXPECT_GT(forces[0].x2, forces[0].x1);
  EXPECT_LT(forces[1].x2, forces[1].x1);
  EXPECT_GT(forces[2].x2, forces[2].x1);
}

TEST(SwimmerSketch, ForcesStandAtTheirAngleToTheAxis) {
  SwimmerSketch turned = sketch();
  turned.force_angle = std::numbers::pi / 2;
  const auto forces = lines(draw(turned).svg, force_colour);
  ASSERT_EQ(forces.size(), 3U);
  EXPECT_NEAR(forces[0].x1, forces[0].x2, 0.01);
  EXPECT_LT(forces[0].y2, forces[0].y1);  // up, as y of a page goes down
}

TEST(SwimmerSketch, DashpotsAreDrawnWhereTheyAreLabelled) {
  SwimmerSketch damped = sketch();
  const auto polylines = [](const std::string& svg) {
    const std::regex polyline("<polyline");
    return std::distance(std::sregex_iterator(svg.begin(), svg.end(), polyline), std::sregex_iterator());
  };
  EXPECT_EQ(polylines(draw(damped).svg), 2);
  damped.dashpot_labels[1] = "c2";
  EXPECT_EQ(polylines(draw(damped).svg), 3);
  EXPECT_THAT(draw(damped).svg, HasSubstr(">c2<"));
}

// Over the beads a label could not be read.
TEST(SwimmerSketch, LabelsWithoutRoomBetweenBeadsStandBelowTheLengths) {
  const auto height_of = [](const std::string& svg, const std::string& label) {
    const std::size_t start = svg.rfind(" y=\"", svg.find(">" + label + "<"));
    return std::stod(svg.substr(start + 4));
  };
  SwimmerSketch close = sketch();
  EXPECT_LT(height_of(draw(close).svg, "k1"), height_of(draw(close).svg, "l1"));
  close.rest_lengths = {8.5, 8.5};
  const std::string svg = draw(close).svg;
  EXPECT_GT(height_of(svg, "k1"), height_of(svg, "l1"));
}

}  // namespace
}  // namespace beadswim
