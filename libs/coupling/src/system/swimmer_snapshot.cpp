#include "beadswim/coupling/swimmer_snapshot.hpp"

#include "beadswim/core/message.hpp"

namespace beadswim {

std::vector<char> bytes_of(const std::vector<SwimmerSnapshot>& snapshots) {
  OutgoingMessage message;
  for (const SwimmerSnapshot& snapshot : snapshots) message(snapshot);
  return message.bytes();
}

std::vector<SwimmerSnapshot> snapshots_from_bytes(std::vector<char> bytes) {
  std::vector<SwimmerSnapshot> snapshots;
  IncomingMessage message(std::move(bytes));
  while (!message.is_at_end()) message(snapshots.emplace_back());
  return snapshots;
}

std::size_t snapshot_size(std::size_t beads) {
  return bytes_of({SwimmerSnapshot{.state = SwimmerState::of_beads(beads),
                                   .pending_impulses = std::vector<Impulse>(beads)}})
      .size();
}

}  // namespace beadswim
