#pragma once

#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "beadswim/core/communicator.hpp"

namespace beadswim {

/// Sends lists[r] to rank r. Returns the lists that this rank received, one per rank. Collective.
template <class T>
std::vector<std::vector<T>> all_to_all(const std::vector<std::vector<T>>& lists,
                                       const Communicator& communicator) {
  std::vector<int> sent, received(lists.size()), sent_at, received_at(lists.size());
  std::vector<T> outgoing;
  for (const std::vector<T>& list : lists) {
    sent.push_back(static_cast<int>(list.size()));
    sent_at.push_back(static_cast<int>(outgoing.size()));
    outgoing.insert(outgoing.end(), list.begin(), list.end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, communicator.get());
  std::exclusive_scan(received.begin(), received.end(), received_at.begin(), 0);
  std::vector<T> incoming(received_at.back() + received.back());
  MPI_Datatype type;
  MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Alltoallv(outgoing.data(), sent.data(), sent_at.data(), type, incoming.data(), received.data(),
                received_at.data(), type, communicator.get());
  MPI_Type_free(&type);
  std::vector<std::vector<T>> arrived;
  for (std::size_t r = 0; r < lists.size(); ++r) {
    const auto first = incoming.begin() + received_at[r];
    arrived.emplace_back(first, first + received[r]);
  }
  return arrived;
}

/// Sends a fixed list of numbers between ranks, again and again. Each number that this rank sends or receives
/// has a place. Its own numbers, which it sends, have the first places.
class NumberExchange {
 public:
  explicit NumberExchange(const Communicator& communicator) : comm_(communicator.get()) {}

  /// Sets the number of own numbers. Call it before the two following functions. Two ranks add the numbers
  /// that one of them sends to the other in the same order.
  void set_own_count(int count) { numbers_.assign(count, 0); }
  void add_sent(int to, int place) { peers_[to].sent.push_back(place); }
  /// Returns the place of the received number.
  int add_received(int from) {
    const int place = static_cast<int>(numbers_.size());
    numbers_.push_back(0);
    peers_[from].received.push_back(place);
    return place;
  }

  double& operator[](int place) { return numbers_[place]; }
  double operator[](int place) const { return numbers_[place]; }
  double* data() { return numbers_.data(); }
  const double* data() const { return numbers_.data(); }

  /// Returns the other ranks that exchange numbers with this rank.
  std::set<int> peers() const {
    std::set<int> others;
    for (const auto& [other, peer] : peers_) others.insert(other);
    return others;
  }

  /// Sends all numbers. Collective.
  void exchange(Traffic& traffic) {
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

 private:
  struct Peer {
    std::vector<int> sent, received;  ///< places in numbers_
    std::vector<double> send, receive;
  };

  MPI_Comm comm_;
  std::vector<double> numbers_;
  std::map<int, Peer> peers_;  ///< other ranks
};

}  // namespace beadswim
