#pragma once

#include <map>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"

namespace beadswim {

/// Sends a fixed list of numbers between ranks, again and again. All ranks add the same numbers in the same
/// order. Each rank finds the numbers that it sends in the order in which they were added, and likewise the
/// numbers that it receives.
class NumberExchange {
 public:
  explicit NumberExchange(const Communicator& communicator);

  /// Adds a number that rank `from` sends to rank `to`.
  void add(int from, int to);

  std::span<double> to_send() { return to_send_; }
  std::span<const double> received() const { return received_; }

  /// Sends all numbers. Collective.
  void exchange(Traffic& traffic);

 private:
  struct Peer {
    std::vector<int> sent, received;  ///< places in to_send_ and received_
    std::vector<double> send, receive;
  };

  MPI_Comm comm_;
  int rank_;
  std::vector<double> to_send_, received_;
  std::map<int, Peer> peers_;
};

}  // namespace beadswim
