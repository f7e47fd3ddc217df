#include "beadswim/study/stream.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "beadswim/core/error.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {
namespace {

StoredStream stream_of(int count) {
  StoredStream members;
  for (int i = 1; i <= count; ++i)
    members.add({.text = dump_json_line({{"study", {{"size", i}}}}), .source = "line " + std::to_string(i)});
  return members;
}

/// Lines of the results in the order in which they were taken.
struct Taken {
  std::vector<std::string> lines;
  StreamSinks sinks() {
    return {.program = "test", .take = [this](int number, const MemberResult& result) {
              EXPECT_EQ(number, std::ssize(lines) + 1);
              lines.push_back(result.line);
            }};
  }
};

// Catches results that are taken as they come, and members that two processes read at the same place.
TEST(StreamInProcesses, ResultsHaveTheOrderOfTheMembers) {
  const StoredStream members = stream_of(40);
  const auto work = [](const StreamMember& member) {
    const bool is_slow = member.number % 10 == 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(is_slow ? 30 : 0));
    return MemberResult{.line = member.text + member.source, .findings = {.warned = is_slow}};
  };
  Taken one, three;
  const StreamTally tally = work_in_processes(members, 1, work, one.sinks());
  EXPECT_EQ(tally.taken, 40);
  EXPECT_EQ(tally.findings.warned, 4);
  EXPECT_EQ(work_in_processes(members, 3, work, three.sinks()).findings.warned, 4);
  EXPECT_EQ(one.lines.at(16), members.member(17).text + "line 17");
  EXPECT_EQ(one.lines, three.lines);
}

TEST(StreamInProcesses, MemberWhoseProcessEndsIsAFailure) {
  Taken taken;
  const auto work = [](const StreamMember& member) {
    if (member.number == 2 || member.number == 7) ::_exit(9);
    if (member.number == 3) throw SolverError("no solution");
    return MemberResult{.line = "result\n"};
  };
  const StreamTally tally = work_in_processes(stream_of(9), 2, work, taken.sinks());
  EXPECT_EQ(tally.taken, 9);
  EXPECT_EQ(tally.findings.failed, 3);
  EXPECT_EQ(taken.lines.at(7), "result\n");
  const Json ended = Json::parse(taken.lines.at(6)), thrown = Json::parse(taken.lines.at(2));
  EXPECT_EQ(ended.at("reason"), "the process ended; its memory may not have been sufficient");
  EXPECT_EQ(ended.at("study").at("size"), 7);
  EXPECT_EQ(ended.at("member"), 7);
  EXPECT_EQ(thrown.at("reason"), "no solution");
}

}  // namespace
}  // namespace beadswim
