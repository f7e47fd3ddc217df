#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/core/median.hpp"
#include "bench_report.hpp"
#include "first_ranks.hpp"
#include "scenes.hpp"
#include "yardstick.hpp"

namespace beadswim {
namespace {

/// Cases that are timed alternately, so that their speeds can be compared: cubes of `edge` cells per axis on
/// each of `ranks` ranks, in all `precisions`.
struct Group {
  int edge;
  int ranks;
  std::vector<Precision> precisions;
};

/// Returns the memory of this machine that programs can still allocate [byte].
double available_bytes() {
  std::ifstream info("/proc/meminfo");
  std::string name, unit;
  double kibibytes = 0;
  while (info >> name >> kibibytes >> unit) {
    if (name == "MemAvailable:") return 1024 * kibibytes;
  }
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// Returns the memory that each rank may allocate [byte]: 85 % of the free memory of its machine, divided by
/// the number of ranks on this machine. All ranks get the smallest of these values over all machines.
/// Collective.
double bytes_per_rank(const Communicator& world) {
  constexpr double share = 0.85;
  double bytes = share * available_bytes() / count_ranks_on_node(world);
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_MIN, world.get());
  return bytes;
}

/// Returns the groups of cases that are timed alternately: one group per edge with all precisions, or one
/// group per edge and precision if the memory does not suffice for all precisions. `available`: memory per
/// rank [byte]. Throws InputError if the memory does not suffice for one precision alone.
std::vector<Group> make_groups(const BenchRequest& request, int ranks, double available) {
  std::vector<Group> groups;
  for (const int edge : request.edges) {
    const auto fits = [&](const std::vector<Precision>& precisions) {
      return lattice_bytes(edge, precisions) < available;
    };
    if (fits(request.precisions)) {
      groups.push_back({edge, ranks, request.precisions});
      continue;
    }
    for (const Precision precision : request.precisions) {
      if (!fits({precision})) {
        throw InputError("--edge",
                         "a lattice with an edge of {} cells needs {:.1f} GB per rank in {} precision, more "
                         "than the {:.1f} GB that are free; use a smaller edge",
                         edge, 1e-9 * lattice_bytes(edge, {precision}), to_text(precision), 1e-9 * available);
      }
      groups.push_back({edge, ranks, {precision}});
    }
  }
  return groups;
}

/// Approximate duration of one measurement [s].
constexpr double target_seconds = 0.12;

/// Returns the time in which all ranks perform `steps` steps [s]. One step before the measurement is not
/// timed, because the first step after another case takes longer: it must fill the complete halo of ghost
/// cells.
double time_steps(const BenchCase& bench_case, int steps, const Communicator& communicator) {
  bench_case.step();
  MPI_Barrier(communicator.get());
  const double start = MPI_Wtime();
  for (int n = 0; n < steps; ++n) bench_case.step();
  MPI_Barrier(communicator.get());
  return MPI_Wtime() - start;
}

/// Returns the number of steps per measurement. This number is even, because a time step with in-place
/// streaming alternates between two kinds of sweep. Runs the case first, to fill the caches.
int choose_step_count(const BenchCase& bench_case, const Communicator& communicator) {
  time_steps(bench_case, 2, communicator);
  const double seconds = time_steps(bench_case, 2, communicator);
  int steps = 2 * std::max(1, static_cast<int>(std::lround(target_seconds / std::max(seconds, 1e-7))));
  MPI_Bcast(&steps, 1, MPI_INT, 0, communicator.get());
  return steps;
}

/// Times all cases once per round, so that slow changes of the speed of the machine affect all cases equally.
/// Returns the time per step of each case in each round, indexed [case][round] [s], on every rank.
/// Collective.
std::vector<std::vector<double>> time_in_rounds(const std::vector<BenchCase>& cases, int rounds,
                                                const Communicator& communicator) {
  std::vector<int> steps;
  for (const BenchCase& bench_case : cases) steps.push_back(choose_step_count(bench_case, communicator));
  std::vector<std::vector<double>> seconds(cases.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t c = 0; c < cases.size(); ++c)
      seconds[c].push_back(time_steps(cases[c], steps[c], communicator) / steps[c]);
  return seconds;
}

/// Returns the median over the rounds of the speed relative to a reference case: `reference` (seconds per
/// step) divided by `seconds`.
double speed_ratio(const std::vector<double>& seconds, std::vector<double> reference) {
  for (std::size_t n = 0; n < seconds.size(); ++n) reference[n] /= seconds[n];
  return median(reference);
}

/// Evaluates the report rows of a group. `seconds`: time per step of each case in each round [case][round]
/// [s]. The last case scales an array in place, which loads and stores `in_place_bytes`.
std::vector<BenchRow> make_rows(const Group& group, const std::vector<BenchCase>& cases,
                                const std::vector<std::vector<double>>& seconds, double in_place_bytes) {
  const auto find = [&](const std::string& name, Precision precision) -> std::optional<std::size_t> {
    const auto found = std::ranges::find_if(
        cases, [&](const BenchCase& c) { return c.name == name && c.precision == precision; });
    return found == cases.end() ? std::nullopt : std::optional<std::size_t>(found - cases.begin());
  };
  std::vector<BenchRow> rows;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const Precision precision = cases[c].precision;
    BenchRow row{.name = cases[c].name,
                 .precision = precision,
                 .edge = group.edge,
                 .ranks = group.ranks,
                 .bytes_per_update = bytes_per_update(precision)};
    row.mlups = 1e-6 * cases[c].updates / median(seconds[c]);
    row.mlups_best = 1e-6 * cases[c].updates / *std::ranges::min_element(seconds[c]);
    const std::size_t yardstick = *find("stream-yardstick", precision);
    row.fraction_of_yardstick =
        speed_ratio(seconds[c], seconds[yardstick]) * cases[c].updates / cases[yardstick].updates;
    row.fraction_of_bandwidth = speed_ratio(seconds[c], seconds.back()) * row.bytes_per_update *
                                cases[c].updates / (in_place_bytes * group.ranks);
    if (const auto fp64_case = find(row.name, Precision::fp64); fp64_case && *fp64_case != c)
      row.speed_over_double = speed_ratio(seconds[c], seconds[*fp64_case]);
    row.layout = cases[c].layout;
    rows.push_back(row);
  }
  return rows;
}

/// Times the cases of a group and adds their rows to the report. For each number of ranks, adds the memory
/// bandwidth once.
void measure(const Group& group, const Communicator& communicator, BenchReport& report) {
  Bandwidth bandwidth;
  const std::vector<BenchCase> cases =
      lattice_cases(group.edge, group.precisions, report.bead_boundary, communicator);
  std::vector<BenchCase> timed = cases;
  timed.push_back({.name = "copy", .step = [&] { bandwidth.copy(); }});
  timed.push_back({.name = "in-place", .step = [&] { bandwidth.scale_in_place(); }});
  const std::vector<std::vector<double>> seconds = time_in_rounds(timed, report.rounds, communicator);
  std::ranges::copy(make_rows(group, cases, seconds, bandwidth.bytes()), std::back_inserter(report.rows));
  if (!report.bandwidths.empty() && report.bandwidths.back().ranks == group.ranks) return;
  const double gigabytes = 1e-9 * bandwidth.bytes() * group.ranks;
  report.bandwidths.push_back({.ranks = group.ranks,
                               .in_place_gb_s = gigabytes / median(seconds.back()),
                               .copy_gb_s = gigabytes / median(seconds[seconds.size() - 2])});
}

}  // namespace

BenchReport measure_all(const BenchRequest& request, const Communicator& world) {
  const double available = bytes_per_rank(world);
  std::vector<Group> groups = make_groups(request, 1, available * world.size());
  if (world.size() > 1) {
    std::ranges::copy(make_groups(request, world.size(), available), std::back_inserter(groups));
  }
  BenchReport report{.rounds = request.rounds, .bead_boundary = request.bead_boundary};
  const double start = MPI_Wtime();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    if (world.is_root()) {
      print_to_stderr(fmt::format(
          "beadswim-bench: measurement {} of {}: lattice edge of {} cells, {} rank{}; {:.0f} s elapsed\n",
          g + 1, groups.size(), group.edge, group.ranks, group.ranks == 1 ? "" : "s", MPI_Wtime() - start));
    }
    run_on_first_ranks(group.ranks, world,
                       [&](const Communicator& communicator) { measure(group, communicator, report); });
  }
  return report;
}

}  // namespace beadswim
