#include "beadswim/scene/scene_differences.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "beadswim/scene/presets.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

/// Returns two swimmers in a box of 1200 x 800 x 800 that is periodic along x and y and has walls along z.
Layout two_swimmers() {
  Layout layout = paper_single();
  layout.domain.box->boundary = {Boundary::periodic, Boundary::periodic, Boundary::no_slip};
  layout.swimmers.push_back({.id = 3, .type = "a", .position = Vec3(100, 400, 500)});
  return layout;
}

std::vector<SceneDifference> after(const std::function<void(Layout&)>& edit) {
  Layout reference = two_swimmers();
  edit(reference);
  return scene_differences(two_swimmers(), reference);
}

/// Returns the names of the differences that the edit of the reference causes, joined by commas.
std::string names_after(const std::function<void(Layout&)>& edit) {
  std::string names;
  for (const SceneDifference& difference : after(edit)) names += (names.empty() ? "" : ",") + difference.name;
  return names;
}

SwimmerType& type(Layout& layout) {
  return layout.types.at("a");
}

/// Returns names_after() of an edit of the type.
std::string names_after_change(const std::function<void(ThreeBeadSwimmer&)>& edit) {
  return names_after([&](Layout& layout) { change(type(layout), edit); });
}

void move_all(Layout& layout, const Vec3& shift) {
  for (Swimmer& swimmer : layout.swimmers) swimmer.position += shift;
}

TEST(SceneDifferences, ACopyHasNone) {
  EXPECT_EQ(names_after([](Layout&) {}), "");
}

// Each property alone. Would catch a property that is not compared, or that is taken for another.
TEST(SceneDifferences, EachPropertyHasItsName) {
  EXPECT_EQ(names_after_change([](auto& three) { three.driving.period = 4000; }), "period");
  EXPECT_EQ(names_after_change([](auto& three) { three.driving.amplitude[1] = 0.3; }), "amplitude");
  EXPECT_EQ(names_after_change([](auto& three) { three.driving.phase = 0; }), "phase");
  EXPECT_EQ(names_after_change([](auto& three) { three.driving.frame = DrivingFrame::body; }), "frame");
  EXPECT_EQ(names_after_change([](auto& three) { three.beads[2].radius = 5; }), "radius");
  EXPECT_EQ(names_after_change([](auto& three) { three.beads[1].density = 2; }), "bead_density");
  EXPECT_EQ(names_after_change([](auto& three) { three.springs[1].rest_length = 21; }), "arm");
  EXPECT_EQ(names_after_change([](auto& three) { three.springs[0].stiffness = 0.1; }), "stiffness");
  EXPECT_EQ(names_after_change([](auto& three) { three.springs[1].damping = 0.1; }), "damping");
  EXPECT_EQ(names_after_change([](auto& three) { three.angular_stiffness = 0; }), "angular_stiffness");
  EXPECT_EQ(names_after([](Layout& l) { l.fluid.density = 1.1; }), "fluid");
  EXPECT_EQ(names_after([](Layout& l) { l.fluid.kinematic_viscosity = 0.3; }), "fluid");
  EXPECT_EQ(names_after([](Layout& l) { l.domain.box->lengths[1] = 900; }), "domain");
  EXPECT_EQ(names_after([](Layout& l) { l.domain.box->boundary[0] = Boundary::free_slip; }), "domain");
  EXPECT_EQ(names_after([](Layout& l) { l.domain.box.reset(); }), "domain");
  EXPECT_EQ(names_after([](Layout& l) { l.swimmers.pop_back(); }), "swimmers");
  EXPECT_EQ(names_after([](Layout& l) { l.swimmers[1].id = 2; }), "swimmers");
  EXPECT_EQ(names_after([](Layout& l) { l.swimmers[1].position[0] += 1e-3; }), "placing");
  EXPECT_EQ(names_after([](Layout& l) { l.swimmers[1].axis = Vec3(0.6, 0.8, 0); }), "placing");
  EXPECT_EQ(names_after_change([](auto& three) { three.driving.phase_offset = 1; }), "placing");
}

