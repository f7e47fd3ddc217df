#include "beadswim/core/fields.hpp"

#include <gtest/gtest.h>

#include "beadswim/core/message.hpp"

// Tests of the list of fields that each record type has, and of the bytes that messages and checkpoints make
// from it.

namespace beadswim {
namespace {

struct Load {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();

  static void visit_fields(auto&& visit, auto& load) {
    visit("force", load.force);
    visit("torque", load.torque);
  }
};

/// Record with one field of each kind. Each number in it is a different multiple of 1/8.
struct Swimmer {
  std::optional<Load> drag;
  std::array<Load, 2> loads;
  std::vector<double> samples;
  Load total;
  std::array<Load, 2> inner;
  std::array<Vec3, 2> places{Vec3::Zero(), Vec3::Zero()};
  double radius = 0;

  static void visit_fields(auto&& visit, auto& swimmer) {
    visit("drag", swimmer.drag, omitted_if_none);
    visit("loads", swimmer.loads);
    visit("samples", swimmer.samples);
    visit("total", swimmer.total);
    visit("inner", swimmer.inner);
    visit("places", swimmer.places);
    visit("radius", swimmer.radius);
  }
};

/// Returns a load whose components are n + 1/8, n + 2/8, ..., n + 6/8.
Load load(int n) {
  return {.force = Vec3(1, 2, 3) / 8 + Vec3::Constant(n), .torque = Vec3(4, 5, 6) / 8 + Vec3::Constant(n)};
}

Swimmer swimmer() {
  return {.drag = load(1),
          .loads = {load(2), load(3)},
          .samples = {40, 41},
          .total = load(5),
          .inner = {load(6), load(7)},
          .places = {Vec3::Constant(8), Vec3::Constant(9)},
          .radius = 10};
}

template <class... T>
std::vector<char> bytes_of(const T&... values) {
  OutgoingMessage message;
  message(values...);
  return message.bytes();
}

/// Catches another order of bytes, which would make checkpoints of older programs unreadable.
TEST(Fields, AreLaidOutInMessagesAsInCheckpointsOfOlderPrograms) {
  const Swimmer s = swimmer();
  EXPECT_EQ(bytes_of(s), bytes_of(s.places[0], s.places[1], s.radius,              // plain values
                                  s.total.force, s.total.torque,                   // nested records
                                  s.loads[0], s.inner[0], s.loads[1], s.inner[1],  // arrays of records
                                  std::uint8_t{1}, *s.drag, std::size_t{2}, 40.0, 41.0));
}

/// Catches a field that is left out in one direction, and kinds that are read in another order than written.
TEST(Fields, ArriveInMessages) {
  Swimmer arrived;
  IncomingMessage message(bytes_of(swimmer()));
  message(arrived);
  EXPECT_TRUE(message.is_at_end());
  EXPECT_EQ(arrived.drag->torque, load(1).torque);
  EXPECT_EQ(arrived.loads[1].force, load(3).force);
  EXPECT_EQ(arrived.samples, (std::vector<double>{40, 41}));
  EXPECT_EQ(arrived.total.torque, load(5).torque);
  EXPECT_EQ(arrived.inner[0].force, load(6).force);
  EXPECT_EQ(arrived.places[1], Vec3::Constant(9));
  EXPECT_EQ(arrived.radius, 10);
}

/// The byte of a damaged file that says whether there is a value may be any.
TEST(Fields, AreRefusedInDamagedMessages) {
  std::optional<double> value;
  EXPECT_THROW(IncomingMessage(std::vector<char>{2, 0, 0, 0, 0, 0, 0, 0, 0})(value), SolverError);
  std::vector<char> cut = bytes_of(swimmer());
  cut.pop_back();
  Swimmer damaged;
  EXPECT_THROW(IncomingMessage{cut}(damaged), SolverError);
}

}  // namespace
}  // namespace beadswim
