#pragma once

#include <map>
#include <set>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"

namespace beadswim {

/// Sends a fixed list of numbers between ranks, again and again. Each number that this rank sends or receives
/// has a place. The numbers that it sends are its own numbers and have the first places. A number that it
/// sends to itself has no other place.
class NumberExchange {
 public:
  explicit NumberExchange(const Communicator& communicator);

  /// Sets the number of own numbers. Call it before add().
  void set_own_count(int count) { numbers_.assign(count, 0); }

  /// Adds a number that rank `from` sends to rank `to`. `own`: its place on rank `from`, not used on other
  /// ranks. Returns its place on rank `to`, or -1 on other ranks. All ranks that send or receive numbers of
  /// a pair of ranks add them in the same order.
  int add(int from, int to, int own);

  double& operator[](int place) { return numbers_[place]; }
  double operator[](int place) const { return numbers_[place]; }
  double* data() { return numbers_.data(); }

  /// Returns the other ranks that exchange numbers with this rank.
  std::set<int> peers() const;

  /// Sends all numbers. Collective.
  void exchange(Traffic& traffic);

 private:
  struct Peer {
    std::vector<int> sent, received;  ///< places in numbers_
    std::vector<double> send, receive;
  };

  MPI_Comm comm_;
  int rank_;
  std::vector<double> numbers_;
  std::map<int, Peer> peers_;  ///< other ranks
};

}  // namespace beadswim
