#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace beadswim {
namespace {

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

/// Stores the times that Google Benchmark measures, instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::vector<std::vector<double>>& seconds) : seconds_(seconds) {}

  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      seconds_[run.counters.at("case")].push_back(run.real_accumulated_time / run.counters.at("steps"));
    }
  }

 private:
  std::vector<std::vector<double>>& seconds_;
};

}  // namespace

std::vector<std::vector<double>> time_in_rounds(const std::vector<BenchCase>& cases, int rounds,
                                                const Communicator& communicator) {
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const int steps = choose_step_count(cases[c], communicator);
    const auto body = [&, c, steps](benchmark::State& state) {
      for ([[maybe_unused]] auto iteration : state) {
        state.SetIterationTime(time_steps(cases[c], steps, communicator));
      }
      state.counters["case"] = static_cast<double>(c);
      state.counters["steps"] = steps;
    };
    benchmark::RegisterBenchmark(cases[c].name.c_str(), body)->UseManualTime()->Iterations(1)->Repetitions(1);
  }
  std::vector<std::vector<double>> seconds(cases.size());
  Collector collector(seconds);
  for (int round = 0; round < rounds; ++round) benchmark::RunSpecifiedBenchmarks(&collector, "all");
  return seconds;
}

}  // namespace beadswim