struct Magnet {
  std::vector<double> moments{1, 2};
  int poles = 2;

  static void visit_fields(auto&& visit, auto& magnet) {
    visit("moments", magnet.moments);
    visit("poles", magnet.poles, omitted_if(2));
  }
};

// Would catch a field that is compared only if somebody adds it to a list of properties.
TEST(SceneDifferences, AFieldWithoutARowHasItsOwnName) {
  Magnet other;
  other.moments[1] = 3;
  other.poles = 4;
  std::vector<SceneDifference> differences;
  add_differences(differences, properties_of(leaves_of(Magnet{})), properties_of(leaves_of(other)));
  EXPECT_EQ(differences, (std::vector<SceneDifference>{{"moments", "1, 2", "1, 3"}, {"poles", "2", "4"}}));
}

// Shapes with the same lengths and amplitudes differ in their places, their bonds or what is driven.
// In a flow with a gradient, the velocity depends on the place along the gradient.
TEST(SceneDifferences, FlowAndPlaceInItMatter) {
  EXPECT_EQ(names_after([](Layout& l) { l.flow.velocity[1] = 0.1; }), "flow");
  EXPECT_EQ(names_after([](Layout& l) { l.flow.velocity_gradient(0, 2) = 0.1; }), "flow");
  EXPECT_EQ(names_after([](Layout& l) { l.domain = {.box = {}, .half_space = HalfSpace{}}; }), "domain");
  Layout one = two_swimmers();
  one.domain = {};
  one.flow.velocity_gradient(0, 2) = 0.1;
  Layout along = one, across = one;
  move_all(along, Vec3(3, 4, 0));
  move_all(across, Vec3(0, 0, 1));
  EXPECT_TRUE(scene_differences(one, along).empty());
  ASSERT_EQ(scene_differences(one, across).size(), 1U);
  EXPECT_EQ(scene_differences(one, across)[0].name, "placing");
}

TEST(SceneDifferences, KnowShapesAndWhatIsDriven) {
  Layout triangle;
  SwimmerType& shape = triangle.types["t"];
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(16, 0, 0), Vec3(8, 14, 0)})
    shape.beads.push_back({{.radius = 4, .density = 1}, at});
  for (const std::array<int, 2>& beads : {std::array{0, 1}, {1, 2}, {2, 0}})
    shape.bonds.push_back({{1, 16, 0}, beads});
  shape.angles = {{.beads = {0, 1, 2}, .stiffness = 5, .rest = 2}};
  shape.driving.period = 1000;
  shape.driving.bonds = {{.bond = 0, .harmonics = {{.amplitude = 2}}}};
  triangle.swimmers = {{.id = 0, .type = "t"}};
  const auto difference = [&](const std::function<void(SwimmerType&)>& edit) {
    Layout other = triangle;
    edit(other.types["t"]);
    std::string text;
    for (const SceneDifference& each : scene_differences(triangle, other))
      text += each.name + ": " + each.reference + ";";
    return text;
  };
  EXPECT_EQ(difference([](SwimmerType&) {}), "");
  EXPECT_EQ(difference([](SwimmerType& t) { t.beads[2].at.y() = -14; }), "arm: 16, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.bonds[1].beads = {2, 1}; }), "arm: 16, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.driving.bonds[0].bond = 1; }),
            "amplitude: 2, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.driving.bonds[0].harmonics[0].multiple = 3; }),
            "amplitude: 2, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) {
              t.driving.forces = {{.bead = 0, .direction = Vec3::UnitX(), .constant = 0.01}};
            }),
            "amplitude: 0.01, 2;");
  EXPECT_EQ(difference([](SwimmerType& t) {
              t.driving.angles = {{.angle = 0, .harmonics = {{.amplitude = 0.1, .phase = 1}}}};
            }),
            "amplitude: 2, 0.1;phase: 0, 1;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.driving.bonds[0].quantity = BondQuantity::rest_length; }),
            "amplitude: 2, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.angles[0].beads = {1, 2, 0}; }), "arm: 16, of another shape;");
  EXPECT_EQ(difference([](SwimmerType& t) { t.angles[0].rest = 1; }), "arm: 16, of another shape;");
}

