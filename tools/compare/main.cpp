#include <fmt/core.h>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/study/stream.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "comparison_stream.hpp"
#include "result_table.hpp"
#include "verdict_table.hpp"

namespace {

using namespace beadswim;

void add_flags(CLI::App& program, ComparisonRequest& request) {
  add_value(program, "FILES", request.files, {.name = "RUN... REFERENCE"},
            "Run records or trajectories (.h5md), and last the reference for the comparison: predictions of "
            "beadswim-theory or another run. Streams (JSON Lines) are paired by their studies.")
      ->default_str("");
  add_value(program, "--reference", request.further_references, {.name = "FILE", .initial = "none"},
            "Additional reference to compare with, repeatable. It determines the verdict only if --method "
            "names a method that REFERENCE lacks")
      ->allow_extra_args(false);
  add_value(
      program, "--method", request.method,
      {.name = "NAME",
       .initial = "first usable of inertia-corrected, multipole-ode, rpy-ode, rpy-perturbation, others"},
      "Theory method that determines the verdict, or run for a record");
  request.quantities.assign(default_quantities.begin(), default_quantities.end());
  add_choices(
      program, "--quantity", request.quantities,
      "Results to compare, of those that beadswim-plot against draws; velocity: along the axis, minus the "
      "mean flow");
  add_value(program, "--tolerance", request.tolerance, {"E", fraction()},
            "Largest relative error between run and reference with which a run passes, below 1; 0.05 means 5 "
            "% [1]");
  add_value(
      program, "--cycle", [&request](const std::string& text) { request.cycle = parse_cycle_choice(text); },
      {.name = "last|N|mean:N", .initial = "last"},
      "Driving cycle of each run that is compared: the last, cycle number N (the first is 1), or the mean "
      "over the last N cycles");
  add_value(program, "--allow-difference", request.allowed_differences,
            {"NAME,...", one_of(scene_property_names()), "none"},
            "Properties in which the scenes of run and reference may differ, such as domain,fluid; the "
            "verdict lists the differences")
      ->delimiter(',')
      ->allow_extra_args(false);
  program.add_flag("--all", request.shows_all,
                   "Print all rows of the table, not only what decides and the best.");
  add_value(program, "--swimmer", request.swimmer,
            {.name = "ID", .allowed = whole_number(0, 999999999), .initial = "that of predictions, or all"},
            "Swimmer of the runs that is compared, or that the table lists");
  const auto take_table = [&request](const std::string& path) {
    require_csv_path(path, "--table");
    request.table = path;
  };
  CLI::Option* table = add_value(program, "--table", take_table, {.name = "FILE.csv", .initial = "none"},
                                 "File to write, instead of a comparison, with all results of each swimmer "
                                 "of the runs in each cycle; - is standard output");
  for (const char* flag :
       {"--reference", "--method", "--quantity", "--tolerance", "--cycle", "--allow-difference", "--all"})
    table->excludes(program.get_option(flag));
  set_footer(program,
             {"beadswim-compare run.json theory.json --method rpy-box-ode >verdict.json",
              "beadswim-compare run.h5md --table cycles.csv"},
             "reading-results.md");
}

int write_table(const ComparisonRequest& request) {
  for (const std::string& input : request.files) require_other_file(input, request.table);
  write_text(request.table, result_table(request.files, request.swimmer));
  return static_cast<int>(ExitStatus::fine);
}

int compare_single(ComparisonFiles& files, const ComparisonRequest& request) {
  const VerdictDocument result = compare(files.all(), request);
  write_text("-", dump_json(verdict_to_json(result)));
  print_to_stderr(verdict_table(result, request.shows_all));
  return static_cast<int>(verdict(result.rows) ? ExitStatus::fine : ExitStatus::negative_verdict);
}

/// Writes a verdict or a failure per run. Throws SolverError at the end if there are failures.
int compare_stream(ComparisonFiles& files, const ComparisonRequest& request) {
  const StoredStream runs = files.runs();
  const auto work = [&](const StreamMember& member) {
    const VerdictDocument result = compare(files.inputs_of(member), request);
    return MemberResult{.line = dump_json_line(verdict_to_json(result)),
                        .note = verdict_line(result),
                        .findings = {.negative = !verdict(result.rows)}};
  };
  const auto take = [](int, const MemberResult& result) {
    write_text("-", result.line);
    if (!result.findings.failed) print_to_stderr(result.note);
  };
  const Findings findings =
      work_in_processes(runs, 1, work, {.program = "beadswim-compare", .take = take}).findings;
  require_no_failures(findings.failed, runs.size(), "runs have no verdict");
  print_to_stderr(fmt::format("verdicts: {} of {} pass\n", runs.size() - findings.negative, runs.size()));
  return static_cast<int>(findings.negative == 0 ? ExitStatus::fine : ExitStatus::negative_verdict);
}

int run(int argc, const char* const* argv) {
  const auto program = make_program(
      "beadswim-compare",
      "Compares runs with a prediction or another run. Prints the verdict as JSON on standard output and as "
      "a table on standard error. The exit status is 1 if the verdict is negative. --table writes the "
      "results of runs as a table instead.");
  ComparisonRequest request;
  add_flags(*program, request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  if (!request.table.empty()) return write_table(request);
  ComparisonFiles files(request);
  return files.is_stream() ? compare_stream(files, request) : compare_single(files, request);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-compare", [&] { return run(argc, argv); });
}
