#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace beadswim {
namespace {

/// One timed stretch lasts about this long [s].
constexpr double stretch = 0.12;

/// Seconds of `steps` steps, until the last rank is through, after one that does what the case before left
/// undone: the first periodic step after a bare sweep must fill all of the halo.
double seconds_of(const BenchCase& timed, int steps, const Communicator& communicator) {
  timed.step();
  MPI_Barrier(communicator.get());
  const double start = MPI_Wtime();
  for (int n = 0; n < steps; ++n) timed.step();
  MPI_Barrier(communicator.get());
  return MPI_Wtime() - start;
}

/// Steps of a stretch: even, for a step in place alternates between two kinds. Warms the case up.
int steps_of_stretch(const BenchCase& timed, const Communicator& communicator) {
  seconds_of(timed, 2, communicator);
  const double seconds = seconds_of(timed, 2, communicator);
  int steps = 2 * std::max(1, static_cast<int>(std::lround(stretch / std::max(seconds, 1e-7))));
  MPI_Bcast(&steps, 1, MPI_INT, 0, communicator.get());
  return steps;
}

/// Takes what Google Benchmark measures instead of printing it.
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
    const int steps = steps_of_stretch(cases[c], communicator);
    const auto body = [&, c, steps](benchmark::State& state) {
      for ([[maybe_unused]] auto iteration : state) {
        state.SetIterationTime(seconds_of(cases[c], steps, communicator));
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
