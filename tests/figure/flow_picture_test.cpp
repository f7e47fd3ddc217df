#include "beadswim/figure/flow_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double plot_left = 84, plot_top = 52,
                 plot_width = 560;  // of the page, for regions that are wide [px]

/// Returns a layer with the velocity that a function states at the centres of its cells.
template <class Velocity>
FlowLayer layer_with(const PlanePoint& origin, double spacing, int nx, int ny, const Velocity& velocity) {
  FlowLayer layer{.origin = origin, .spacing = spacing, .cells = {nx, ny}, .velocity = {}};
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) layer.velocity.push_back(velocity(layer.centre(x, y)));
  return layer;
}

FlowPicture flow_with(std::vector<FlowLayer> layers) {
  return {.title = "Flow", .layers = std::move(layers), .length_unit = "um", .velocity_unit = "um/s"};
}

/// Coloured strokes of the map from the left to the right in one row of squares.
struct Stroke {
  std::string colour;
  double from = 0, to = 0;
};

std::vector<Stroke> row_of_map(const std::string& svg, double y) {
  std::vector<Stroke> row;
  static const std::regex path("<path stroke=\"(#[0-9a-f]+)\" d=\"([^\"]*)\"");
  for (std::sregex_iterator match(svg.begin(), svg.end(), path), end; match != end; ++match) {
    const std::string strokes = (*match)[2];
    static const std::regex stroke("M([0-9.]+) ([0-9.]+)L([0-9.]+) ");
    for (std::sregex_iterator part(strokes.begin(), strokes.end(), stroke); part != end; ++part)
      if (std::stod((*part)[2]) == y)
        row.push_back({(*match)[1], std::stod((*part)[1]), std::stod((*part)[3])});
  }
  std::ranges::sort(row, {}, &Stroke::from);
  return row;
}

int red(const std::string& colour) {
  return std::stoi(colour.substr(1, 2), nullptr, 16);
}
int blue(const std::string& colour) {
  return std::stoi(colour.substr(5, 2), nullptr, 16);
}

// ux = x - 3/4 in 0 < x < 2: white where it vanishes, not in the middle of its range, blue left of it, red
// right of it, without gaps or jumps.
TEST(FlowPicture, ColoursOfAComponentAreSymmetricAboutZero) {
  FlowPicture picture = flow_with(
      {layer_with({0, 0}, 0.1, 20, 10, [](const PlanePoint& r) { return Vec3(r.x() - 0.75, 0, 0); })});
  picture.quantity = FlowQuantity::ux;
  const std::vector<Stroke> row = row_of_map(draw(picture).svg, plot_top + 101);
  EXPECT_EQ(row.front().from, plot_left);
  EXPECT_EQ(row.back().to, plot_left + plot_width);
  for (std::size_t n = 0; n < row.size(); ++n) {
    if (n > 0) {
      EXPECT_EQ(row[n].from, row[n - 1].to);
      EXPECT_LT(std::abs(red(row[n].colour) - red(row[n - 1].colour)), 30);
    }
    const double x = 2 * (row[n].from + row[n].to - 2 * plot_left) / (2 * plot_width);
    if (std::abs(x - 0.75) < 0.05) continue;
    EXPECT_EQ(blue(row[n].colour) > red(row[n].colour), x < 0.75) << x;
  }
}

// Speeds |u| = x of one decade begin at zero; speeds |u| = 10^x of four decades have one colour step per
// factor, which a linear scale would not show.
TEST(FlowPicture, SpeedsOfSeveralDecadesHaveALogarithmicScale) {
  const auto linear =
      draw(
          flow_with({layer_with({0, 0}, 0.1, 20, 10, [](const PlanePoint& r) { return Vec3(r.x(), 0, 0); })}))
          .svg;
  EXPECT_THAT(linear, HasSubstr("speed (um/s)"));
  EXPECT_THAT(linear, Not(HasSubstr(">10⁻¹<")));
  const auto decades =
      draw(flow_with(
               {layer_with({0, 0}, 0.1, 20, 10,
                           [](const PlanePoint& r) { return Vec3(0, 0, std::pow(10, 2 * r.x() - 4)); })}))
          .svg;
  for (const char* tick : {">10⁻³<", ">10⁻²<", ">10⁻¹<"}) EXPECT_THAT(decades, HasSubstr(tick));
  const std::vector<Stroke> row = row_of_map(decades, plot_top + 101);
  EXPECT_GT(row.size(), 30U);
}

