#include "beadswim/study/rank_groups.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

constexpr int count = 30;

StoredStream stream_of_root(const Communicator& communicator) {
  StoredStream members;
  for (int i = 1; i <= count && communicator.is_root(); ++i)
    members.add({.text = dump_json_line({{"study", {{"size", i}}}}), .source = "line " + std::to_string(i)});
  members.share(communicator);
  return members;
}

/// All members but the last two are treated by groups of one rank.
StreamSchedule schedule() {
  StreamSchedule schedule{.side_by_side = std::vector<int>(count - 2), .on_all_ranks = {count - 1, count}};
  std::iota(schedule.side_by_side.begin(), schedule.side_by_side.end(), 1);
  return schedule;
}

/// Line of a result that is too long for messages without a rendezvous.
std::string line_of(int number) {
  std::string line(20000, static_cast<char>('a' + number % 26));
  line.back() = '\n';
  return line;
}

// Catches results that are taken as they come, lost messages, and earlier results that are made again.
TEST(StreamOnRanks, ResultsHaveTheOrderOfTheMembers) {
  const Communicator communicator(MPI_COMM_WORLD);
  const StoredStream members = stream_of_root(communicator);
  int taken = 0;
  const StreamSinks sinks{.program = "test",
                          .take =
                              [&](int number, const MemberResult& result) {
                                EXPECT_EQ(number, ++taken);
                                EXPECT_EQ(result.findings.failed, number == 5);
                                EXPECT_TRUE(number == 5 || result.line == line_of(number));
                              },
                          .earlier = [](int number) -> std::optional<MemberResult> {
                            if (number != 3 && number != 4) return std::nullopt;
                            return MemberResult{.line = line_of(number), .findings = {.warned = 1}};
                          }};
  const auto work = [&](const StreamMember& member, const RankGroup& group) {
    EXPECT_EQ(group.ranks.size(), member.number > count - 2 ? communicator.size() : 1);
    EXPECT_TRUE(member.number != 3 && member.number != 4);
    group.progress(0.5);
    if (member.number == 5) throw InputError("no result");
    return MemberResult{.line = line_of(member.number)};
  };
  const StreamTally tally = work_on_ranks(members, schedule(), work, sinks, communicator);
  EXPECT_EQ(tally.taken, count);
  EXPECT_EQ(tally.findings.failed, 1);
  EXPECT_EQ(tally.findings.warned, 2);
  EXPECT_FALSE(tally.is_stopped);
  EXPECT_EQ(taken, communicator.is_root() ? count : 0);
}

// Catches groups that go on after another one was stopped.
TEST(StreamOnRanks, StopOfOneRankStopsAll) {
  const Communicator communicator(MPI_COMM_WORLD);
  const StoredStream members = stream_of_root(communicator);
  const bool is_last = communicator.rank() == communicator.size() - 1;
  int treated = 0;
  const auto work = [&](const StreamMember& member, const RankGroup& group) {
    if (!is_last)
      while (!group.is_to_stop()) {  // until the last rank has stopped
        group.progress(0);
      }
    if (++treated == 3 || !is_last) throw StoppedEarly("");
    return MemberResult{.line = line_of(member.number)};
  };
  const StreamSinks sinks{.program = "test",
                          .take = [](int, const MemberResult&) {},
                          .stop = [&] { return is_last && treated == 2; }};
  const StreamTally tally = work_on_ranks(members, schedule(), work, sinks, communicator);
  EXPECT_TRUE(tally.is_stopped);
  EXPECT_LT(tally.taken, 3);
}

}  // namespace
}  // namespace beadswim
