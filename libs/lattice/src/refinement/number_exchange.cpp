#include "number_exchange.hpp"

namespace beadswim {

NumberExchange::NumberExchange(const Communicator& communicator)
    : comm_(communicator.get()), rank_(communicator.rank()) {}

int NumberExchange::add(int from, int to, int own) {
  if (from == rank_ && to == rank_) return own;
  if (from == rank_) peers_[to].sent.push_back(own);
  if (to != rank_) return -1;
  const int place = static_cast<int>(numbers_.size());
  numbers_.push_back(0);
  peers_[from].received.push_back(place);
  return place;
}

std::set<int> NumberExchange::peers() const {
  std::set<int> others;
  for (const auto& [other, peer] : peers_) others.insert(other);
  return others;
}

void NumberExchange::exchange(Traffic& traffic) {
  constexpr int tag = 21;  // Halo and BeadExchange use other tags
  std::vector<MPI_Request> requests;
  for (auto& [other, peer] : peers_) {
    peer.receive.resize(peer.received.size());
    if (!peer.receive.empty())
      MPI_Irecv(peer.receive.data(), static_cast<int>(peer.receive.size()), MPI_DOUBLE, other, tag, comm_,
                &requests.emplace_back());
    peer.send.clear();
    for (const int place : peer.sent) peer.send.push_back(numbers_[place]);
    if (peer.send.empty()) continue;
    MPI_Isend(peer.send.data(), static_cast<int>(peer.send.size()), MPI_DOUBLE, other, tag, comm_,
              &requests.emplace_back());
    traffic.add_message(static_cast<long>(peer.send.size() * sizeof(double)));
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (auto& [other, peer] : peers_) {
    for (std::size_t n = 0; n < peer.received.size(); ++n) numbers_[peer.received[n]] = peer.receive[n];
  }
}

}  // namespace beadswim
