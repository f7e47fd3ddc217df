#include "bench_report.hpp"

#include <fmt/core.h>

#include "beadswim/core/version.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/lattice/fluid_step.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

std::string optional_seconds(const std::optional<double>& seconds) {
  return seconds ? fmt::format("{:.4f}", *seconds) : "-";
}

std::string product_table(const BenchReport& report) {
  std::string table = fmt::format(
      "{}, {}; medians of {} rounds\n\n  beads surroundings ranks tolerance order iterations  seconds     "
      "best     error   MB     mesh end of step    noise\n",
      processor_name(), sweep_instruction_set(), report.rounds);
  for (const ProductRow& row : report.products) {
    table += fmt::format(
        "{:7} {:12} {:5} {:9.1e} {:5} {:10} {:8.4f} {:8.4f} {:>9} {:4.0f} {:>8} {:>11} {:>8}\n", row.beads,
        to_text(row.surroundings), row.ranks, row.tolerance, row.multipole_order, row.iterations, row.seconds,
        row.seconds_best, row.error ? fmt::format("{:.1e}", *row.error) : "-",
        1e-6 * static_cast<double>(row.memory_bytes), optional_seconds(row.mesh_seconds),
        optional_seconds(row.end_of_step_seconds), optional_seconds(row.noise_seconds));
  }
  return table;
}

}  // namespace

Json bench_report_to_json(const BenchReport& report, const Json& provenance) {
  const bool is_of_lattice = report.products.empty();
  Json json{{"schema", "beadswim/bench/1"},
            {"processor", processor_name()},
            {"instruction_set", sweep_instruction_set()},
            {"rounds", report.rounds}};
  if (is_of_lattice) json["bead_boundary"] = report.bead_boundary;
  json["rows"] = report.rows;
  if (is_of_lattice) {
    json["bandwidth"] = {{"in_place_gb_s", report.bandwidths.front().in_place_gb_s},
                         {"copy_gb_s", report.bandwidths.front().copy_gb_s},
                         {"by_ranks", report.bandwidths}};
  } else {
    json["mobility_products"] = report.products;
  }
  json["provenance"] = Json::array({provenance});
  return json;
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
                         row.speed_over_double ? fmt::format("{:.2f}", *row.speed_over_double) : "-",
                         row.layout.empty() ? "" : "  " + row.layout);
  }
  return table;
}

}  // namespace beadswim
