#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/figure/figure.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;
using testing::Not;

Figure figure_with(std::vector<double> x, std::vector<double> y) {
  return {"Speed & <stroke>",
          {{{"T"}, {"v", "um/s"}, {{"lbm \"run\"", std::move(x), std::move(y)}}}},
          {Note{.text = "l/λ = 5"}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Figure, SameFigureGivesTheSameBytes) {
  EXPECT_EQ(draw(figure_with({1, 2}, {0.1, 0.3})).svg, draw(figure_with({1, 2}, {0.1, 0.3})).svg);
}

TEST(Figure, TextIsEscaped) {
  const std::string svg = draw(figure_with({1}, {2})).svg;
  EXPECT_THAT(svg, HasSubstr("Speed &amp; &lt;stroke&gt;"));
  EXPECT_THAT(svg, HasSubstr("lbm &quot;run&quot;"));
  EXPECT_THAT(svg, HasSubstr("l/λ = 5"));
}

TEST(Figure, EveryFinitePointIsDrawnOnceAndOnceInTheLegend) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = draw(figure_with({1, 2, 3}, {0.1, nan, 0.3})).svg;
  EXPECT_EQ(count(svg, "<circle"), 3U);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(Figure, SmallNumbersLeaveTheirPowerOfTenToTheUnit) {
  EXPECT_THAT(draw(figure_with({1, 2}, {6e-5, 7e-5})).svg, HasSubstr(">v (10⁻⁵ um/s)<"));
  EXPECT_THAT(draw(figure_with({1, 2}, {6, 7})).svg, HasSubstr(">v (um/s)<"));
}

TEST(Figure, RefusesAPanelWithoutPoints) {
  EXPECT_THROW(draw(figure_with({}, {})), InputError);
}

TEST(Figure, GreaterValuesAreHigherOnThePage) {
  Figure figure = figure_with({1, 1}, {0, 1});
  figure.panels[0].series[0].mark = Mark::points;
  const std::string svg = draw(figure).svg;
  const auto y_of = [&svg](std::size_t from) { return std::stod(svg.substr(svg.find("cy=\"", from) + 4)); };
  const std::size_t first = svg.find("<circle");
  EXPECT_GT(y_of(first), y_of(svg.find("<circle", first + 1)));
}

/// Returns the values of an attribute, such as cx or cy, in the order of the SVG document.
std::vector<double> numbers(const std::string& svg, const std::string& attribute) {
  std::vector<double> found;
  const std::string start = attribute + "=\"";
  for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    found.push_back(std::stod(svg.substr(at + start.size())));
  }
  return found;
}

Figure figure_with_line(std::vector<double> y) {
  Figure figure = figure_with({}, std::move(y));
  Series& series = figure.panels[0].series[0];
  for (std::size_t i = 0; i < series.y.size(); ++i) series.x.push_back(static_cast<double>(i));
  series.mark = Mark::line;
  return figure;
}

constexpr std::size_t legend_line = 1;

TEST(Figure, ALineBreaksWhereAValueIsMissing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(count(draw(figure_with_line({1, 2, 3, 4, 5})).svg, "<polyline"), 1 + legend_line);
  EXPECT_EQ(count(draw(figure_with_line({1, 2, nan, 4, 5})).svg, "<polyline"), 2 + legend_line);
}

TEST(Figure, ALineBreaksWhereALogarithmicAxisHasNoPlace) {
  Figure figure = figure_with_line({1, 20, -30, 400, 5000});
  figure.panels[0].y_scale = ScaleKind::logarithmic;
  const std::string svg = draw(figure).svg;
  EXPECT_EQ(count(svg, "<polyline"), 2 + legend_line);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  figure.panels[0].series[0].y.assign(5, -1);
  EXPECT_THROW(draw(figure), InputError);
}

TEST(Figure, EqualRatiosAreEqualHeightsOnALogarithmicAxis) {
  Figure figure = figure_with({1, 2, 3}, {1, 100, 10000});
  figure.panels[0].y_scale = ScaleKind::logarithmic;
  const std::vector<double> heights = numbers(draw(figure).svg, "cy");
  constexpr double rounding = 0.011;  // coordinates have two decimals
  EXPECT_NEAR(heights[0] - heights[1], heights[1] - heights[2], rounding);
}

// A pole in a faint series must not squeeze the others, nor leave the frame.
TEST(Figure, FaintValuesDoNotMoveTheAxisAndStayInTheFrame) {
  Figure figure = figure_with_line({1, 2, 3, 2, 1});
  const std::string alone = draw(figure).svg;
  Series pole = figure.panels[0].series[0];
  pole.label.clear();
  pole.emphasis = Emphasis::faint;
  pole.y = {2, 1e6, -1e12, 1e300, 2};
  figure.panels[0].series.push_back(pole);
  const std::string with_pole = draw(figure).svg;
  const std::size_t line = alone.find("<polyline");
  EXPECT_THAT(with_pole, HasSubstr(alone.substr(line, alone.find("/>", line) - line)));
  // From the first point to the frame's edge, and back in to the last: nothing across the pole.
  EXPECT_EQ(count(with_pole, "<polyline"), 3 + legend_line);
  const std::string frame_top = ",52.00";
  EXPECT_EQ(count(with_pole, frame_top), 2U);
  EXPECT_THAT(with_pole, Not(HasSubstr("00000.00")));
}

TEST(Figure, ASeriesWithoutLabelHasNoLegend) {
  Figure figure = figure_with({1, 2}, {1, 2});
  figure.panels[0].series[0].label.clear();
  EXPECT_EQ(count(draw(figure).svg, "<circle"), 2U);
}

// The errors 0.2 make the y axis span from below 1 - 0.2 to above 2 + 0.2; bars and bands span twice the
// error.
TEST(Figure, ErrorsAreBarsAtPointsAndABandAlongALine) {
  Figure figure = figure_with({1, 2}, {1, 2});
  Series& series = figure.panels[0].series[0];
  const std::string without = draw(figure).svg;
  series.errors = {0.2, 0.2};
  const std::string bars = draw(figure).svg;
  EXPECT_EQ(count(bars, "stroke-width=\"1.1"), count(without, "stroke-width=\"1.1") + 2);
  EXPECT_EQ(count(bars, "<polygon"), 0U);
  series.mark = Mark::line;
  const std::string band = draw(figure).svg;
  EXPECT_EQ(count(band, "<polygon"), 1U);
  series.y[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(count(draw(figure).svg, "<polygon"), 0U);  // one point has no band
}

TEST(Figure, AnErrorBelowALogarithmicAxisEndsAtItsLowerEdge) {
  Figure figure = figure_with({1, 2}, {1, 10});
  figure.panels[0].y_scale = ScaleKind::logarithmic;
  figure.panels[0].series[0].errors = {2, 1};
  const std::string svg = draw(figure).svg;
  EXPECT_EQ(count(svg, "stroke-width=\"1.1"), 2U);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(Figure, ItsNumbersAreLinesOfValues) {
  Figure figure = figure_with({1, 2, 3}, {0.1, std::numeric_limits<double>::quiet_NaN(), 0.25});
  EXPECT_EQ(draw(figure).csv,
            "y_name,y_unit,x_name,x_unit,series,x,y,y_error\n"
            "\"v\",\"um/s\",\"T\",\"\",\"lbm \"\"run\"\"\",1,0.1,\n"
            "\"v\",\"um/s\",\"T\",\"\",\"lbm \"\"run\"\"\",3,0.25,\n");
  figure.panels[0].series[0].errors = {0.01, 0, 0.02};
  EXPECT_THAT(draw(figure).csv, HasSubstr(",3,0.25,0.02\n"));
}

Figure small_map() {
  Panel panel{.x_label = {"stiffness"}, .y_label = {"phase", "rad"}};
  panel.cells = {{.x = 1, .y = 2, .value = 10, .x_low = 0.5, .x_high = 1.5, .y_low = 1.5, .y_high = 2.5},
                 {.x = 2, .y = 2, .value = 30, .x_low = 1.5, .x_high = 2.5, .y_low = 1.5, .y_high = 2.5},
                 {.x = 2, .y = 3, .value = 20, .x_low = 1.5, .x_high = 2.5, .y_low = 2.5, .y_high = 3.5}};
  panel.value_label = {"velocity", "um/s"};
  return {.title = "Map", .panels = {panel}};
}

// The least value has the first colour of the map, the greatest the last, the mean of both the middle one.
TEST(Map, ColoursGoFromTheLeastToTheGreatestValue) {
  const std::string svg = draw(small_map()).svg;
  for (const char* colour : {"#440154", "#fde725", "#21908d"}) EXPECT_THAT(svg, HasSubstr(colour));
  EXPECT_THAT(svg, HasSubstr(">velocity (um/s)<"));
  EXPECT_LT(svg.find("#440154"), svg.find("#fde725"));
}

TEST(Map, DataHaveThreeNumbersPerLine) {
  EXPECT_EQ(draw(small_map()).csv,
            "x_name,x_unit,y_name,y_unit,value_name,value_unit,x,y,value\n"
            "\"stiffness\",\"\",\"phase\",\"rad\",\"velocity\",\"um/s\",1,2,10\n"
            "\"stiffness\",\"\",\"phase\",\"rad\",\"velocity\",\"um/s\",2,2,30\n"
            "\"stiffness\",\"\",\"phase\",\"rad\",\"velocity\",\"um/s\",2,3,20\n");
}

}  // namespace
}  // namespace beadswim
