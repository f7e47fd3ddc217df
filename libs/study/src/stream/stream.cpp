#include "beadswim/study/stream.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/documents/failure_document.hpp"

namespace beadswim {

StoredStream::StoredStream(DocumentStream& documents, const std::function<void(const StreamMember&)>& check) {
  while (const std::optional<StreamMember> member = documents.next()) {
    check(*member);
    add(*member);
  }
}

void StoredStream::add(const StreamMember& member) {
  members_.push_back({.start = bytes_, .source = member.source});
  append(file_, member.text);
  bytes_ += std::ssize(member.text);
}

StreamMember StoredStream::member(int number) const {
  const Member& member = members_.at(number - 1);
  const std::int64_t end = number < size() ? members_[number].start : bytes_;
  return {
      .text = read_bytes(file_, member.start, end - member.start), .source = member.source, .number = number};
}

void StoredStream::share(const Communicator& communicator) {
  int count = size();
  MPI_Bcast(&count, 1, MPI_INT, 0, communicator.get());
  for (int number = 1; number <= count; ++number) {
    StreamMember next = communicator.is_root() ? member(number) : StreamMember{};
    for (std::string* text : {&next.text, &next.source}) broadcast(*text, communicator);
    if (!communicator.is_root()) add(next);
  }
}

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
