#include "number_exchange.hpp"

namespace beadswim {

NumberExchange::NumberExchange(const Communicator& communicator)
    : comm_(communicator.get()), rank_(communicator.rank()) {}

void NumberExchange::add(int from, int to) {
  if (from == rank_) {
    peers_[to].sent.push_back(static_cast<int>(to_send_.size()));
    to_send_.push_back(0);
  }
  if (to == rank_) {
    peers_[from].received.push_back(static_cast<int>(received_.size()));
    received_.push_back(0);
  }
}

void NumberExchange::exchange(Traffic& traffic) {
  constexpr int tag = 21;  // Halo and BeadExchange use other tags
  std::vector<MPI_Request> requests;
  for (auto& [other, peer] : peers_) {
    if (other == rank_) continue;
    peer.receive.resize(peer.received.size());
    if (!peer.receive.empty())
      MPI_Irecv(peer.receive.data(), static_cast<int>(peer.receive.size()), MPI_DOUBLE, other, tag, comm_,
                &requests.emplace_back());
    peer.send.clear();
    for (const int place : peer.sent) peer.send.push_back(to_send_[place]);
    if (peer.send.empty()) continue;
    MPI_Isend(peer.send.data(), static_cast<int>(peer.send.size()), MPI_DOUBLE, other, tag, comm_,
              &requests.emplace_back());
    traffic.add_message(static_cast<long>(peer.send.size() * sizeof(double)));
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (auto& [other, peer] : peers_) {
    for (std::size_t n = 0; n < peer.received.size(); ++n)
      received_[peer.received[n]] = other == rank_ ? to_send_[peer.sent[n]] : peer.receive[n];
  }
}

}  // namespace beadswim
