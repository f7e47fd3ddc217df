#include <algorithm>
#include <cstdio>

#include "beadswim/core/communicator.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "bench_groups.hpp"

// beadswim-bench: how fast this machine's memory and the solver are, in one run.

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
      "Measures in one run what this machine's memory allows and what the solver makes of it: million cell "
      "updates a second of the bare sweep, of steps in periodic and walled boxes, and of the paper's swarm, "
      "as fractions of a yardstick that moves the same bytes without arithmetic. Under mpirun -n N on 1 and "
      "on N ranks. With --beads, seconds of the mobility models' products. On an otherwise idle machine.");
  program->add_option("--edge", options.request.edges, "Edges of the cube of cells that each rank has.")
      ->delimiter(',')
      ->check(whole_number(32, 4096))
      ->default_str("64,128,256")
      ->type_name("N,...");
  add_choices(*program, "--precision", options.request.precisions, "double, single or both.");
  add_choice(*program, "--bead-boundary", options.request.bead_boundary,
             "Bead boundary of the swarm, as of beadswim-run: staircase, the paper's, cli, mr or psm.")
      ->type_name("NAME");
  auto* beads =
      program
          ->add_option("--beads", options.products.beads,
                       "Instead of the lattice: products of a mobility and forces, of so many beads.")
          ->delimiter(',')
          ->check(whole_number(2, 100000000))
          ->default_str("")
          ->type_name("N,...");
  program->add_option("--tolerance", options.products.tolerance, "Of these products, as of beadswim-run.")
      ->needs(beads)
      ->check(product_tolerance())
      ->capture_default_str();
  program
      ->add_option("--rounds", options.request.rounds,
                   "Rounds over all cases; medians over the rounds are reported.")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  program->add_flag("--json", options.json, "JSON (schema beadswim/bench/1) instead of a table.");
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
      throw InputError(flag, "is of the lattice; leave it out with --beads");
  }
  BenchReport report{.rounds = options.request.rounds, .bead_boundary = options.request.bead_boundary};
  if (options.products.beads.empty()) {
    report = measure_all(options.request, world);
  } else {
    options.products.rounds = report.rounds;
    report.products = measure_products(options.products, world);
  }
  if (world.is_root()) {
    write_text("-", options.json ? dump_json(bench_report_to_json(report, provenance_record(*program)))
                                 : bench_table(report));
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(&argc, &argv);
  const Communicator world(MPI_COMM_WORLD);
  if (!world.is_root() && std::freopen("/dev/null", "w", stdout) == nullptr) return 3;
  try {
    return run(argc, argv, world);
  } catch (const InputError&) {  // known to all ranks: rank 0 speaks
    return world.is_root() ? report_current_exception("beadswim-bench")
                           : static_cast<int>(ExitStatus::bad_input);
  } catch (...) {
    const int status = report_current_exception("beadswim-bench");
    MPI_Abort(world.get(), status);
    return status;
  }
}
