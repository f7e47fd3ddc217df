#include "beadswim/figure/swarm_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::HasSubstr;

/// Returns a swimmer along x whose middle bead is at `middle`.
PicturedSwimmer swimmer_at(const Vec3& middle, int colour) {
  const Vec3 arm(20, 0, 0);
  return {.beads = {{middle - arm, 4}, {middle, 4}, {middle + arm, 4}},
          .bonds = {{0, 1}, {1, 2}},
          .colour = colour};
}

SwarmPicture picture_of(std::vector<PicturedSwimmer> swimmers) {
  return {.title = "swarm", .box = Vec3(120, 80, 60), .swimmers = std::move(swimmers)};
}

struct Disc {
  int colour = 0;
  double x = 0, y = 0, radius = 0;
};

/// Returns the beads in the order in which the document draws them.
std::vector<Disc> discs(const std::string& svg) {
  static const std::regex circle(R"re(<circle class="b(\d)" cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)")re");
  std::vector<Disc> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), circle), end; at != end; ++at) {
    found.push_back({std::stoi((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3]), std::stod((*at)[4])});
  }
  return found;
}

std::vector<Disc> discs_of(const std::vector<PicturedSwimmer>& swimmers) {
  return discs(draw(picture_of(swimmers)).svg);
}

TEST(SwarmPicture, SamePictureGivesTheSameBytes) {
  const SwarmPicture picture = picture_of({swimmer_at({60, 40, 30}, 0), swimmer_at({60, 10, 30}, 1)});
  EXPECT_EQ(draw(picture).svg, draw(picture).svg);
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
  const std::string svg =
      draw(picture_of({swimmer_at({0, 0, 0}, 0), swimmer_at({120, 80, 60}, 1), swimmer_at({120, 0, 0}, 2)}))
          .svg;
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex(R"re(width="([\d.]+)" height="([\d.]+)")re")));
  for (const Disc& disc : discs(svg)) {
    EXPECT_GT(disc.x - disc.radius, 0);
    EXPECT_GT(disc.y - disc.radius, 0);
    EXPECT_LT(disc.x + disc.radius, std::stod(size[1]));
    EXPECT_LT(disc.y + disc.radius, std::stod(size[2]));
  }
}

// The length is the largest 1, 2 or 5 times a power of ten up to a quarter of the box.
TEST(SwarmPicture, ScaleBarHasARoundLength) {
  for (const auto& [box, text] : {std::pair(120.0, "20 um"), std::pair(90.0, "20 um"),
                                  std::pair(70.0, "10 um"), std::pair(2.1, "0.5 um")}) {
    SwarmPicture picture = picture_of({swimmer_at({1, 1, 1}, 0)});
    picture.box = {box, box, box};
    picture.length_unit = "um";
    EXPECT_THAT(draw(picture).svg, HasSubstr(std::string(">") + text + "<")) << box;
  }
}

TEST(SwarmPicture, KeysAndNotesAreWritten) {
  SwarmPicture picture = picture_of({swimmer_at({60, 40, 30}, 0)});
  picture.keys = {"a & b", "c"};
  picture.notes.push_back({.text = "one box"});
  const std::string svg = draw(picture).svg;
  EXPECT_THAT(svg, HasSubstr(">a &amp; b<"));
  EXPECT_THAT(svg, HasSubstr(">one box<"));
  EXPECT_EQ(discs(svg).size(), 5U);
}

/// Returns the complete SVG element <text> whose text begins with `beginning`.
std::string text_element(const std::string& svg, const std::string& beginning) {
  const std::size_t content = svg.find(">" + beginning);
  if (content == std::string::npos) return {};
  const std::size_t start = svg.rfind("<text", content);
  return svg.substr(start, svg.find("</text>", start) - start);
}

double attribute(const std::string& element, const std::string& name) {
  return std::stod(element.substr(element.find(name + "=\"") + name.size() + 2));
}

