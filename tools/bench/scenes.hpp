#pragma once

#include <memory>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "bench_case.hpp"
#include "yardstick.hpp"

namespace beadswim {

/// Everything that is timed for cubes of one edge, `edge` cells a rank and axis, on the ranks of one
/// communicator; holds the memory that the cases work on.
class BenchScenes {
 public:
  BenchScenes(int edge, const std::vector<Precision>& precisions, BeadScheme bead_boundary,
              const Communicator& communicator);
  ~BenchScenes();

  /// In the order in which they are to be timed, round by round.
  const std::vector<BenchCase>& cases() const { return cases_; }

  /// Of the yardstick.
  std::string layout_name(Precision precision) const;

  /// Bytes that one rank needs for them.
  static double bytes(int edge, const std::vector<Precision>& precisions);

 private:
  struct Scene;
  std::vector<std::unique_ptr<Scene>> scenes_;
  std::vector<BenchCase> cases_;
};

/// Bytes that a cell update moves at the least: 19 numbers in, 19 out.
double bytes_per_update(Precision precision);

/// Bandwidth of plain streams far larger than the caches, on the ranks of a communicator together [byte/s].
class Bandwidth {
 public:
  Bandwidth();

  double bytes() const {
    return 2.0 * sizeof(double) * numbers;
  }  ///< that each of the two moves, on one rank
  void copy();
  void scale_in_place();

  static constexpr long numbers = 1L << 25;  ///< of each of the two arrays

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double[], Free> from_, to_;
};

}  // namespace beadswim
