#include <algorithm>
#include <cstdio>

#include "beadswim/core/rank_failure.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "bench_report.hpp"

// beadswim-bench measures the speed of the lattice solver relative to the memory bandwidth of the machine.
// With --beads it measures the time of mobility products (bead velocities from forces) instead.

namespace {

using namespace beadswim;

struct BenchOptions {
  BenchRequest request;
  ProductRequest products;
  bool json = false;
};

std::unique_ptr<CLI::App> bench_program(BenchOptions& options) {
  auto program = make_program(
      "beadswim-bench",
      "Measures the speed of the lattice-Boltzmann solver on this machine, in million cell updates per "
      "second and relative to the memory bandwidth. With --beads, measures the time of mobility products "
      "(bead velocities from forces) instead. Under mpirun -n N, measures on 1 rank and on N ranks.");
  begin_group(*program, "Lattice");
  add_value(*program, "--edge", options.request.edges, {"N,...", whole_number(32, 4096), "64,128,256"},
            "Edge of the cube of cells that each rank computes; every value of the list is measured [cell]")
      ->delimiter(',');
  add_choices(*program, "--precision", options.request.precisions,
              "Floating-point precisions of the fluid populations to measure: double, single or both");
  add_choice(*program, "--bead-boundary", options.request.bead_boundary,
             "Scheme of the no-slip condition on bead surfaces in the swarm benchmark, as in beadswim-run");
  begin_group(*program, "Mobility");
  auto* beads =
      add_value(*program, "--beads", options.products.beads, {"N,...", whole_number(2, 100000000), "none"},
                "Numbers of beads for which mobility products are measured, instead of the lattice solver")
          ->delimiter(',');
  add_value(*program, "--tolerance", options.products.tolerance, {"E", number_between(1e-12, 1e-2)},
            "Largest relative error of the bead velocities in the mobility products of --beads [1]")
      ->needs(beads);
  add_value(*program, "--multipole-order", options.products.multipole_order, {"N", whole_number(0, 2)},
            "Highest moment of the force on each bead in the products of --beads, as in beadswim-run")
      ->needs(beads);
  CLI::Option* unsteady = program
                              ->add_flag("--unsteady", options.products.is_unsteady,
                                         "Measure the products of --beads in a periodic box of fluid with "
                                         "inertia, and the end of a time "
                                         "step; the step is a hundredth of the period 2000")
                              ->needs(beads);
  program
      ->add_flag("--noise", options.products.has_noise,
                 "Also measure the thermal noise of a time step, with an error of 1e-3")
      ->needs(beads)
      ->excludes(unsteady);
  begin_group(*program, "Options");
  add_value(*program, "--rounds", options.request.rounds, {"N", whole_number(1, 1000)},
            "Number of times that each case is measured; medians over these rounds are printed");
  program->add_flag("--json", options.json, "Print the results as JSON instead of a table.");
  set_footer(*program,
             {"beadswim-bench --edge 32 --rounds 1", "beadswim-bench --beads 99,999 --json >products.json"},
             "performance.md");
  return program;
}

int run(int argc, char** argv, const Communicator& world) {
  BenchOptions options;
  const auto program = bench_program(options);
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;
  std::vector<Precision>& precisions = options.request.precisions;
  std::ranges::sort(precisions);
  precisions.erase(std::ranges::unique(precisions).begin(), precisions.end());
  for (const char* flag : {"--edge", "--precision", "--bead-boundary"}) {
    if (!options.products.beads.empty() && program->count(flag) > 0)
      throw InputError(flag,
                       "the flag applies to the lattice only, but --beads measures mobility products; leave "
                       "out the flag or --beads");
  }
  options.products.rounds = options.request.rounds;
  const BenchReport report = options.products.beads.empty()
                                 ? measure_all(options.request, world)
                                 : BenchReport{.rounds = options.request.rounds,
                                               .products = measure_products(options.products, world)};
  if (world.is_root()) {
    write_text("-", options.json ? dump_json(bench_report_to_json(report, provenance_record(*program)))
                                 : bench_table(report));
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(&argc, &argv);
  const Communicator world(MPI_COMM_WORLD), failures(MPI_COMM_WORLD);
  if (!world.is_root() && std::freopen("/dev/null", "w", stdout) == nullptr) return 3;
  try {
    return run(argc, argv, world);
  } catch (const InputError&) {  // all ranks throw this error; only rank 0 prints it
    return world.is_root() ? report_current_exception("beadswim-bench")
                           : static_cast<int>(ExitStatus::bad_input);
  } catch (...) {
    return end_after_failure("beadswim-bench", failures);
  }
}