// Behind a near bead a name could not be read; above its bead it says whose it is.
TEST(SwarmPicture, NamesAreDrawnLastAndAboveTheirBeads) {
  SwarmPicture picture = picture_of({swimmer_at({60, 70, 30}, 0), swimmer_at({60, 10, 30}, 1)});
  picture.marks = {{"A", picture.swimmers[0].beads[1]}};
  const std::string svg = draw(picture).svg;
  const std::string name = text_element(svg, "A");
  ASSERT_FALSE(name.empty());
  EXPECT_GT(svg.find(name), svg.rfind("<circle class"));
  const Disc bead = discs(svg)[1];
  EXPECT_NEAR(attribute(name, " x"), bead.x, 0.06);
  EXPECT_LT(attribute(name, " y"), bead.y - bead.radius);
}

// An arrow with a head at either end, no longer than the beads are apart, its label on the page.
TEST(SwarmPicture, DistancesRunFromBeadToBead) {
  SwarmPicture picture = picture_of({swimmer_at({60, 10, 30}, 0), swimmer_at({60, 50, 30}, 1)});
  const Vec3 from = picture.swimmers[0].beads[2].centre, to = picture.swimmers[1].beads[2].centre;
  picture.distances = {{"C_y = 40", from, to, {0, 0, -12}}};
  const std::string svg = draw(picture).svg;
  EXPECT_THAT(svg, HasSubstr("<tspan dy=\"3.50\" font-size=\"9.00\" stroke=\"none\">y</tspan>"));
  const std::string label = text_element(svg, "C<");
  ASSERT_FALSE(label.empty());
  const auto all = discs(svg);
  EXPECT_GT(attribute(label, " y"), std::min(all[2].y, all[5].y));
  std::smatch size;
  ASSERT_TRUE(std::regex_search(svg, size, std::regex(R"re(width="([\d.]+)")re")));
  EXPECT_LT(attribute(label, " x") + 60, std::stod(size[1]));
}

/// Returns the ends x0, y0, x1, y1 of the bonds in the order in which the document draws them [px].
std::vector<std::array<double, 4>> bonds(const std::string& svg) {
  static const std::regex path(R"re(<path d="M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)"/>)re");
  std::vector<std::array<double, 4>> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), path), end; at != end; ++at)
    found.push_back({std::stod((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3]), std::stod((*at)[4])});
  return found;
}

// A picture of chains of three beads would have neither the third side of the triangle nor its fourth bead.
TEST(SwarmPicture, BondsJoinTheBeadsThatTheyName) {
  const PicturedSwimmer swimmer{
      .beads = {{{20, 40, 50}, 2}, {{40, 40, 20}, 4}, {{80, 40, 20}, 6}, {{60, 40, 50}, 8}},
      .bonds = {{1, 2}, {2, 3}, {3, 1}, {0, 1}}};
  const std::string svg = draw(picture_of({swimmer})).svg;
  std::vector<Disc> beads = discs(svg);
  std::ranges::sort(beads, {}, &Disc::radius);
  ASSERT_EQ(beads.size(), 4U);
  const auto lines = bonds(svg);
  ASSERT_EQ(lines.size(), 4U);
  for (const auto& [first, second] : swimmer.bonds) {
    const auto joins = [a = beads[first], b = beads[second]](const std::array<double, 4>& line) {
      return std::hypot(line[0] - a.x, line[1] - a.y) < 1.1 * a.radius &&
             std::hypot(line[2] - b.x, line[3] - b.y) < 1.1 * b.radius;
    };
    EXPECT_EQ(std::ranges::count_if(lines, joins), 1) << first << " " << second;
  }
}

