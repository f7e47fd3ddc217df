#include "beadswim/figure/curves.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace beadswim {
namespace {

using testing::ElementsAre;
using testing::IsNan;

Curve curve_of(const std::vector<double>& y, std::vector<std::size_t> unusable = {}) {
  Curve curve{"theory"};
  for (const double value : y) curve.points.push_back({static_cast<double>(curve.points.size()), value});
  for (const std::size_t i : unusable) curve.points[i].usable = false;
  return curve;
}

TEST(Curves, HaveOneColourOrEachItsOwn) {
  Panel own, one;
  append_marks_and_curves({{"a", {{1, 2}}}, {"b", {{1, 3}}}}, {curve_of({1, 2})}, std::nullopt, own);
  append_marks_and_curves({{"a", {{1, 2}}}, {"b", {{1, 3}}}}, {curve_of({1, 2})}, 5, one);
  ASSERT_EQ(own.series.size(), 3U);
  for (int s = 0; s < 3; ++s) {
    EXPECT_EQ(own.series[static_cast<std::size_t>(s)].colour, s);
    EXPECT_EQ(one.series[static_cast<std::size_t>(s)].colour, 5);
  }
  EXPECT_NE(one.series[0].shape, one.series[1].shape);  // which alone tells groups of one colour apart
}

TEST(Curves, AreMarkedPointByPointWhereThereAreFew) {
  Panel panel;
  append_marks_and_curves({}, {curve_of({1, 2}), curve_of(std::vector<double>(13, 1))}, std::nullopt, panel);
  EXPECT_EQ(panel.series[0].mark, Mark::line_and_points);
  EXPECT_EQ(panel.series[1].mark, Mark::line);
}

// The faint line must reach the usable neighbours, or the curve would have gaps.
TEST(Curves, UnusablePointsAreFaintAndJoinTheUsable) {
  Panel panel;
  append_marks_and_curves({}, {curve_of({1, 2, 3, 4}, {2})}, std::nullopt, panel);
  ASSERT_EQ(panel.series.size(), 3U);
  EXPECT_EQ(panel.series[0].emphasis, Emphasis::faint);
  EXPECT_THAT(panel.series[0].y, ElementsAre(IsNan(), 2, 3, 4));
  EXPECT_EQ(panel.series[1].emphasis, Emphasis::plain);
  EXPECT_THAT(panel.series[1].y, ElementsAre(1, 2, IsNan(), 4));
  EXPECT_THAT(panel.series[2].y, ElementsAre(IsNan(), IsNan(), 3, IsNan()));
}

// Readers that group the numbers by series must not join both parts; each point is written once.
TEST(Curves, UnusablePointsAreASeriesOfTheirOwnInTheNumbers) {
  Curve curve = curve_of({1, 2, 3, 4}, {2});
  curve.points[1].error = 0.5;
  Figure figure{.title = "", .panels = {Panel{.x_label = {"x"}, .y_label = {"y"}}}};
  append_marks_and_curves({}, {curve}, std::nullopt, figure.panels[0]);
  EXPECT_EQ(draw(figure).csv,
            "y_name,y_unit,x_name,x_unit,series,x,y,y_error\n"
            "\"y\",\"\",\"x\",\"\",\"theory\",0,1,\n"
            "\"y\",\"\",\"x\",\"\",\"theory\",1,2,0.5\n"
            "\"y\",\"\",\"x\",\"\",\"theory\",3,4,\n"
            "\"y\",\"\",\"x\",\"\",\"theory (not usable)\",2,3,\n");
}

TEST(Curves, LevelsReachFromEndToEndAndDifferInDashes) {
  Panel panel;
  append_levels({{"a", {{0, 3}}}, {"b", {{0, 4}}}}, 0.6, 2.4, 1, panel);
  EXPECT_THAT(panel.series[1].x, ElementsAre(0.6, 2.4));
  EXPECT_THAT(panel.series[1].y, ElementsAre(4, 4));
  EXPECT_NE(panel.series[0].dash, panel.series[1].dash);
}

TEST(Axes, AreLogarithmicOverTwoDecadesOfPlainPositiveValues) {
  const auto scale_of = [](std::vector<double> y, Axes axes) {
    Panel panel{.x_label = {"x"}, .y_label = {"y"}, .series = {{.label = "s", .y = std::move(y)}}};
    set_axes(axes, Axes::log_y, panel);
    return panel.y_scale;
  };
  EXPECT_EQ(scale_of({1, 101}, Axes::automatic), ScaleKind::logarithmic);
  EXPECT_EQ(scale_of({1, 99}, Axes::automatic), ScaleKind::linear);
  EXPECT_EQ(scale_of({-1, 101}, Axes::automatic), ScaleKind::linear);
  EXPECT_EQ(scale_of({1, 101}, Axes::linear), ScaleKind::linear);
  EXPECT_EQ(scale_of({-1, 1}, Axes::log_y), ScaleKind::logarithmic);
}

TEST(Axes, SayWhetherValuesAreLeftOut) {
  Panel panel{.x_label = {"x"}, .y_label = {"y"}, .series = {{.label = "s", .y = {-1, 1}}}};
  EXPECT_FALSE(has_omitted_values(panel));
  set_axes(Axes::log_log, Axes::log_y, panel);
  EXPECT_EQ(panel.x_scale, ScaleKind::logarithmic);
  EXPECT_TRUE(has_omitted_values(panel));
}

}  // namespace
}  // namespace beadswim
