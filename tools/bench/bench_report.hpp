#pragma once

#include <optional>
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
  double bytes_per_update = 0;       ///< that a cell's update loads and stores [byte]
  double fraction_of_bandwidth = 0;  ///< bytes_per_update x rate over the in-place bandwidth; likewise
  std::optional<double>
      speed_over_double{};  ///< none if double precision was not measured in the same rounds
  std::string layout{};     ///< of the yardstick's arrays; empty for other cases

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

struct BandwidthRow {
  int ranks = 1;
  double in_place_gb_s = 0, copy_gb_s = 0;  ///< medians; bytes read and written [10^9 byte/s]

  static void visit_fields(auto&& visit, auto& row) {
    visit("ranks", row.ranks);
    visit("in_place_gb_s", row.in_place_gb_s);
    visit("copy_gb_s", row.copy_gb_s);
  }
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