// The width of bonds must not follow from a sphere, which has none.
TEST(SwarmPicture, SpheresAndSwimmersShareAPicture) {
  const PicturedSwimmer sphere{.beads = {{{60, 40, 30}, 15}}, .colour = 3};
  const std::string alone = draw(picture_of({sphere})).svg;
  EXPECT_EQ(discs(alone).size(), 1U);
  EXPECT_TRUE(bonds(alone).empty());
  const PicturedSwimmer swimmer = swimmer_at({60, 10, 30}, 1);
  const std::string mixture = draw(picture_of({sphere, swimmer})).svg;
  EXPECT_EQ(discs(mixture).size(), 4U);
  EXPECT_EQ(bonds(mixture).size(), 2U);
  const auto style = [](const std::string& svg) {
    return svg.substr(svg.find("<style>"), svg.find("</style>") - svg.find("<style>"));
  };
  EXPECT_EQ(style(mixture), style(draw(picture_of({swimmer})).svg));
}

/// Returns the coordinates of the three corners of each head, tip first.
std::vector<std::array<double, 6>> heads(const std::string& svg) {
  static const std::regex triangle(
      R"re(<polygon class="b\d+" points="([\d.]+),([\d.]+) ([\d.]+),([\d.]+) ([\d.]+),([\d.]+)")re");
  std::vector<std::array<double, 6>> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), triangle), end; at != end; ++at) {
    std::array<double, 6>& head = found.emplace_back();
    for (int i = 0; i < 6; ++i) head[i] = std::stod((*at)[i + 1]);
  }
  return found;
}

// A head at the wrong end would turn every swimmer round.
TEST(SwarmPicture, HeadsPointAlongTheAxis) {
  for (const double direction : {-1.0, 1.0}) {
    PicturedSwimmer swimmer = swimmer_at({60, 40, 30}, 2);
    swimmer.axis = direction * Vec3::UnitX();
    const std::string svg = draw(picture_of({swimmer})).svg;
    const auto found = heads(svg);
    ASSERT_EQ(found.size(), 1U);
    const auto [tip_x, tip_y, left_x, left_y, right_x, right_y] = found[0];
    const std::vector<Disc> beads = discs(svg);
    const double base = (left_x + right_x) / 2;
    EXPECT_GT(direction * (tip_x - base), 0);
    constexpr double foreshortening = 0.8;  // at most, of the x axis
    for (const Disc& bead : beads) EXPECT_GE(direction * (base - bead.x), foreshortening * bead.radius);
  }
  EXPECT_TRUE(heads(draw(picture_of({swimmer_at({60, 40, 30}, 2)})).svg).empty()) << "it has no axis";
}

// Colours run from the lowest to the highest value; a swimmer without one is grey.
TEST(SwarmPicture, ColoursShowValues) {
  std::vector<PicturedSwimmer> swimmers;
  for (const double y : {10, 30, 50, 70}) swimmers.push_back(swimmer_at({60, y, 30}, 0));
  swimmers[0].value = 3e-5;
  swimmers[1].value = -1e-5;
  swimmers[2].value = 1e-5;
  SwarmPicture picture = picture_of(swimmers);
  picture.value_label = {"velocity", "um/s"};
  const Drawing drawing = draw(picture);
  std::vector<std::string> fills;
  static const std::regex bead("<circle class=\"b(\\d+)\"");
  for (std::sregex_iterator at(drawing.svg.begin(), drawing.svg.end(), bead), end; at != end; ++at)
    fills.push_back((*at)[1]);
  EXPECT_THAT(fills, testing::UnorderedElementsAre("31", "31", "31", "0", "0", "0", "16", "16", "16", "32",
                                                   "32", "32"));
  EXPECT_THAT(drawing.svg, HasSubstr(">velocity (10⁻⁵ um/s)<"));
  EXPECT_THAT(drawing.csv, HasSubstr("radius,unit,\"velocity (um/s)\"\n0,1,40,10,30,4,\"\",3e-05\n"));
  EXPECT_THAT(drawing.csv, HasSubstr("\n0,3,80,70,30,4,\"\",\n"));
  for (PicturedSwimmer& swimmer : picture.swimmers) swimmer.value.reset();
  EXPECT_NO_THROW(draw(picture));
}

TEST(SwarmPicture, RefusesAnEmptySwarm) {
  EXPECT_THROW(draw(picture_of({})), InputError);
}

}  // namespace
}  // namespace beadswim
