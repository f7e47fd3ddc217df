#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/lattice/precision.hpp"
#include "mobility_products.hpp"

namespace beadswim {

/// The measurements that the command line requests of the lattice solver.
struct BenchRequest {
  std::vector<int> edges{64, 128, 256};  ///< cells per axis and rank
  std::vector<Precision> precisions{Precision::fp64, Precision::fp32};
  int rounds = 9;                                    ///< repetitions of each case
  BeadScheme bead_boundary = BeadScheme::staircase;  ///< scheme of the case coupled-swarm
};

/// Result of one benchmark case at one precision, edge and number of ranks. Rates are sums over all ranks.
/// The yardstick is an upper bound of the speed of a time step: a case that loads and stores all populations
/// of the lattice without arithmetic.
struct BenchRow {
  std::string name;
  Precision precision = Precision::fp64;
  int edge = 0;  ///< cells per axis of the cube of each rank
  int ranks = 1;
  double mlups = 0;       ///< rate: median over the rounds [10^6 cell updates/s]
  double mlups_best = 0;  ///< rate in the fastest round [10^6 cell updates/s]
  /// Rate divided by the rate of the case stream-yardstick, which loads and stores all populations without
  /// arithmetic: median over the rounds.
  double fraction_of_yardstick = 0;
  double bytes_per_update = 0;  ///< memory traffic: bytes loaded and stored per cell update
  /// Memory traffic (bytes_per_update times rate) divided by the memory bandwidth of scaling an array in
  /// place: median over the rounds.
  double fraction_of_bandwidth = 0;
  /// Rate of this case divided by its rate in double precision. Empty for double precision itself, and if
  /// double precision was not timed in the same rounds.
  std::optional<double> speed_over_double{};
  std::string layout{};  ///< memory layout of the case stream-yardstick; empty for other cases

  static void visit_fields(auto&& visit, auto& row) {
    visit("case", row.name);
    visit("precision", row.precision);
    visit("edge", row.edge);
    visit("ranks", row.ranks);
    visit("mlups", row.mlups);
    visit("mlups_best", row.mlups_best);
    visit("fraction_of_yardstick", row.fraction_of_yardstick);
    visit("bytes_per_update", row.bytes_per_update);
    visit("fraction_of_bandwidth", row.fraction_of_bandwidth);
    visit("speed_over_double", row.speed_over_double, omitted_if_none);
    visit("layout", row.layout, omitted_if_none);
  }
};

/// Memory bandwidth of all ranks together, measured with arrays far larger than the caches (class Bandwidth).
struct BandwidthRow {
  int ranks = 1;
  double in_place_gb_s = 0, copy_gb_s = 0;  ///< bytes read plus written per time, medians [10^9 byte/s]

  BEADSWIM_FIELDS(ranks, in_place_gb_s, copy_gb_s)
};

/// Results of beadswim-bench: either the speed of the lattice solver (rows, bandwidths) or the time of
/// mobility products.
struct BenchReport {
  int rounds = 0;
  BeadScheme bead_boundary = BeadScheme::staircase;  ///< scheme of the case coupled-swarm
  std::vector<BenchRow> rows{};
  std::vector<BandwidthRow> bandwidths{};
  std::vector<ProductRow> products{};  ///< mobility products; rows and bandwidths are then empty
};

/// Times all requested cases on one rank and on all ranks, and prints the progress to stderr. Only the report
/// on rank 0 is complete. Throws InputError on all ranks if the cubes of an edge need more memory than is
/// free. Collective.
BenchReport measure_all(const BenchRequest& request, const Communicator& world);

/// Converts the report to a document that follows schemas/bench.schema.json.
Json bench_report_to_json(const BenchReport& report, const Json& provenance);

/// Returns the report as a table in plain text.
std::string bench_table(const BenchReport& report);

}  // namespace beadswim
