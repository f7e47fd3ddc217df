#include "beadswim/study/stream.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/documents/failure_document.hpp"

namespace beadswim {

MemberResult failure_of(const StreamMember& member, const std::string& program, const std::string& reason) {
  const Json document = Json::parse(member.text, nullptr, false);
  const Json study = document.is_object() ? document.value("study", Json()) : Json();
  return {
      .line = failure_line({.program = program, .member = member.number, .reason = reason, .study = study}),
      .note = reason,
      .findings = {.failed = 1}};
}

void StreamProgress::update(double done, int before) {
  const Clock::time_point now = Clock::now();
  if (!message_ || now - last_ < std::chrono::seconds(10)) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double own = done - before;
  const std::string left =
      own > 0 ? fmt::format(", about {:.0f} s left", seconds / own * (count_ - done)) : "";
  const std::string parts = fmt::format("{:.{}f}", done, done == std::floor(done) ? 0 : 1);
  message_(fmt::format("{} of {} {} done{}", parts, count_, what_, left));
}

}  // namespace beadswim