TEST(SceneDifferences, StateTheOrientationOfASwimmerTurnedAboutItsAxis) {
  const auto differences = after([](Layout& layout) {
    layout.swimmers[1].turn = Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()));
  });
  ASSERT_EQ(differences.size(), 1U);
  EXPECT_EQ(differences[0].name, "placing");
  EXPECT_EQ(differences[0].run, "swimmer 3 with orientation (1, 0, 0, 0)");
  EXPECT_EQ(differences[0].reference, "swimmer 3 with orientation (0, 1, 0, 0)");
}

TEST(SceneDifferences, AreSortedAndStateBothValues) {
  const auto differences = after([](Layout& layout) {
    layout.domain.box.reset();
    layout.swimmers[1].driving = type(layout).driving;
    change(*layout.swimmers[1].driving, [](ThreeBeadDriving& driving) {
      driving.amplitude = {0.2, 0.3};
      driving.phase = std::numbers::pi;
    });
  });
  const std::vector<SceneDifference> expected{
      {"amplitude", "swimmer 3: 0.2", "swimmer 3: 0.2, 0.3"},
      {"phase", "swimmer 3: 1.5707963267948966", "swimmer 3: 3.141592653589793"},
      {"domain", "1200 x 800 x 800, periodic, periodic, no-slip", "open space"}};
  EXPECT_EQ(differences, expected);
}

TEST(SceneDifferences, StateSwimmersByNumberAndIds) {
  const std::vector<SceneDifference> expected{{"swimmers", "2 with id 0 to 3", "1 with id 0"}};
  EXPECT_EQ(after([](Layout& layout) { layout.swimmers.pop_back(); }), expected);
}

// Would catch positions that are compared without regard to the boundaries.
TEST(SceneDifferences, ACommonTranslationAlongPeriodicAxesIsNone) {
  EXPECT_EQ(names_after([](Layout& layout) { move_all(layout, Vec3(123.4, -50.6, 0)); }), "");
  EXPECT_EQ(names_after([](Layout& layout) { move_all(layout, Vec3(0, 0, 1)); }), "placing");
}

TEST(SceneDifferences, APositionInAnotherPeriodicImageIsNone) {
  EXPECT_EQ(names_after([](Layout& layout) { layout.swimmers[1].position[0] += 2400; }), "");
  EXPECT_EQ(names_after([](Layout& layout) { layout.swimmers[1].position[2] += 800; }), "placing");
}

TEST(SceneDifferences, ATranslationInOpenSpaceIsNone) {
  Layout run = two_swimmers();
  run.domain.box.reset();
  Layout reference = run;
  move_all(reference, Vec3(1, 2, 3));
  EXPECT_TRUE(scene_differences(run, reference).empty());
  reference.swimmers[1].position[2] += 1;
  const std::vector<SceneDifference> expected{
      {"placing", "swimmer 3 at (100, 400, 500)", "swimmer 3 at (100, 400, 501)"}};
  EXPECT_EQ(scene_differences(run, reference), expected);
}

// The names of types and the order of the swimmers do not belong to the scene.
TEST(SceneDifferences, NamesOfTypesAndOrderDoNotMatter) {
  EXPECT_EQ(names_after([](Layout& layout) {
              layout.types["b"] = type(layout);
              layout.swimmers[0].type = "b";
              std::swap(layout.swimmers[0], layout.swimmers[1]);
            }),
            "");
}

}  // namespace
}  // namespace beadswim
