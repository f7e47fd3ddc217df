#include "bench_report.hpp"

#include <fmt/format.h>

#include "beadswim/core/processor.hpp"
#include "beadswim/lattice/sweep.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

Json row_to_json(const BenchRow& row) {
  Json json{{"case", row.name},
            {"precision", row.precision},
            {"edge", row.edge},
            {"ranks", row.ranks},
            {"mlups", row.mlups},
            {"mlups_best", row.mlups_best},
            {"fraction_of_yardstick", row.fraction_of_yardstick},
            {"bytes_per_update", bytes_per_update(row.precision)},
            {"fraction_of_bandwidth", row.fraction_of_bandwidth}};
  if (row.over_double > 0) json["speed_over_double"] = row.over_double;
  if (!row.layout.empty()) json["layout"] = row.layout;
  return json;
}

Json row_to_json(const ProductRow& row) {
  return {{"beads", row.beads},
          {"surroundings", row.is_periodic ? "periodic" : "open"},
          {"ranks", row.ranks},
          {"tolerance", row.tolerance},
          {"seconds", row.seconds},
          {"seconds_best", row.seconds_best},
          {"error", row.error ? Json(*row.error) : Json(nullptr)},
          {"memory_bytes", row.memory_bytes}};
}

Json products_to_json(const BenchReport& report, const Json& provenance) {
  Json rows = Json::array();
  for (const ProductRow& row : report.products) rows.push_back(row_to_json(row));
  return {{"schema", "beadswim/bench/1"},
          {"processor", processor_name()},
          {"instruction_set", sweep_instruction_set()},
          {"rounds", report.rounds},
          {"rows", Json::array()},
          {"mobility_products", rows},
          {"provenance", Json::array({provenance})}};
}

std::string product_table(const BenchReport& report) {
  std::string table = fmt::format(
      "{}, {}; medians of {} rounds\n\n  beads surroundings ranks tolerance  seconds     best     error  "
      "MB\n",
      processor_name(), sweep_instruction_set(), report.rounds);
  for (const ProductRow& row : report.products) {
    table += fmt::format("{:7} {:12} {:5} {:9.1e} {:8.4f} {:8.4f} {:>9} {:4.0f}\n", row.beads,
                         row.is_periodic ? "periodic" : "open", row.ranks, row.tolerance, row.seconds,
                         row.seconds_best, row.error ? fmt::format("{:.1e}", *row.error) : "-",
                         1e-6 * static_cast<double>(row.memory_bytes));
  }
  return table;
}

}  // namespace

Json bench_report_to_json(const BenchReport& report, const Json& provenance) {
  if (!report.products.empty()) return products_to_json(report, provenance);
  Json rows = Json::array(), by_ranks = Json::array();
  for (const BenchRow& row : report.rows) rows.push_back(row_to_json(row));
  for (const BandwidthRow& row : report.bandwidths) {
    by_ranks.push_back(
        {{"ranks", row.ranks}, {"in_place_gb_s", row.in_place_gb_s}, {"copy_gb_s", row.copy_gb_s}});
  }
  return {{"schema", "beadswim/bench/1"},
          {"processor", processor_name()},
          {"instruction_set", sweep_instruction_set()},
          {"rounds", report.rounds},
          {"bead_boundary", report.bead_boundary},
          {"rows", rows},
          {"bandwidth",
           {{"in_place_gb_s", report.bandwidths.front().in_place_gb_s},
            {"copy_gb_s", report.bandwidths.front().copy_gb_s},
            {"by_ranks", by_ranks}}},
          {"provenance", Json::array({provenance})}};
}

std::string bench_table(const BenchReport& report) {
  if (!report.products.empty()) return product_table(report);
  std::string table = fmt::format("{}, {}; {} beads; medians of {} rounds\n", processor_name(),
                                  sweep_instruction_set(), to_text(report.bead_boundary), report.rounds);
  for (const BandwidthRow& row : report.bandwidths) {
    table += fmt::format("{} rank{}: in place {:.1f} GB/s, copy {:.1f} GB/s\n", row.ranks,
                         row.ranks == 1 ? "" : "s", row.in_place_gb_s, row.copy_gb_s);
  }
  table +=
      "\nedge ranks precision case                MLUPS    best  of yardstick  of bandwidth  over double\n";
  for (const BenchRow& row : report.rows) {
    table += fmt::format("{:4} {:5} {:9} {:17} {:7.1f} {:7.1f}  {:12.3f}  {:12.3f}  {:>11}{}\n", row.edge,
                         row.ranks, to_text(row.precision), row.name, row.mlups, row.mlups_best,
                         row.fraction_of_yardstick, row.fraction_of_bandwidth,
                         row.over_double > 0 ? fmt::format("{:.2f}", row.over_double) : "-",
                         row.layout.empty() ? "" : "  " + row.layout);
  }
  return table;
}

}  // namespace beadswim
