#include <cstdio>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "comparison_inputs.hpp"
#include "verdict_table.hpp"

namespace {

using namespace beadswim;

/// Flags as they are typed.
struct Flags {
  std::string method;
  std::string cycle = "last";
};

void add_flags(CLI::App& program, ComparisonRequest& request, Flags& flags) {
  program
      .add_option("FILES", request.files,
                  "Run records, then the reference: a prediction (its swimmer is compared) or another run "
                  "record (all its swimmers are). One of the files may be - for standard input.")
      ->type_name("RUN... REFERENCE")
      ->default_str("");
  program
      .add_option("--reference", request.further_references,
                  "A further reference, shown beside the last of FILES; repeatable. It decides only if "
                  "--method names a method that it alone has.")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->default_str("none");
  program
      .add_option("--method", flags.method,
                  "The method that decides (\"run\" for a run); the best usable one unless given: "
                  "inertia-corrected, else multipole-ode, rpy-ode, rpy-perturbation, else the first. All "
                  "methods are shown.")
      ->type_name("NAME");
  request.quantities.assign(all_values<ComparedQuantity>.begin(), all_values<ComparedQuantity>.end());
  add_choices(program, "--quantity", request.quantities,
              "What to compare, separated by commas: velocity (along the swimmer's axis, against the "
              "mean flow along periodic axes), arm_amplitudes, sin_phase_shift.");
  program.add_option("--tolerance", request.tolerance, "Largest relative error that passes, as a fraction.")
      ->default_val(0.05)
      ->check(finite_positive());
  program
      .add_option("--cycle", flags.cycle,
                  "Cycle of each run to compare: last, N (the Nth from the run's start) or mean:N (mean of "
                  "the last N).")
      ->type_name("last|N|mean:N");
}

void apply(const Flags& flags, ComparisonRequest& request) {
  if (!flags.method.empty()) request.method = flags.method;
  request.cycle = parse_cycle_choice(flags.cycle);
}

int run(int argc, const char* const* argv) {
  const auto program = make_program("beadswim-compare",
                                    "Holds runs against a prediction or another run: verdict.json on stdout, "
                                    "a table on stderr. Exit status 0 "
                                    "if the verdict is positive, 1 if it is negative.");
  ComparisonRequest request;
  Flags flags;
  add_flags(*program, request, flags);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  apply(flags, request);
  const VerdictDocument result = compare_files(request);
  write_text("-", dump_json(verdict_to_json(result)));
  print_to_stderr(verdict_table(result));
  return static_cast<int>(verdict(result.rows) ? ExitStatus::fine : ExitStatus::negative_verdict);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-compare", [&] { return run(argc, argv); });
}
