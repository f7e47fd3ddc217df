#include "bench_groups.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "first_ranks.hpp"
#include "scenes.hpp"
#include "timing.hpp"

namespace beadswim {
namespace {

/// What is measured together: cases share the rounds.
struct Group {
  int edge;
  int ranks;
  std::vector<Precision> precisions;
};

/// Memory that programs can still have [byte].
double available_bytes() {
  std::ifstream info("/proc/meminfo");
  std::string name, unit;
  double kibibytes = 0;
  while (info >> name >> kibibytes >> unit) {
    if (name == "MemAvailable:") return 1024 * kibibytes;
  }
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// The part of it that each rank may take, the same number on all ranks.
double bytes_for_a_rank(const Communicator& world) {
  constexpr double share = 0.85;
  double bytes = share * available_bytes() / count_ranks_on_node(world);
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_MIN, world.get());
  return bytes;
}

/// Precisions in one group where memory allows, else one after the other. `available`: for each rank.
std::vector<Group> groups_of(const BenchRequest& request, int ranks, double available) {
  std::vector<Group> groups;
  for (const int edge : request.edges) {
    const auto fits = [&](const std::vector<Precision>& precisions) {
      return BenchScenes::bytes(edge, precisions) < available;
    };
    if (fits(request.precisions)) {
      groups.push_back({edge, ranks, request.precisions});
      continue;
    }
    for (const Precision precision : request.precisions) {
      if (!fits({precision})) {
        throw InputError(
            "--edge",
            fmt::format("{} needs {:.1f} GB a rank in {} precision, more than the {:.1f} GB that are "
                        "free; take a smaller edge",
                        edge, 1e-9 * BenchScenes::bytes(edge, {precision}), to_text(precision),
                        1e-9 * available));
      }
      groups.push_back({edge, ranks, {precision}});
    }
  }
  return groups;
}

std::vector<double> ratios(const std::vector<double>& seconds, const std::vector<double>& reference) {
  std::vector<double> result;
  for (std::size_t n = 0; n < seconds.size(); ++n) result.push_back(reference[n] / seconds[n]);
  return result;
}

/// Rows of a group from the seconds of a step, [case][round]; the last case streams in place.
std::vector<BenchRow> rows_of(const Group& group, const BenchScenes& scenes,
                              const std::vector<std::vector<double>>& seconds, double in_place_bytes) {
  const std::vector<BenchCase>& cases = scenes.cases();
  const auto find = [&](const std::string& name, Precision precision) -> std::optional<std::size_t> {
    const auto found = std::ranges::find_if(
        cases, [&](const BenchCase& c) { return c.name == name && c.precision == precision; });
    return found == cases.end() ? std::nullopt : std::optional<std::size_t>(found - cases.begin());
  };
  const double cells = static_cast<double>(group.edge) * group.edge * group.edge;
  std::vector<BenchRow> rows;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Precision precision = cases[c].precision;
    BenchRow row{.name = cases[c].name,
                 .precision = precision,
                 .edge = group.edge,
                 .ranks = group.ranks,
                 .bytes_per_update = bytes_per_update(precision)};
    row.mlups = 1e-6 * cells * group.ranks / median(seconds[c]);
    row.mlups_best = 1e-6 * cells * group.ranks / *std::ranges::min_element(seconds[c]);
    row.fraction_of_yardstick = median(ratios(seconds[c], seconds[*find("stream-yardstick", precision)]));
    row.fraction_of_bandwidth =
        median(ratios(seconds[c], seconds.back())) * row.bytes_per_update * cells / in_place_bytes;
    if (const auto twin = find(row.name, Precision::fp64); twin && *twin != c)
      row.speed_over_double = median(ratios(seconds[c], seconds[*twin]));
    if (row.name == "stream-yardstick") row.layout = scenes.layout_name(precision);
    rows.push_back(row);
  }
  return rows;
}

/// Adds a group's rows, and its bandwidths, on rank 0.
void measure(const Group& group, const Communicator& communicator, BenchReport& report) {
  Bandwidth bandwidth;
  const BenchScenes scenes(group.edge, group.precisions, report.bead_boundary, communicator);
  std::vector<BenchCase> cases = scenes.cases();
  cases.push_back({"copy", Precision::fp64, [&] { bandwidth.copy(); }});
  cases.push_back({"in-place", Precision::fp64, [&] { bandwidth.scale_in_place(); }});
  const std::vector<std::vector<double>> seconds = time_in_rounds(cases, report.rounds, communicator);
  std::ranges::copy(rows_of(group, scenes, seconds, bandwidth.bytes()), std::back_inserter(report.rows));
  if (!report.bandwidths.empty() && report.bandwidths.back().ranks == group.ranks) return;
  const double gigabytes = 1e-9 * bandwidth.bytes() * group.ranks;
  report.bandwidths.push_back({.ranks = group.ranks,
                               .in_place_gb_s = gigabytes / median(seconds.back()),
                               .copy_gb_s = gigabytes / median(seconds[seconds.size() - 2])});
}

}  // namespace

BenchReport measure_all(const BenchRequest& request, const Communicator& world) {
  const double available = bytes_for_a_rank(world);
  std::vector<Group> groups = groups_of(request, 1, available * world.size());
  if (world.size() > 1) {
    std::ranges::copy(groups_of(request, world.size(), available), std::back_inserter(groups));
  }
  BenchReport report{
      .rounds = request.rounds, .bead_boundary = request.bead_boundary, .rows = {}, .bandwidths = {}};
  const double start = MPI_Wtime();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    if (world.is_root()) {
      print_to_stderr(fmt::format("beadswim-bench: {} of {}: edge {}, {} rank{}; {:.0f} s so far\n", g + 1,
                                  groups.size(), group.edge, group.ranks, group.ranks == 1 ? "" : "s",
                                  MPI_Wtime() - start));
    }
    on_first_ranks(group.ranks, world,
                   [&](const Communicator& communicator) { measure(group, communicator, report); });
  }
  return report;
}

}  // namespace beadswim
