// Program that compares cost and accuracy of a cycle: the number of mobility products against the error, for
// the integrator of the library and for CVODE. Prints tables for docs/results/steps-and-errors.sh; it is not
// a test.
//
// Cycles begin at rest, and the cost of the start is included. The errors are those of the time steps alone:
// all runs use the same mobility products, and the reference is CVODE with a tolerance of 1e-10 arm lengths.

#include <fmt/core.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "cvode_swarm.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

struct NamedScene {
  std::string name, description;
  OverdampedScene scene;
};

struct Options {
  std::vector<std::string> scenes{"open", "turned", "cell", "dense-4", "dense-16"};
  int cycles = 1;
  double product_tolerance = 1e-6;
};

NamedScene open_scene() {
  OverdampedScene scene = scene_of(paper_swimmer(), 1);
  return {"open", "the paper's swimmer in open space", scene};
}

NamedScene turned_scene() {
  return {"turned", "three of them, turned: they bend", turned_swimmers()};
}

NamedScene cell_scene() {
  OverdampedScene scene = lattice_of({1, 1}, 32, 1);
  return {"cell", "the paper's uniform swarm, its cell of one swimmer", scene};
}

NamedScene dense_scene(int rows) {
  OverdampedScene scene = lattice_of({rows, rows}, 16, 1);
  disturb(scene);
  return {fmt::format("dense-{}", rows * rows),
          fmt::format("{0} x {0} rows of the swarm's swimmers, 16 apart, disturbed", rows), scene};
}

struct Run {
  std::string name;
  long products = 0, steps = 0;
  double seconds = 0;
  Beads displacements;
};

Beads difference(Beads a, const Beads& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

double root_mean_square(const Beads& vectors) {
  double sum = 0;
  for (const Vec3& v : vectors) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

Vec3 mean(const Beads& vectors) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : vectors) sum += v;
  return sum / static_cast<double>(vectors.size());
}

template <class Function>
Run timed(const Function& function) {
  const auto start = std::chrono::steady_clock::now();
  Run run = function();
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

Run by_cvode_at(const OverdampedScene& scene, int cycles, double tolerance, CvodeJacobian jacobian) {
  return timed([&] {
    const double arm = scene.types[0].bonds[0].rest_length;
    const CvodeSettings settings{.absolute = tolerance * arm, .jacobian = jacobian};
    const CvodeResult result = by_cvode(scene, cycles * scene.types[0].driving.period, settings);
    const char* how = jacobian == CvodeJacobian::springs ? "mu K" : "differences";
    return Run{.name = fmt::format("CVODE, {}, {:.0e}", how, tolerance),
               .products = result.products,
               .steps = result.steps,
               .displacements = difference(result.positions, start_positions(scene))};
  });
}

/// Returns a run with the integrator of the library. The run has no displacements if a fault stopped it.
Run by_steps(OverdampedScene scene, int cycles, int steps_per_cycle) {
  return timed([&] {
    scene.step = scene.types[0].driving.period / steps_per_cycle;
    const int steps = cycles * steps_per_cycle;
    const Communicator world(MPI_COMM_WORLD);
    OverdampedSystem system(scene, world);
    const Beads start(system.positions().begin(), system.positions().end());
    for (int n = 0; n < steps && !system.fault(); ++n) system.step();
    Run run{.name = fmt::format("own steps, {}", steps_per_cycle),
            .products = system.state().work.products,
            .steps = system.fault() ? system.fault()->step : steps,
            .displacements = {}};
    if (!system.fault())
      run.displacements = difference({system.positions().begin(), system.positions().end()}, start);
    return run;
  });
}

void print(const Run& run, int cycles, const Beads& reference) {
  const auto per_cycle = [&](long count) { return std::lround(static_cast<double>(count) / cycles); };
  if (run.displacements.empty()) {
    fmt::print("| {} | | | stopped in step {} | | |\n", run.name, run.steps);
  } else {
    const Beads error = difference(run.displacements, reference);
    fmt::print("| {} | {} | {} | {:.1e} | {:.1e} | {:.2g} |\n", run.name, per_cycle(run.steps),
               per_cycle(run.products), root_mean_square(error) / root_mean_square(reference),
               mean(error).norm() / mean(reference).norm(), run.seconds / cycles);
  }
  std::fflush(stdout);
}

void measure(const NamedScene& named, int cycles) {
  const OverdampedScene& scene = named.scene;
  const Beads reference = by_cvode_at(scene, cycles, 1e-10, CvodeJacobian::difference_quotient).displacements;
  fmt::print("\n## {}: {}\n\n", named.name, named.description);
  fmt::print(
      "From rest over {} cycle{}: beads displaced by {:.4g} (root mean square), the swarm by {:.4g}.\n\n",
      cycles, cycles == 1 ? "" : "s", root_mean_square(reference), mean(reference).norm());
  fmt::print("| by | steps a cycle | products a cycle | error of places | of swimming | seconds a cycle |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (const CvodeJacobian jacobian : {CvodeJacobian::difference_quotient, CvodeJacobian::springs})
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9})
      print(by_cvode_at(scene, cycles, tolerance, jacobian), cycles, reference);
  for (const int steps : {50, 100, 200, 400, 800, 1600, 3200})
    print(by_steps(scene, cycles, steps), cycles, reference);
}

void measure_all(const Options& options) {
  for (NamedScene named : {open_scene(), turned_scene(), cell_scene(), dense_scene(2), dense_scene(4)}) {
    if (std::ranges::find(options.scenes, named.name) == options.scenes.end()) continue;
    named.scene.tolerance = options.product_tolerance;
    measure(named, options.cycles);
  }
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  beadswim::Options options;
  CLI::App app("Mobility products against errors, of the library's own steps and of CVODE's");
  app.add_option("scene", options.scenes, "which to measure")
      ->check(CLI::IsMember(std::vector<std::string>(options.scenes)));
  app.add_option("--cycles", options.cycles, "of the driving, from rest")->check(CLI::PositiveNumber);
  app.add_option("--product-tolerance", options.product_tolerance, "of mobility products")
      ->check(CLI::Range(1e-12, 1e-2));
  CLI11_PARSE(app, argc, argv);
  const beadswim::MpiSession mpi(&argc, &argv);
  beadswim::measure_all(options);
}
