#include "beadswim/study/stored_stream.hpp"

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

}  // namespace beadswim
