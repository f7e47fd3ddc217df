#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "beadswim/compare/figure.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;
using testing::Not;

Figure figure_with(std::vector<double> x, std::vector<double> y) {
  return {"Speed & <stroke>",
          {{{"T"}, {"v", "um/s"}, {{"lbm \"run\"", std::move(x), std::move(y)}}}},
          {"l/λ = 5"}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Figure, SameFigureGivesTheSameBytes) {
  EXPECT_EQ(figure_to_svg(figure_with({1, 2}, {0.1, 0.3})), figure_to_svg(figure_with({1, 2}, {0.1, 0.3})));
}

TEST(Figure, TextIsEscaped) {
  const std::string svg = figure_to_svg(figure_with({1}, {2}));
  EXPECT_THAT(svg, HasSubstr("Speed &amp; &lt;stroke&gt;"));
  EXPECT_THAT(svg, HasSubstr("lbm &quot;run&quot;"));
  EXPECT_THAT(svg, HasSubstr("l/λ = 5"));
}

TEST(Figure, EveryFinitePointIsDrawnOnceAndOnceInTheLegend) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = figure_to_svg(figure_with({1, 2, 3}, {0.1, nan, 0.3}));
  EXPECT_EQ(count(svg, "<circle"), 3U);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Figure, SmallNumbersLeaveTheirPowerOfTenToTheUnit) {
  EXPECT_THAT(figure_to_svg(figure_with({1, 2}, {6e-5, 7e-5})), HasSubstr(">v (10⁻⁵ um/s)<"));
  EXPECT_THAT(figure_to_svg(figure_with({1, 2}, {6, 7})), HasSubstr(">v (um/s)<"));
}

TEST(Figure, RefusesAPanelWithoutPoints) {
  EXPECT_THROW(figure_to_svg(figure_with({}, {})), InputError);
}

TEST(Figure, GreaterValuesAreHigherOnThePage) {
  Figure figure = figure_with({1, 1}, {0, 1});
  figure.panels[0].series[0].mark = Mark::points;
  const std::string svg = figure_to_svg(figure);
  const auto y_of = [&svg](std::size_t from) { return std::stod(svg.substr(svg.find("cy=\"", from) + 4)); };
  const std::size_t first = svg.find("<circle");
  EXPECT_GT(y_of(first), y_of(svg.find("<circle", first + 1)));
}

}  // namespace
}  // namespace beadswim
