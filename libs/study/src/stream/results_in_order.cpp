#include "stream/results_in_order.hpp"

#include <cstring>

namespace beadswim {
namespace {

/// Begin of a result as bytes. The line and the note follow.
struct Header {
  int number = 0;
  Findings findings;
  std::size_t line_size = 0;
};

Header header_of(const std::string& bytes) {
  Header header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  return header;
}

MemberResult result_of(const std::string& bytes) {
  const Header header = header_of(bytes);
  return {.line = bytes.substr(sizeof(header), header.line_size),
          .note = bytes.substr(sizeof(header) + header.line_size),
          .findings = header.findings};
}

}  // namespace

std::string to_bytes(int number, const MemberResult& result) {
  const Header header{.number = number, .findings = result.findings, .line_size = result.line.size()};
  return std::string(reinterpret_cast<const char*>(&header), sizeof(header)) + result.line + result.note;
}

ResultsInOrder::ResultsInOrder(const StreamSinks& sinks, std::vector<char> has_earlier)
    : sinks_(sinks), has_earlier_(std::move(has_earlier)) {
  take_available();
}

void ResultsInOrder::add(const std::string& bytes) {
  const int number = header_of(bytes).number;
  if (number == tally_.taken + 1) {
    take(number, result_of(bytes));
    take_available();
  } else {
    stored_.add({.text = bytes, .source = {}});
    waiting_[number] = stored_.size();
  }
}

void ResultsInOrder::take(int number, const MemberResult& result) {
  sinks_.take(number, result);
  tally_.taken = number;
  tally_.findings.failed += result.findings.failed;
  tally_.findings.warned += result.findings.warned;
  tally_.findings.incomplete += result.findings.incomplete;
  tally_.findings.negative += result.findings.negative;
}

void ResultsInOrder::take_available() {
  for (;;) {
    const int next = tally_.taken + 1;
    if (const auto found = waiting_.find(next); found != waiting_.end()) {
      take(next, result_of(stored_.member(found->second).text));
      waiting_.erase(found);
    } else if (next <= std::ssize(has_earlier_) && has_earlier_[next - 1]) {
      const std::optional<MemberResult> result = sinks_.earlier(next);
      if (!result) return;
      take(next, *result);
    } else {
      return;
    }
  }
}

}  // namespace beadswim
