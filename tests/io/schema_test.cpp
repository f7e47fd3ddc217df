#include "beadswim/io/schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Json sound_layout() {
  return Json::parse(R"({
    "schema": "beadswim/layout/1", "units": "lattice",
    "fluid": {"density": 1, "kinematic_viscosity": 0.5}, "domain": null,
    "types": {"a": {"beads": [{"radius": 4, "density": 1}, {"radius": 4, "density": 1}, {"radius": 4, "density": 1}],
                    "springs": [{"stiffness": 0.1, "rest_length": 20, "damping": 0},
                                {"stiffness": 0.1, "rest_length": 20, "damping": 0}],
                    "angular_stiffness": 1, "driving": {"amplitude": [1, 1], "phase": 1.5, "period": 1000}}},
    "swimmers": [{"id": 0, "type": "a", "position": [0, 0, 0], "axis": [1, 0, 0]}]})");
}

/// Changes a layout at a JSON pointer and returns the message with which it is refused; an empty text if it
/// is accepted.
std::string refusal(const std::string& pointer, const Json& value) {
  Json layout = sound_layout();
  layout[Json::json_pointer(pointer)] = value;
  try {
    validate_json(layout, "layout", "in.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Schema, AcceptsASoundDocument) {
  EXPECT_EQ(refusal("/fluid/density", 2.5), "");
}

TEST(Schema, NamesTheNearestKeyForAMisspeltOneAndSaysItOnce) {
  Json layout = sound_layout();
  layout["types"]["a"]["beads"][1] = {{"raduis", 4}, {"density", 1}};
  try {
    validate_json(layout, "layout", "in.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(StartsWith("in.json:/types/a/beads/1/raduis: unknown key; did you mean \"radius\"?"),
                      Not(HasSubstr("lacks")), Not(HasSubstr("\n"))));
  }
}

TEST(Schema, NamesEveryUnknownKeyOfAnObject) {
  Json fluid{{"density", 1}, {"kinematic_viscosity", 1}, {"temperature", 1}, {"pressure", 2}};
  EXPECT_THAT(refusal("/fluid", fluid), AllOf(HasSubstr("/fluid/temperature"), HasSubstr("/fluid/pressure")));
}

TEST(Schema, NamesAMissingKeyAndItsMeaning) {
  EXPECT_EQ(refusal("/fluid", {{"density", 1}}),
            "in.json:/fluid: the object lacks the key \"kinematic_viscosity\" (kinematic viscosity nu "
            "[length^2/time])");
}

TEST(Schema, EchoesTheValueAndWhatIsAllowed) {
  EXPECT_EQ(refusal("/types/a/beads/2/radius", -4),
            "in.json:/types/a/beads/2/radius: -4: the value must be greater than 0 (bead radius [length])");
  EXPECT_THAT(refusal("/swimmers/0/id", -1),
              HasSubstr("-1: the value must be at least 0 and at most 2147483647"));
  EXPECT_THAT(refusal("/types/a/driving/frame", "bodi"), HasSubstr("did you mean \"body\"?"));
}

// Weak typing would take "4" for 4, and the library's conversion 3.7 for the integer 3.
TEST(Schema, RefusesOneTypeInPlaceOfAnother) {
  EXPECT_THAT(refusal("/types/a/beads/0/radius", "4"), HasSubstr("must be of type number, not string"));
  EXPECT_THAT(refusal("/swimmers/0/id", 3.7), HasSubstr("must be of type integer"));
  EXPECT_THAT(refusal("/domain", 5), HasSubstr("must be of type object or null, not number"));
}

TEST(Schema, CountsElementsAndSaysWhatTheyAre) {
  const Json spring{{"stiffness", 1}, {"rest_length", 20}, {"damping", 0}};
  EXPECT_THAT(
      refusal("/types/a/springs", {spring, spring, spring}),
      AllOf(StartsWith("in.json:/types/a/springs: the array has 3 elements, but exactly 2 are needed"),
            HasSubstr("the second joins beads 2 and 3")));
}

TEST(Schema, FollowsTheBranchThatTheValueTakes) {
  EXPECT_THAT(refusal("/units", "latice"), HasSubstr("did you mean \"lattice\"?"));
  EXPECT_THAT(
      refusal("/units", {{"length", "um"}, {"time", "sec"}, {"mass", "pg"}}),
      AllOf(StartsWith("in.json:/units/time: \"sec\": the value must be one of"), Not(HasSubstr("\n"))));
  EXPECT_THAT(
      refusal("/units", {{"length", "um"}, {"tmie", "s"}, {"mass", "pg"}}),
      AllOf(StartsWith("in.json:/units/tmie: unknown key; did you mean \"time\"?"), Not(HasSubstr("\n"))));
}

TEST(Schema, EscapesPointers) {
  EXPECT_THAT(refusal("/fluid/a~1b~0c", 1), StartsWith("in.json:/fluid/a~1b~0c: unknown key"));
}

TEST(Schema, ShowsTwentyFaultsAndCountsTheRest) {
  const std::string message = refusal("/swimmers", Json(std::vector<int>(50, 1)));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
  EXPECT_THAT(message, HasSubstr(": at least 30 more faults are not listed"));
}

TEST(SchemaName, SaysWhatTheDocumentIsInstead) {
  EXPECT_THAT(refusal("/schema", "beadswim/run/1"),
              HasSubstr("the document is a run record (beadswim-run), without positions, which are in the "
                        "trajectory (.h5md); give a layout (beadswim-layout)"));
  EXPECT_THAT(refusal("/schema", "layout"), HasSubstr("must be \"beadswim/layout/1\""));
  EXPECT_THAT(refusal("", Json::array()), HasSubstr("the JSON document is an array"));
  EXPECT_THAT(refusal("", Json::object()), HasSubstr("lacks the key \"schema\""));
}

// A newer document may have keys that this program would call unknown: the version is what to say.
TEST(SchemaName, SaysThatADocumentIsNewer) {
  EXPECT_EQ(
      refusal("", {{"schema", "beadswim/layout/2"}, {"blobs", 1}}),
      "in.json:/schema: the schema \"beadswim/layout/2\" is newer than this program, which reads version 1; "
      "update Beadswim");
}

}  // namespace
}  // namespace beadswim
