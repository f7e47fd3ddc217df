#pragma once

#include <memory>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "bench_case.hpp"
#include "yardstick.hpp"

namespace beadswim {

/// All lattice benchmark cases for one cube size, with the memory that they use. `edge`: cells per axis of
/// the cube of each rank.
class BenchScenes {
 public:
  BenchScenes(int edge, const std::vector<Precision>& precisions, BeadScheme bead_boundary,
              const Communicator& communicator);
  ~BenchScenes();

  /// Returns the cases in the order in which each round times them.
  const std::vector<BenchCase>& cases() const { return cases_; }

  /// Returns the name of the memory layout (StreamLayout) that was fastest for the case stream-yardstick.
  std::string layout_name(Precision precision) const;

  /// Returns the memory that the cases need per rank [byte].
  static double bytes(int edge, const std::vector<Precision>& precisions);

 private:
  struct Scene;
  std::vector<std::unique_ptr<Scene>> scenes_;
  std::vector<BenchCase> cases_;
};

/// Returns the memory traffic of one cell update [byte]: 19 populations are loaded and 19 are stored.
double bytes_per_update(Precision precision);

/// Two arrays far larger than the caches, to measure the memory bandwidth. Each rank has its own arrays.
class Bandwidth {
 public:
  Bandwidth();

  /// Returns the bytes that one call of copy() or scale_in_place() loads and stores on one rank [byte].
  double bytes() const { return 2.0 * sizeof(double) * num_elements; }
  void copy();
  void scale_in_place();

  static constexpr long num_elements = 1L << 25;  ///< length of each array

 private:
  struct Free {
    void operator()(double* p) const { std::free(p); }
  };
  std::unique_ptr<double[], Free> source_, destination_;
};

}  // namespace beadswim
