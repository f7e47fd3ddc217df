#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/study/stream.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "beadswim/tools/stop_signal.hpp"
#include "problem_text.hpp"

// beadswim-optimise searches for the values of a few quantities of a layout with which a swimmer swims
// fastest, most efficiently, and so on.

namespace beadswim {
namespace {

constexpr const char* program_name = "beadswim-optimise";

struct Flags {
  std::vector<std::string> files{"-"}, free, constraints;
  std::optional<ResultQuantity> maximise, minimise;
  std::string method = "rpy-ode", model, verify_by, trace;
  std::optional<int> evaluations;
  int seed = 1;
  EvaluatorSettings evaluator;
};

std::vector<std::string> mobility_models() {
  std::vector<std::string> names;
  for (const auto& [model, name] : name_table<RunModel>)
    if (mobility_model(model)) names.emplace_back(name);
  return names;
}

void add_objective(CLI::App& program, const std::string& flag, std::optional<ResultQuantity>& objective,
                   const std::string& help) {
  add_word(program, flag, outcome_names(), "", help, [&objective](const std::string& word) {
    objective = from_text<ResultQuantity>(word);
  })->type_name("NAME");
}

std::unique_ptr<CLI::App> optimise_program(Flags& flags) {
  auto program =
      make_program(program_name,
                   "Searches for the values of a few quantities of a layout with which its swimmer swims "
                   "fastest, most efficiently or with least power. Writes the layout with these values.");
  add_value(*program, "layout", flags.files, {.name = "FILE", .initial = "-"},
            "Layout files (JSON, JSON Lines); - is standard input.");
  add_value(*program, "--free", flags.free, {.name = "NAME[,NAME...]=FROM:TO"},
            "A quantity that may change (a flag of beadswim-layout swimmer without --, or a JSON pointer; "
            "several take equal values), and its bounds. Repeatable")
      ->required()
      ->allow_extra_args(false);
  add_objective(*program, "--maximise", flags.maximise,
                "Result, from the list below, that is to be as large as possible");
  add_objective(*program, "--minimise", flags.minimise,
                "Result, from the list below, that is to be as small as possible; velocity: with its sign");
  add_value(*program, "--subject-to", flags.constraints, {.name = "NAME=[MIN]:[MAX]", .initial = "none"},
            "A limit of one of these results; gap: the smallest between the beads of an arm. Repeatable")
      ->allow_extra_args(false);
  begin_group(*program, "Evaluation");
  CLI::Option* method = add_value(*program, "--method", flags.method, {.name = "NAME"},
                                  "Theory method of beadswim-theory that evaluates a layout");
  add_word(*program, "--model", mobility_models(), "",
           "Model of beadswim-run that evaluates a layout instead",
           [&flags](const std::string& word) { flags.model = word; })
      ->excludes(method);
  add_value(*program, "--verify-by", flags.verify_by, {.name = "NAME", .initial = "none"},
            "Method or model, also lbm, that evaluates the layout that was found once more");
  add_value(*program, "--cycles", flags.evaluator.cycles, {"N", finite_positive(), "as beadswim-run"},
            "Length of each run by a model; its last cycle counts");
  add_value(*program, "--swimmer", flags.evaluator.swimmer,
            {"ID", whole_number(0, std::numeric_limits<int>::max()),
             "theory: all, if they are equal; models: their mean"},
            "Id of the swimmer");
  begin_group(*program, "Search");
  add_value(*program, "--evaluations", flags.evaluations,
            {"N", whole_number(10, 1000000), "100; for several free values 200 per value"},
            "Largest number of evaluations of the search");
  add_value(*program, "--seed", flags.seed, {"N", whole_number(0, std::numeric_limits<int>::max())},
            "Seed of the random numbers of the search for four quantities or more");
  add_value(*program, "--trace", flags.trace, {.name = "FILE", .initial = "none"},
            "File for all evaluations, one per line (JSON Lines)");
  set_footer(*program,
             {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-optimise --free phase=0:180deg --maximise velocity >fastest.json",
              "beadswim-optimise layout.json --free amplitude=0.01:0.3 --free stiffness=0.01:0.3 \\\n"
              "--maximise efficiency --subject-to power=:0.0001 --verify-by multipole-ode >efficient.json"},
             "optimise.md");
  program->footer("Results:\n" + wrapped(joined(outcome_names(), ", "), 2) + "\n" + program->get_footer());
  return program;
}

Problem problem_of(const Flags& flags) {
  if (flags.maximise.has_value() == flags.minimise.has_value())
    throw InputError("--maximise", "name one objective with --maximise or --minimise");
  const bool is_maximised = flags.maximise.has_value();
  return {.objective = is_maximised ? *flags.maximise : *flags.minimise,
          .is_maximised = is_maximised,
          .constraints = parse_constraints(flags.constraints)};
}

void require_compatible(const Flags& flags) {
  if (is_model(flags.method))
    throw InputError("--method", "{} is a model of beadswim-run; use --model or --verify-by", flags.method);
  if (flags.evaluator.cycles && flags.model.empty() && !is_model(flags.verify_by))
    throw InputError("--cycles", "is for models only; leave it out, or name a model");
}

/// Throws InputError if the trace cannot be written, or would replace an input.
void require_trace(const Flags& flags) {
  namespace fs = std::filesystem;
  if (flags.trace.empty()) return;
  for (const std::string& file : flags.files) require_other_file(file, flags.trace);
  const fs::path path(flags.trace), folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code ignored;
  const bool is_other = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
  if (flags.trace == "-" || is_other || access(folder.c_str(), W_OK) != 0)
    throw InputError(
        "--trace", "\"{}\" cannot be written; name a file in a folder that exists and that you may write to",
        flags.trace);
}

/// Initialises MPI, which models need. Throws InputError on more than one rank.
std::unique_ptr<MpiSession> mpi_for_models(int argc, char** argv) {
  auto mpi = std::make_unique<MpiSession>(&argc, &argv);
  catch_stop_signals();
  if (Communicator(MPI_COMM_WORLD).size() > 1)
    throw InputError("mpirun", "the program uses one rank; start it without mpirun");
  return mpi;
}

Optimisation optimisation_of(Flags& flags, const OpenFile& trace) {
  flags.evaluator.stop = [] { return stop_by_signal(stop_signal()); };
  const auto evaluator = [&](const std::string& name, Setting setting) {
    return evaluator_by(name, setting, flags.evaluator);
  };
  const Problem problem = problem_of(flags);
  const std::vector<FreeValue> free = parse_free_values(flags.free);
  const int dimensions = static_cast<int>(free.size());
  Optimisation optimisation{
      .free = free,
      .problem = problem,
      .by = flags.model.empty() ? evaluator(flags.method, Setting::method)
                                : evaluator(flags.model, Setting::model),
      .search = {.num_inequalities = problem.num_inequalities(),
                 .evaluations = flags.evaluations.value_or(dimensions == 1 ? 100 : 200 * dimensions),
                 .seed = static_cast<unsigned long>(flags.seed)},
      .message =
          [](const std::string& text) { print_to_stderr(fmt::format("{}: {}\n", program_name, text)); },
      .trace = [&trace](const Json& line) { append(trace, dump_json_line(line)); }};
  if (!flags.verify_by.empty()) optimisation.verifier = evaluator(flags.verify_by, Setting::verification);
  return optimisation;
}

/// Writes the layouts that were found, or failures in their place. Throws InputError or SolverError if one
/// has none. `documents`: the stream whose documents are `layouts`.
void search_all(const Flags& flags, const Optimisation& optimisation, const DocumentStream& documents,
                const StoredStream& layouts, const CLI::App& program) {
  const bool is_single = documents.is_single();
  const auto work = [&](const StreamMember& member) {
    Optimum found = optimise(member, optimisation);
    found.layout.provenance.push_back(provenance_record(program));
    const Json json = layout_to_json(found.layout);
    return MemberResult{.line = is_single && !documents.is_lines() ? dump_json(json) : dump_json_line(json),
                        .findings = {.incomplete = found.is_unverified}};
  };
  const auto take = [](int, const MemberResult& result) { write_text("-", result.line); };
  Findings findings;
  if (is_single) {
    const MemberResult result = work(layouts.member(1));
    take(1, result);
    findings = result.findings;
  } else {
    findings = work_in_processes(layouts, 1, work, {.program = program_name, .take = take}).findings;
  }
  require_no_failures(findings.failed, layouts.size(), "layouts have no result");
  if (findings.incomplete > 0)
    throw SolverError(fmt::format("{} could not verify what was found", flags.verify_by));
}

int run_program(int argc, char** argv) {
  Flags flags;
  const auto program = optimise_program(flags);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_compatible(flags);
  require_trace(flags);
  std::unique_ptr<MpiSession> mpi;
  if (is_model(flags.model) || is_model(flags.verify_by)) mpi = mpi_for_models(argc, argv);
  const OpenFile trace = temporary_file();
  const Optimisation optimisation = optimisation_of(flags, trace);
  DocumentStream documents(flags.files);
  const StoredStream layouts(documents,
                             [&](const StreamMember& member) { require_searchable(member, optimisation); });
  const auto write_trace = [&] {
    if (!flags.trace.empty()) write_text(flags.trace, read_all(trace));
  };
  try {
    search_all(flags, optimisation, documents, layouts, *program);
  } catch (...) {
    write_trace();
    throw;
  }
  write_trace();
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  return beadswim::guarded_main(beadswim::program_name, [&] { return beadswim::run_program(argc, argv); });
}
