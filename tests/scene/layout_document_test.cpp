#include "beadswim/documents/layout_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/units.hpp"
#include "three_bead_types.hpp"

namespace beadswim {
namespace {

/// Writes the document to a file, and reads the file as a program does.
LayoutDocument read_back(const Json& json) {
  const auto path =
      std::filesystem::temp_directory_path() / ("beadswim-layout-" + std::to_string(::getpid()));
  write_text(path, dump_json(json));
  struct Remove {
    std::filesystem::path path;
    ~Remove() { std::filesystem::remove(path); }
  } const remove{path};
  return read_layout(path);
}

/// Returns a layout that uses every part of the format.
LayoutDocument full_document() {
  LayoutDocument document{.layout = paper_single(), .provenance = {{{"program", "test"}}}};
  Layout& layout = document.layout;
  layout.units = {.lattice = false, .length = {"um", 1e-6}, .time = {"tick", 2.5e-7}, .mass = {"pg", 1e-15}};
  layout.domain.box->boundary = {Boundary::periodic, Boundary::free_slip, Boundary::no_slip};
  SwimmerType& type = layout.types["b"] = layout.types["a"];
  change(type, [](ThreeBeadSwimmer& three) {
    three.beads[1] = {.radius = 3.25, .density = 1.1};
    three.springs[1].damping = 0.1;
    three.driving.frame = DrivingFrame::body;
  });
  Swimmer second{.id = 12, .type = "b", .position = Vec3(200, 100, 300.1), .axis = Vec3(0, 0.6, 0.8)};
  second.driving = type.driving;
  change(*second.driving, [](ThreeBeadDriving& driving) { driving.phase = -0.3; });
  layout.swimmers.push_back(second);
  return document;
}

TEST(LayoutDocument, ReadingWhatWasWrittenGivesTheSameDocument) {
  const Json json = layout_to_json(full_document());
  EXPECT_EQ(layout_to_json(read_back(json)), json);
  EXPECT_EQ(dump_json(layout_to_json(read_back(json))), dump_json(json));
}

TEST(LayoutDocument, KeepsTheValuesOfAllParts) {
  const Layout layout = read_back(layout_to_json(full_document())).layout;
  EXPECT_FALSE(layout.units.lattice);
  EXPECT_EQ(layout.units.time.si_factor, 2.5e-7);
  EXPECT_EQ(layout.domain.box->boundary[2], Boundary::no_slip);
  EXPECT_EQ(layout.types.at("b").beads[1].radius, 3.25);
  EXPECT_EQ(layout.types.at("b").bonds[1].damping, 0.1);
  EXPECT_EQ(layout.types.at("b").driving.frame, DrivingFrame::body);
  EXPECT_EQ(layout.swimmers[1].axis, Vec3(0, 0.6, 0.8));
  EXPECT_EQ(layout.resolution->relaxation_time, 1.5);
}

TEST(LayoutDocument, ASwimmersDrivingChangesOnlyWhatItNames) {
  const Json json = layout_to_json(full_document());
  EXPECT_EQ(json["swimmers"][1]["driving"], (Json{{"phase", -0.3}}));
  const Layout layout = read_back(json).layout;
  const ThreeBeadDriving driving = three_beads(layout.resolved_type(layout.swimmers[1])).driving;
  EXPECT_EQ(driving.phase, -0.3);
  EXPECT_EQ(driving.period, 4800);
  EXPECT_EQ(driving.frame, DrivingFrame::body);
}

TEST(LayoutDocument, NullIsUnboundedFluid) {
  LayoutDocument document = full_document();
  document.layout.domain.box.reset();
  EXPECT_TRUE(layout_to_json(document)["domain"].is_null());
  EXPECT_FALSE(read_back(layout_to_json(document)).layout.domain.box.has_value());
}

TEST(LayoutDocument, FaultsAcrossFieldsNameTheFileAndThePointer) {
  Json json = layout_to_json(full_document());
  json["swimmers"][1]["id"] = 0;
  try {
    read_back(json);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(":/swimmers/1/id: the id 0 is already used by /swimmers/0"));
  }
}

/// Returns a layout in which the unit of one quantity has the given name.
Json with_unit(const std::string& quantity, const std::string& name) {
  Json json = layout_to_json(full_document());
  json["units"][quantity] = name;
  return json;
}

// The schema and the library each have a list of the units; they must be the same.
TEST(LayoutDocument, TheSchemaAllowsTheUnitsThatTheLibraryKnows) {
  const std::vector<std::pair<std::string, Quantity>> quantities{
      {"length", Quantity::length}, {"time", Quantity::time}, {"mass", Quantity::mass}};
  for (const auto& [key, quantity] : quantities) {
    std::string listed = "[";
    for (const Units::Unit& unit : known_units(quantity)) {
      EXPECT_NO_THROW(validate_json(with_unit(key, unit.name), "layout", "in.json")) << unit.name;
      listed += (listed.size() > 1 ? ",\"" : "\"") + unit.name + "\"";
    }
    try {
      validate_json(with_unit(key, "furlong"), "layout", "in.json");
      FAIL();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("must be one of " + listed + "]"));
    }
  }
}

}  // namespace
}  // namespace beadswim
