#pragma once

#include <map>
#include <set>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/traffic.hpp"

namespace beadswim {

/// Sends a fixed list of numbers between ranks, again and again. All ranks add the same numbers in the same
/// order. Each number has a place on the rank that sends it and on the rank that receives it. A number that a
/// rank sends to itself has one place, so that it need not be copied.
class NumberExchange {
 public:
  explicit NumberExchange(const Communicator& communicator);

  /// Adds a number that rank `from` sends to rank `to`. Returns its place on this rank, or -1 if this rank
  /// neither sends nor receives it.
  int add(int from, int to);

  double& operator[](int place) { return numbers_[place]; }
  double operator[](int place) const { return numbers_[place]; }

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
