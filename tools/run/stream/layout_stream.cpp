#include "stream/layout_stream.hpp"

#include "beadswim/core/error.hpp"

namespace beadswim {

void throw_together(std::string fault, const Communicator& communicator) {
  broadcast(fault, communicator);
  if (!fault.empty()) throw InputError(fault);
}

LayoutStream::LayoutStream(const Request& request, const Communicator& communicator)
    : communicator_(communicator) {
  const RunOptions& options = request.options;
  std::string fault;
  if (communicator.is_root() && !(request.checkpoint && !options.names_layouts)) {
    try {
      documents_.emplace(options.layouts);
      is_stream_ = !documents_->is_single() || options.output.find(number_mark) != std::string::npos;
      for (std::optional<StreamMember> member; is_stream_ && (member = documents_->next());)
        layout_of(*member);
      documents_->rewind();
    } catch (const InputError& error) {
      fault = error.what();
    }
  }
  throw_together(fault, communicator);
  MPI_Bcast(&is_stream_, 1, MPI_C_BOOL, 0, communicator.get());
}

std::optional<StreamMember> LayoutStream::next() {
  std::optional<StreamMember> member = documents_ ? documents_->next() : std::nullopt;
  int number = member ? member->number : 0;
  MPI_Bcast(&number, 1, MPI_INT, 0, communicator_.get());
  if (number == 0) return std::nullopt;
  if (!member) member.emplace();
  member->number = number;
  for (std::string* text : {&member->text, &member->source}) broadcast(*text, communicator_);
  return member;
}

StoredLayouts::StoredLayouts(LayoutStream& layouts) {
  while (const std::optional<StreamMember> member = layouts.next()) {
    members_.push_back({.start = bytes_, .source = member->source});
    append(file_, member->text);
    bytes_ += std::ssize(member->text);
  }
}

StreamMember StoredLayouts::member(int number) const {
  const Member& member = members_.at(number - 1);
  const std::int64_t end = number < size() ? members_[number].start : bytes_;
  return {
      .text = read_bytes(file_, member.start, end - member.start), .source = member.source, .number = number};
}

}  // namespace beadswim
