#include "beadswim/core/fields.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/io/h5md.hpp"

// Tests that a field which is added to the list of fields of a record also appears in all forms that are made
// from the record.

namespace beadswim {

struct Limits {
  double largest = 0, error = 0;
  std::optional<double> gap, mach;
  std::vector<int> steps;

  static void visit_fields(auto&& visit, auto& limits) {
    visit("largest", limits.largest);
    visit("gap", limits.gap);
    visit("mach", limits.mach, omitted_if_none);
    visit("steps", limits.steps, omitted_if_none);
    visit("error", limits.error, null_if_infinite);
  }
};

struct Link {
  std::array<int, 2> beads{};
  int multiple = 1;
  std::string word{};
  Vec3 direction = Vec3::UnitX();

  static void visit_fields(auto&& visit, auto& link) {
    visit("beads", link.beads, counted_from_one);
    visit("multiple", link.multiple, omitted_if(1));
    visit("word", link.word, omitted_when(link.multiple == 1));
    visit("direction", link.direction, of_unit_length);
  }
};

namespace {

struct Cycle : CycleStatistics {
  double energy = 0;

  static void visit_fields(auto&& visit, auto& cycle) {
    CycleStatistics::visit_fields(visit, cycle);
    visit("energy", cycle.energy);
  }
};

class AddedField : public testing::Test {
 protected:
  AddedField() {
    cycle_.velocity = Vec3(1, 2, 3);
    cycle_.arm_amplitudes = cycle_.arm_phases = cycle_.arm_means = {1, 2};
    cycle_.energy = 0.375;
    std::filesystem::create_directories(folder_);
  }
  ~AddedField() override { std::filesystem::remove_all(folder_); }

  std::vector<char> bytes() const {
    OutgoingMessage message;
    message(cycle_);
    return message.bytes();
  }
  static Cycle from_bytes(std::vector<char> bytes) {
    IncomingMessage message(std::move(bytes));
    Cycle cycle;
    message(cycle);
    return cycle;
  }

  Cycle cycle_;
  Communicator communicator_{MPI_COMM_SELF};
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("fields_test." + std::to_string(getpid()));
};

TEST_F(AddedField, ArrivesByMessage) {
  EXPECT_EQ(from_bytes(bytes()).energy, 0.375);
  EXPECT_EQ(from_bytes(bytes()).velocity, Vec3(1, 2, 3));
}

TEST_F(AddedField, IsHashed) {
  const auto hash = [this] {
    Sha256 sha;
    const std::vector<char> message = bytes();
    sha.update(std::as_bytes(std::span(message)));
    return sha.hexadecimal();
  };
  const std::string before = hash();
  cycle_.energy = 0.5;
  EXPECT_NE(hash(), before);
}

TEST_F(AddedField, IsInCheckpoints) {
  const std::string path = folder_ / "one.ckpt";
  CheckpointWriter writer(path, communicator_);
  writer.add("cycle", bytes());
  writer.finish();
  const CheckpointReader reader(path, communicator_);
  EXPECT_EQ(from_bytes(reader.bytes("cycle")).energy, 0.375);
}

TEST_F(AddedField, IsInJson) {
  EXPECT_EQ(Json(cycle_).at("energy").get<double>(), 0.375);
  EXPECT_EQ(Json(cycle_).get<Cycle>().energy, 0.375);
}

TEST_F(AddedField, IsAColumnOfTrajectories) {
  const std::string path = folder_ / "one.h5md";
  const std::vector<Column> columns = columns_of<Cycle>({cycle_});
  {
    const TrajectoryHeader header{.swimmer = {0, 0, 0},
                                  .bead = {1, 2, 3},
                                  .radius = {1, 1, 1},
                                  .creator_version = "1",
                                  .cycle_columns = columns};
    TrajectoryWriter writer(path, header, communicator_);
    writer.append(TrajectoryFrame{.positions = std::vector<Vec3>(3, Vec3::Zero()),
                                  .velocities = std::vector<Vec3>(3, Vec3::Zero())});
    writer.append(TrajectoryCycle{.step = 1, .time = 1, .columns = columns});
    writer.finish();
  }
  const std::vector<TrajectoryCycle> cycles = TrajectoryReader(path).cycles(columns_of<Cycle>({}));
  const Cycle read = records_of<Cycle>(cycles.at(0).columns, 1)[0];
  EXPECT_EQ(read.energy, 0.375);
  EXPECT_EQ(read.arm_means, (std::vector{1.0, 2.0}));
}

/// Catches keys in another order, null for what should be missing, and the reverse.
TEST(FieldsInJson, AreNullOrMissingAsTheirMarksSay) {
  const Limits none{
      .largest = 1.5, .error = std::numeric_limits<double>::infinity(), .gap = {}, .mach = {}, .steps = {}};
  EXPECT_EQ(Json(none).dump(), R"({"largest":1.5,"gap":null,"error":null})");
  EXPECT_EQ(Json(Json(none).get<Limits>()), Json(none));
  const Limits all{.largest = 1.5, .error = 0.25, .gap = 2.0, .mach = 0.5, .steps = {1, 2}};
  EXPECT_EQ(Json(all).dump(), R"({"largest":1.5,"gap":2.0,"mach":0.5,"steps":[1,2],"error":0.25})");
  EXPECT_EQ(Json(Json(all).get<Limits>()), Json(all));
}

/// Catches an object that replaces more of a record than it contains.
TEST(FieldsInJson, KeepTheirValuesWhereAKeyIsMissing) {
  Limits limits{.largest = 1.5, .error = 0.25, .gap = 2.0, .mach = 0.5, .steps = {1, 2}};
  Json{{"error", nullptr}, {"steps", {3}}}.get_to(limits);
  EXPECT_EQ(Json(limits).dump(), R"({"largest":1.5,"gap":2.0,"mach":0.5,"steps":[3],"error":null})");
}

TEST(FieldsInJson, HaveTheFormThatTheirMarksSay) {
  const Link link{.beads = {0, 4}};
  EXPECT_EQ(Json(link).dump(), R"({"beads":[1,5],"direction":[1.0,0.0,0.0]})");
  const Json json = Json::parse(R"({"beads":[1,5],"multiple":3,"word":"a","direction":[0.0,2.0,0.0]})");
  const Link read = json.get<Link>();
  EXPECT_EQ(read.beads, (std::array{0, 4}));
  EXPECT_EQ(Json(read).dump(), R"({"beads":[1,5],"multiple":3,"word":"a","direction":[0.0,1.0,0.0]})");
}

}  // namespace
}  // namespace beadswim
