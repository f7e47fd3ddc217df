#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/lattice/precision.hpp"
#include "mobility_products.hpp"

namespace beadswim {

/// One line of the result: a case at one precision, edge and number of ranks. Rates are of all ranks
/// together.
struct BenchRow {
  std::string name;
  Precision precision = Precision::fp64;
  int edge = 0;  ///< of the cube of cells that each rank has
  int ranks = 1;
  double mlups = 0;  ///< median [10^6 cell updates/s]
  double mlups_best = 0;
  double fraction_of_yardstick = 0;  ///< median of the ratios in each round
  double fraction_of_bandwidth = 0;  ///< bytes_per_update x rate over the in-place bandwidth; likewise
  double over_double = 0;            ///< speed over that of double precision; 0 if not measured together
  std::string layout{};              ///< of the yardstick
};

struct BandwidthRow {
  int ranks = 1;
  double in_place_gb_s = 0, copy_gb_s = 0;  ///< medians; bytes read and written [10^9 byte/s]
};

struct BenchReport {
  int rounds = 0;
  BeadScheme bead_boundary = BeadScheme::staircase;  ///< of the swarm
  std::vector<BenchRow> rows{};
  std::vector<BandwidthRow> bandwidths{};
  std::vector<ProductRow> products{};  ///< of mobilities, instead of rows and bandwidths
};

/// schemas/bench.schema.json
Json bench_report_to_json(const BenchReport& report, const Json& provenance);

/// For people.
std::string bench_table(const BenchReport& report);

}  // namespace beadswim