// The cells of a coarse layer under a finer one are without meaning.
TEST(FlowPicture, FinerLayersReplaceHiddenCells) {
  const auto velocity = [](const PlanePoint& r) { return Vec3(1 + r.x(), r.y(), 0); };
  FlowLayer coarse = layer_with({0, 0}, 1, 8, 4, velocity);
  const FlowLayer fine = layer_with({3, 1}, 0.5, 4, 4, velocity);
  const auto x_of_line = [](const Drawing& drawing) { return drawing.csv.find("\n3.25,"); };
  EXPECT_EQ(x_of_line(draw(flow_with({coarse}))), std::string::npos);
  coarse.hidden.assign(32, false);
  for (const int x : {3, 4})
    for (const int y : {1, 2}) {
      coarse.hidden[coarse.index(x, y)] = true;
      coarse.velocity[coarse.index(x, y)] = Vec3::Constant(1e9);
    }
  FlowPicture picture = flow_with({coarse, fine});
  picture.quantity = FlowQuantity::ux;
  const Drawing drawing = draw(picture);
  EXPECT_NE(x_of_line(drawing), std::string::npos);
  EXPECT_EQ(std::ranges::count(drawing.csv, '\n'), 1 + 32 - 4 + 16);
  EXPECT_THAT(drawing.csv, Not(HasSubstr("1000000000")));
  const std::vector<Stroke> row = row_of_map(drawing.svg, plot_top + 141);
  for (std::size_t n = 1; n < row.size();
       ++n)  // ux > 0 grows to the right, also across the edges of the layers
    EXPECT_LT(blue(row[n].colour), blue(row[n - 1].colour)) << row[n].from;
}

TEST(FlowPicture, BeadsAreCirclesInTheirPlaces) {
  FlowPicture picture =
      flow_with({layer_with({-1, 2}, 0.5, 20, 10, [](const PlanePoint&) { return Vec3(1, 0, 0); })});
  picture.beads = {{.centre = {4, 4.5}, .radius = 1.25}, {.centre = {-1, 7}, .radius = 1, .is_cut = false}};
  const std::string svg = draw(picture).svg;
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"364.00\" cy=\"192.00\" r=\"70.00\" fill=\"#e8e8e8\""));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"84.00\" cy=\"52.00\" r=\"56.00\" fill=\"none\""));
}

TEST(FlowPicture, ArrowsPointAlongTheFlowWithTheSquareRootOfTheSpeed) {
  // The left half is four times as fast; the velocity points up and to the left.
  FlowPicture picture = flow_with({layer_with(
      {0, 0}, 1, 20, 10, [](const PlanePoint& r) -> Vec3 { return (r.x() < 10 ? 4 : 1) * Vec3(-3, 4, 7); })});
  picture.style = FlowStyle::arrows;
  const std::string svg = draw(picture).svg, group = svg.substr(svg.find("<g clip-path"));
  static const std::regex arrow(
      "<line x1=\"([0-9.]+)\" y1=\"([0-9.]+)\" x2=\"([0-9.]+)\" y2=\"([0-9.]+)\"[^>]*>\n<path d=\"M([0-9.]+) "
      "([0-9.]+)");
  int arrows = 0;
  for (std::sregex_iterator match(group.begin(), group.end(), arrow), end; match != end; ++match, ++arrows) {
    const auto number = [&](int n) { return std::stod((*match)[n]); };
    const double x = number(5) - number(1), y = number(6) - number(2);
    EXPECT_NEAR(x / y, 3.0 / 4, 0.01);
    EXPECT_LT(y, 0);
    const double place = (number(5) + number(1)) / 2 - plot_left;
    if (std::abs(place - plot_width / 2) < 40) continue;  // interpolated
    EXPECT_NEAR(std::hypot(x, y), place < plot_width / 2 ? 20 : 10, 0.02);
  }
  EXPECT_EQ(arrows, 28 * 14);
}

TEST(FlowPicture, SizeAndBytesDoNotDependOnTheNumberOfCells) {
  const auto vortex = [](const PlanePoint& r) { return Vec3(std::sin(r.y()), std::sin(r.x()), 0); };
  const std::string fine = draw(flow_with({layer_with({0, 0}, 0.01, 600, 300, vortex)})).svg;
  EXPECT_LT(fine.size(), 500000U);
  EXPECT_EQ(fine, draw(flow_with({layer_with({0, 0}, 0.01, 600, 300, vortex)})).svg);
}

TEST(FlowPicture, FluidAtRestIsDrawn) {
  for (const FlowStyle style : {FlowStyle::streamlines, FlowStyle::arrows}) {
    FlowPicture picture =
        flow_with({layer_with({0, 0}, 1, 1, 1, [](const PlanePoint&) { return Vec3(0, 0, 0); })});
    picture.style = style;
    EXPECT_THAT(draw(picture).svg, Not(HasSubstr("nan")));
  }
}

TEST(FlowPicture, RefusesAPlaneInWhichAllCellsAreHidden) {
  FlowPicture picture =
      flow_with({layer_with({0, 0}, 1, 1, 1, [](const PlanePoint&) { return Vec3(1, 0, 0); })});
  picture.layers[0].hidden = {true};
  EXPECT_THROW(draw(picture), InputError);
}

}  // namespace
}  // namespace beadswim
