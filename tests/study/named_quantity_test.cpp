#include "beadswim/study/named_quantity.hpp"

#include <gtest/gtest.h>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/gallery.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/scene_differences.hpp"

namespace beadswim {
namespace {

/// Returns the JSON pointers of the fields that the value of a quantity changes, each followed by a space.
std::string fields_changed_by(const std::string& quantity, const Json& value) {
  const auto leaves = [](const SwimmerParameters& parameters) {
    std::vector<FieldLeaf> all = leaves_of(parameters.swimmer);
    append_leaves(all, "/fluid", parameters.fluid);
    return all;
  };
  SwimmerParameters parameters{.swimmer = three_beads(paper_single().types.at("a")),
                               .fluid = paper_single().fluid};
  const std::vector<FieldLeaf> before = leaves(parameters);
  set_quantities(parameters, {{quantity, value}});
  const std::vector<FieldLeaf> after = leaves(parameters);
  std::string changed;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].number != after[i].number || before[i].word != after[i].word)
      changed += before[i].pointer + " ";
  return changed;
}

// Would catch a row of the table with the field of another quantity.
TEST(NamedQuantity, ChangesItsFieldAlone) {
  EXPECT_EQ(fields_changed_by("radius", 5), "/beads/0/radius /beads/1/radius /beads/2/radius ");
  EXPECT_EQ(fields_changed_by("radius", {4, 5, 4}), "/beads/1/radius ");
  EXPECT_EQ(fields_changed_by("bead-density", 2), "/beads/0/density /beads/1/density /beads/2/density ");
  EXPECT_EQ(fields_changed_by("arm", {20, 21}), "/springs/1/rest_length ");
  EXPECT_EQ(fields_changed_by("stiffness", 2), "/springs/0/stiffness /springs/1/stiffness ");
  EXPECT_EQ(fields_changed_by("damping", 2), "/springs/0/damping /springs/1/damping ");
  EXPECT_EQ(fields_changed_by("angular-stiffness", 2), "/angular_stiffness ");
  EXPECT_EQ(fields_changed_by("amplitude", 2), "/driving/amplitude/0 /driving/amplitude/1 ");
  EXPECT_EQ(fields_changed_by("phase", 2), "/driving/phase ");
  EXPECT_EQ(fields_changed_by("period", 2), "/driving/period ");
  EXPECT_EQ(fields_changed_by("frame", "body"), "/driving/frame ");
  EXPECT_EQ(fields_changed_by("viscosity", 2), "/fluid/kinematic_viscosity ");
  EXPECT_EQ(fields_changed_by("density", 2), "/fluid/density ");
}

TEST(NamedQuantity, RefusesValuesOutsideItsRange) {
  const auto fault = [](const char* name, const Json& value) {
    return value_fault(*find_quantity(name), value);
  };
  EXPECT_EQ(fault("radius", 0), "\"0\": the value must be a finite number greater than 0");
  EXPECT_EQ(fault("damping", -1), "\"-1\": the value must be a finite number, 0 or greater");
  EXPECT_EQ(fault("phase", "a"),
            "\"a\": the value must be a finite number of radians, or of degrees such as 90deg");
  EXPECT_EQ(fault("frame", "bod"),
            "unknown value \"bod\"; did you mean \"body\"? Valid values: lab, initial-axis, body");
  EXPECT_EQ(fault("damping", 0) + fault("phase", -1) + fault("frame", "lab") + fault("period", 1), "");
}

// The angular stiffness and the resolution of the paper follow the quantities from which they are derived.
TEST(NamedQuantity, KeepsDefaultsOfALayout) {
  Layout layout = paper_single();
  set_quantities(layout, {{"stiffness", 0.1}, {"viscosity", 0.5}}, "in.json");
  const ThreeBeadSwimmer swimmer = three_beads(layout.types.at("a"));
  EXPECT_EQ(swimmer.angular_stiffness, straightening_stiffness(swimmer));
  EXPECT_EQ(layout.resolution->relaxation_time, 2);
  set_quantities(layout, {{"angular-stiffness", 7}}, "in.json");
  set_quantities(layout, {{"stiffness", 0.2}}, "in.json");
  EXPECT_EQ(three_beads(layout.types.at("a")).angular_stiffness, 7);
  layout.types["b"] = swimmer_type(Triangle{}, layout.fluid);
  EXPECT_THROW(set_quantities(layout, {{"radius", 3}}, "in.json"), InputError);
}

}  // namespace
}  // namespace beadswim
