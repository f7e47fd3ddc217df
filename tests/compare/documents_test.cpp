#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/verdict_document.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/scene/units.hpp"

namespace beadswim {
namespace {

/// Returns a record in which every optional member has a value and all numbers are different.
RunRecord full_record() {
  RunRecord record;
  record.model = "lbm";
  record.status = RunStatus::stopped_signal;
  record.units = {false, {"um", 1e-6}, {"ms", 1e-3}, {"pg", 1e-15}};
  record.domain.box = Box{{120, 80, 70}, {Boundary::periodic, Boundary::free_slip, Boundary::no_slip}};
  record.driving = {.period = 4800.5, .amplitude = {{0.2, 0.4}}, .phase = -1.5};
  CycleStatistics cycle;
  cycle.index = 3;
  cycle.velocity = Vec3(1e-5, 2e-5, 3e-5);
  cycle.axis = Vec3(0, 0.6, 0.8);
  cycle.speed_along_axis = 3.6e-5;
  cycle.mean_flow = Vec3(4e-9, 5e-9, 6e-9);
  cycle.arm_amplitudes = {3.5, 5.5};
  cycle.arm_phases = {-1.9, 3.1};
  cycle.arm_means = {20.25, 20.75};
  record.swimmers = {{7, {cycle}, 163.75}, {9, {}, {}}};
  record.momentum = MomentumRecord{Vec3(1e-9, 2e-9, 3e-9), Vec3(4, 5, 6)};
  record.mass_relative_change = -1e-14;
  record.dimensionless = {0.15, 5.6, 0.01};
  record.resolution = LatticeResolution{.cells_per_radius = 4,
                                        .cell_size = 0.5,
                                        .time_step = 0.25,
                                        .relaxation_time = 1.5,
                                        .kinematic_viscosity_lattice = 1.0 / 3,
                                        .steps_per_cycle = 19202,
                                        .bead_boundary = "cli",
                                        .density_on_lattice = 1.2344,
                                        .radius_on_lattice = 4.0209,
                                        .angular_softening = 0.25,
                                        .precision = "single",
                                        .levels = {}};
  const Vec3 corner(8, 8, 8);
  record.resolution->levels = {{.cell = 1, .boxes = {{Vec3::Zero(), 4 * corner}}, .cells = 32768},
                               {.cell = 0.5, .boxes = {{corner, 2 * corner}}, .cells = 4096}};
  record.cost = RunCost{.wall_seconds = 10.5,
                        .core_seconds = 21,
                        .cycles = 2.5,
                        .ranks = 2,
                        .cell_updates = 768000000000,
                        .mlups = 80,
                        .peak_memory_bytes = 5000000000,
                        .communication = CommunicationRecord{3, 14.25, 1176012.5}};
  record.reason = "the time is over";
  record.near_contact = NearContactRecord{.smallest_gap = 0.25,
                                          .lubrication = true,
                                          .normal_cut_off = 0.6,
                                          .tangential_cut_off = 0.5,
                                          .friction = 0.4};
  record.state_sha256 = std::string(64, 'a');
  record.provenance = Json::array({{{"program", "beadswim-run"}}});
  record.scene = paper_single();
  record.scene->units = record.units;
  return record;
}

/// Returns the record after it was written to text and read from it, as when one program passes it to
/// another.
RunRecord through_text(const RunRecord& record) {
  const std::string text = dump_json(run_record_to_json(record, RecordProvenance::written));
  return run_record_from_json(parse_json(text, "r.json"), "r.json");
}

// Would catch a member that is written but not read, read from another's key, or rounded.
TEST(RunRecord, SurvivesTheWayThroughText) {
  const RunRecord record = full_record();
  EXPECT_EQ(run_record_to_json(through_text(record), RecordProvenance::written),
            run_record_to_json(record, RecordProvenance::written));
  const CycleStatistics cycle = through_text(record).swimmers[0].cycles[0];
  EXPECT_EQ(cycle.mean_flow, Vec3(4e-9, 5e-9, 6e-9));
  EXPECT_EQ(cycle.arm_phases[1], 3.1);
  EXPECT_EQ(through_text(record).resolution->kinematic_viscosity_lattice, 1.0 / 3);
  EXPECT_EQ(through_text(record).resolution->density_on_lattice, 1.2344);
  EXPECT_EQ(through_text(record).reason, "the time is over");
  EXPECT_EQ(through_text(record).near_contact->smallest_gap, 0.25);
  EXPECT_EQ(through_text(record).near_contact->tangential_cut_off, 0.5);
  EXPECT_EQ(through_text(record).resolution->radius_on_lattice, 4.0209);
  EXPECT_EQ(through_text(record).resolution->angular_softening, 0.25);
  EXPECT_EQ(through_text(record).scene->fluid.kinematic_viscosity, 1.0 / 3);
  EXPECT_EQ(through_text(record).scene->units, record.units);
}

TEST(RunRecord, SurvivesWithoutWhatAModelMayLack) {
  RunRecord record = full_record();
  record.units = {};
  record.driving = {.period = 4800.5, .amplitude = {}, .phase = {}};
  record.domain.box.reset();
  record.momentum.reset();
  record.mass_relative_change.reset();
  record.dimensionless.mach.reset();
  record.resolution.reset();
  record.cost->cell_updates.reset();
  record.cost->mlups.reset();
  const RunRecord read = through_text(record);
  EXPECT_TRUE(read.units.lattice);
  EXPECT_FALSE(read.domain.box || read.momentum || read.mass_relative_change || read.resolution);
  EXPECT_EQ(run_record_to_json(read, RecordProvenance::written),
            run_record_to_json(record, RecordProvenance::written));
}

// The scene is the layout document without units, resolution and provenance.
TEST(RunRecord, SceneHasTheKeysOfALayout) {
  const Json record = run_record_to_json(full_record(), RecordProvenance::written);
  Json layout = layout_to_json({.layout = paper_single()});
  for (const char* key : {"schema", "units", "resolution", "provenance"}) layout.erase(key);
  EXPECT_EQ(record["scene"], layout);
}

TEST(RunRecord, AFaultInTheSceneIsFound) {
  Json document = run_record_to_json(full_record(), RecordProvenance::written);
  document["scene"]["swimmers"][0]["type"] = "c";
  try {
    run_record_from_json(document, "r.json");
    FAIL() << "the unknown type was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("the scene in r.json:/swimmers/0/type: ", 0), 0)
        << error.what();
  }
}

TEST(RunRecord, LeavesOutWhatDiffersFromRunToRun) {
  const Json document = run_record_to_json(full_record(), RecordProvenance::left_out);
  EXPECT_TRUE(document.contains("scene"));
  EXPECT_FALSE(document.contains("cost"));
  EXPECT_FALSE(document.contains("provenance"));
  EXPECT_NO_THROW(run_record_from_json(document, "r.json"));
}

TEST(RunRecord, RefusesValuesThatCannotBe) {
  const auto refused = [](const char* pointer, const Json& value) {
    Json document = run_record_to_json(full_record(), RecordProvenance::written);
    document[Json::json_pointer(pointer)] = value;
    EXPECT_THROW(run_record_from_json(document, "r.json"), InputError) << pointer;
  };
  refused("/status", "done");
  refused("/driving/period", 0);
  refused("/domain/boundary/0", "open");
  refused("/swimmers/0/cycles/0/arm_amplitudes/0", -1);
  refused("/swimmers/0/cycles/0/arm_phases/0", 3.2);
  refused("/resolution/relaxation_time", 0.5);
  refused("/near_contact/friction", -1);
  refused("/state_sha256", "abc");
  refused("/scene/fluid/density", 0);
  refused("/scene/units", "lattice");
  refused("/unheard_of", 1);
}

ComparisonRow row_with_error(double relative_error) {
  ComparisonRow row;
  row.run_file = "r.json";
  row.reference_file = "p.json";
  row.method = "rpy-ode";
  row.run = 1;
  row.tolerance = 0.05;
  row.relative_error = relative_error;
  row.pass = row.decides = true;
  return row;
}

TEST(VerdictDocument, FollowsItsSchema) {
  const VerdictDocument document{
      "rpy-ode", {row_with_error(0.01)}, VerdictCost{1, 2, 3}, {{"arm", "20", "20, 21"}}};
  const Json json = verdict_to_json(document);
  EXPECT_NO_THROW(validate_json(json, "verdict", "v.json"));
  EXPECT_EQ(json["pass"], true);
  EXPECT_EQ(verdict_from_json(json, "v.json").scene_differences, document.scene_differences);
}

// The schema lists the names of all properties.
TEST(VerdictDocument, EveryPropertyOfTheSceneFollowsTheSchema) {
  VerdictDocument document{"rpy-ode", {row_with_error(0.01)}, {}};
  for (const std::string& property : scene_property_names())
    document.scene_differences.push_back({property, "1", "2"});
  EXPECT_NO_THROW(validate_json(verdict_to_json(document), "verdict", "v.json"));
}

TEST(VerdictDocument, AnOlderVerdictHasNoSceneDifferences) {
  Json json = verdict_to_json({"rpy-ode", {row_with_error(0.01)}, {}});
  EXPECT_EQ(json["scene_differences"], Json::array());
  json.erase("scene_differences");
  EXPECT_TRUE(verdict_from_json(json, "v.json").scene_differences.empty());
}

TEST(VerdictDocument, AnInfiniteErrorIsNull) {
  const VerdictDocument document{"rpy-ode", {row_with_error(std::numeric_limits<double>::infinity())}, {}};
  const Json json = verdict_to_json(document);
  EXPECT_TRUE(json["rows"][0]["relative_error"].is_null());
  EXPECT_NO_THROW(validate_json(json, "verdict", "v.json"));
  EXPECT_NO_THROW(dump_json(json));
}

TEST(VerdictDocument, CostIsTheSumOrUnknown) {
  const RunCost cost{
      .wall_seconds = 1, .core_seconds = 2, .cell_updates = 3, .mlups = {}, .communication = {}};
  const auto total = total_cost(std::vector<std::optional<RunCost>>{cost, cost});
  ASSERT_TRUE(total);
  EXPECT_EQ(total->core_seconds, 4);
  EXPECT_EQ(total->cell_updates, 6);
  EXPECT_FALSE(total_cost(std::vector<std::optional<RunCost>>{cost, std::nullopt}));
}

TEST(Units, AreTheSameOnlyInNameAndSize) {
  const Units si{false, {"um", 1e-6}, {"s", 1}, {"pg", 1e-15}};
  Units other = si;
  EXPECT_EQ(si, other);
  EXPECT_NE(si, Units());
  other.time.si_factor = 2;
  EXPECT_NE(si, other);
}

TEST(MotionScaleOfARun, IsThatOfItsFastestBead) {
  RunRecord record;
  record.driving.period = 100;
  SwimmerRecord swimmer{.id = 0, .cycles = {CycleStatistics{}}, .period = {}};
  swimmer.cycles.front().velocity = Vec3(0, 0, 1e-3);
  swimmer.cycles.front().arm_amplitudes = {1e-15};
  swimmer.cycles.front().arm_means = {20};
  EXPECT_EQ(motion_scale_of(record, swimmer, {}, "r.json").speed, 1e-3);
  record.scene = paper_single();
  record.dimensionless.reynolds_bead = 0.4;
  const double diameter = 2 * smallest_radius(*record.scene), nu = record.scene->fluid.kinematic_viscosity;
  const MotionScale scale = motion_scale_of(record, swimmer, {}, "r.json");
  EXPECT_DOUBLE_EQ(scale.speed, 0.4 * nu / diameter);
  EXPECT_EQ(scale.length, 20);
  EXPECT_EQ(scale.numerical_error, 0);
  record.mobility = MobilityRecord{};
  record.mobility->tolerance = 1e-3;
  record.mobility->cut_off = 30;
  EXPECT_DOUBLE_EQ(motion_scale_of(record, swimmer, {}, "r.json").numerical_error, 1e-3 * scale.speed);
}

}  // namespace
}  // namespace beadswim
