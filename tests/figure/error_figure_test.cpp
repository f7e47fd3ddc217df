#include "beadswim/figure/error_figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

QuantityErrors errors() {
  return {.quantity = "velocity",
          .series = {{"fine", {{"dear", "a.json", 100, 0.01}, {"worse", "b.json", 200, 0.02}}},
                     {"coarse", {{"cheap", "c.json", 10, 0.05}}}}};
}

TEST(ErrorFigure, FrontIsWhatNoOtherBeatsInErrorAndCost) {
  const Figure figure = error_figure({errors()}, "core-seconds", {{.text = "first"}});
  const Series& front = figure.panels.at(0).series.back();
  EXPECT_EQ(front.label, "front");
  EXPECT_THAT(front.x, ElementsAre(10, 100));
  EXPECT_THAT(front.y, ElementsAre(5, 1));  // percent
  EXPECT_THAT(shorten_notes(figure.notes),
              ElementsAre("first", HasSubstr("front"), "Most accurate velocity: dear."));
}

TEST(ErrorFigure, UncertaintyOfTheReferenceIsALevelInPercent) {
  QuantityErrors uncertain = errors();
  uncertain.uncertainty = 0.03;
  const Series level = error_figure({uncertain}, "core-seconds", {}).panels.at(0).series.back();
  EXPECT_THAT(level.x, ElementsAre(10, 200));
  EXPECT_THAT(level.y, ElementsAre(3, 3));
}

// An error of 1 % and one of 2 % are the same to a reference that is uncertain by 3 %; the cheaper one
// counts.
TEST(ErrorFigure, ErrorsBelowTheUncertaintyOfTheReferenceAreNotRanked) {
  QuantityErrors uncertain = errors();
  uncertain.uncertainty = 0.03;
  uncertain.series[0].points[1].cost = 50;  // 2 %
  const Figure figure = error_figure({uncertain}, "core-seconds", {});
  const Series& front = figure.panels.at(0).series.at(2);
  EXPECT_THAT(front.x, ElementsAre(10, 50));
  EXPECT_THAT(front.y, ElementsAre(5, 2));
  EXPECT_THAT(
      shorten_notes(figure.notes),
      ElementsAre(HasSubstr("front"), "Cheapest within the uncertainty of the reference, velocity: worse."));
}

TEST(ErrorFigure, SettingsLookAlikeInAllScenesAndHaveOneLegend) {
  QuantityErrors one = errors(), other = errors();
  one.scene = "1 swimmer";
  other.scene = "9 swimmers";
  other.series.erase(other.series.begin());  // only "coarse"
  const Figure figure = error_figure({one, other}, "core-seconds", {});
  EXPECT_EQ(figure.panels.at(0).series.at(1).label, figure.panels.at(1).series.at(0).label);
  EXPECT_EQ(figure.panels.at(0).series.at(1).colour, figure.panels.at(1).series.at(0).colour);
  const std::string svg = draw(figure).svg;
  for (const char* text : {">coarse<", ">front<", ">1 swimmer<", ">9 swimmers<"})
    EXPECT_TRUE(svg.find(text) != std::string::npos && svg.find(text) == svg.rfind(text)) << text;
  EXPECT_THAT(draw(figure).csv, HasSubstr("error of the velocity (9 swimmers)"));
}

TEST(ErrorFigure, LeavesOutAndCountsWhatNoLogarithmicAxisHolds) {
  QuantityErrors exact = errors();
  exact.series[0].points[1].error = 0;
  const Figure figure = error_figure({exact}, "core-seconds", {});
  EXPECT_THAT(figure.panels.at(0).series.at(0).x, ElementsAre(100));
  EXPECT_EQ(figure.notes.back().text, "Most accurate velocity: dear; not drawn for lack of an error: 1.");
}

TEST(ErrorFigure, RefusesWhatHasNoPointForLogarithmicAxes) {
  QuantityErrors exact = errors();
  exact.series.erase(exact.series.begin());
  exact.series[0].points[0].error = 0;
  try {
    error_figure({exact}, "core-seconds", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("c.json: the run has an error of 0 in the velocity"));
  }
}

}  // namespace
}  // namespace beadswim
