#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/run/run_settings.hpp"
#include "beadswim/study/stream.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "beadswim/tools/stop_signal.hpp"
#include "optimisation.hpp"

// beadswim-optimise searches for the values of a few quantities of a layout with which a swimmer swims
// fastest, most efficiently, and so on.

namespace beadswim {
namespace {

struct Flags {
  std::vector<std::string> files{"-"}, free, constraints;
  std::optional<ResultQuantity> maximise, minimise;
  std::string method = "rpy-ode", model, verify_by, trace;
  std::optional<int> evaluations;
  int seed = 1;
  EvaluatorSettings evaluator;
};

/// Default of --evaluations, for the number of free values.
int default_evaluations(int dimensions) {
  return dimensions == 1 ? 100 : 200 * dimensions;
}

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
      make_program(optimise_name,
                   "Searches for the values of a few quantities of a layout with which its swimmer swims "
                   "fastest, most efficiently or with least power. Writes the layout with these "
                   "values.");
  program->add_option("layout", flags.files, "Layout files (JSON, JSON Lines); - is standard input.")
      ->type_name("FILE")
      ->default_str("-");
  program
      ->add_option("--free", flags.free,
                   "A quantity that may change (a flag of beadswim-layout swimmer without --, or a JSON "
                   "pointer; several take equal values), and its bounds. Repeatable")
      ->type_name("NAME[,NAME...]=FROM:TO")
      ->required()
      ->allow_extra_args(false);
  add_objective(*program, "--maximise", flags.maximise,
                "Result, from the list below, that is to be as large as possible");
  add_objective(*program, "--minimise", flags.minimise,
                "Result, from the list below, that is to be as small as possible; velocity: with its sign");
  program
      ->add_option(
          "--subject-to", flags.constraints,
          "A limit of one of these results; gap: the smallest between the beads of an arm. Repeatable")
      ->type_name("NAME=[MIN]:[MAX]")
      ->default_str("none")
      ->allow_extra_args(false);
  begin_group(*program, "Evaluation");
  CLI::Option* method =
      program
          ->add_option("--method", flags.method, "Theory method of beadswim-theory that evaluates a layout")
          ->type_name("NAME")
          ->capture_default_str();
  add_word(*program, "--model", mobility_models(), "",
           "Model of beadswim-run that evaluates a layout instead",
           [&flags](const std::string& word) { flags.model = word; })
      ->excludes(method);
  program
      ->add_option("--verify-by", flags.verify_by,
                   "Method or model, also lbm, that evaluates the layout that was found once more")
      ->type_name("NAME")
      ->default_str("none");
  program
      ->add_option("--cycles", flags.evaluator.cycles, "Length of each run by a model; its last cycle counts")
      ->type_name("N")
      ->check(finite_positive())
      ->default_str("as beadswim-run");
  program->add_option("--swimmer", flags.evaluator.swimmer, "Id of the swimmer")
      ->type_name("ID")
      ->check(whole_number(0, std::numeric_limits<int>::max()))
      ->default_str("theory: all, if they are equal; models: their mean");
  begin_group(*program, "Search");
  program->add_option("--evaluations", flags.evaluations, "Largest number of evaluations of the search")
      ->type_name("N")
      ->check(whole_number(10, 1000000))
      ->default_str("100; for several free values 200 per value");
  program
      ->add_option("--seed", flags.seed,
                   "Seed of the random numbers of the search for four quantities or more")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<int>::max()))
      ->capture_default_str();
  program->add_option("--trace", flags.trace, "File for all evaluations, one per line (JSON Lines)")
      ->type_name("FILE")
      ->default_str("none");
  set_footer(*program,
             {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-optimise --free phase=0:180deg --maximise velocity >fastest.json",
              "beadswim-optimise layout.json --free amplitude=0.01:0.3 --free stiffness=0.01:0.3 \\\n"
              "--maximise efficiency --subject-to power=:0.0001 --verify-by multipole-ode >efficient.json"},
             "optimise.md");
  program->footer("Results:\n" + wrapped(fmt::format("{}", fmt::join(outcome_names(), ", ")), 2) + "\n" +
                  program->get_footer());
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
    throw InputError("--method",
                     fmt::format("{} is a model of beadswim-run; use --model or --verify-by", flags.method));
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
    throw InputError("--trace",
                     fmt::format("\"{}\" cannot be written; name a file in a folder that exists and "
                                 "that you may write to",
                                 flags.trace));
}

/// Initialises MPI, which models need. Throws InputError on more than one rank.
std::unique_ptr<MpiSession> mpi_for_models(int argc, char** argv) {
  auto mpi = std::make_unique<MpiSession>(&argc, &argv);
  catch_stop_signals();
  if (Communicator(MPI_COMM_WORLD).size() > 1)
    throw InputError("mpirun", "the program uses one rank; start it without mpirun");
  return mpi;
}

NamedEvaluator evaluator_of(const Flags& flags) {
  if (!flags.model.empty()) return {flags.model, model_evaluator(flags.model, flags.evaluator)};
  return {flags.method, theory_evaluator(flags.method, "--method", {}, flags.evaluator)};
}

NamedEvaluator verifier_of(const Flags& flags) {
  const std::string& name = flags.verify_by;
  if (is_model(name)) return {name, model_evaluator(name, flags.evaluator)};
  std::vector<std::string> models;
  for (const std::string& model : all_names<RunModel>())
    if (is_model(model)) models.push_back(model);
  return {name, theory_evaluator(name, "--verify-by", models, flags.evaluator)};
}

/// The search for all layouts of the command line.
class Searches {
 public:
  Searches(const Flags& flags, const CLI::App& program)
      : flags_(flags),
        program_(program),
        problem_(problem_of(flags)),
        free_(parse_free_values(flags.free)),
        by_(evaluator_of(flags)) {
    if (!flags.verify_by.empty()) verifier_ = verifier_of(flags);
    DocumentStream documents(flags.files);
    is_single_ = documents.is_single();
    is_line_ = documents.is_lines();
    layouts_ = StoredStream(
        documents, [&](const StreamMember& member) { Optimisation(member, problem_, free_, by_, trace_); });
  }

  /// Writes the layouts that were found, or failures in their place. Throws InputError or SolverError if
  /// one has none.
  void run() {
    const auto work = [&](const StreamMember& member) { return find(member); };
    const auto take = [](int, const MemberResult& result) { write_text("-", result.line); };
    Findings findings;
    if (is_single_) {
      const MemberResult result = find(layouts_.member(1));
      take(1, result);
      findings = result.findings;
    } else {
      findings = work_in_processes(layouts_, 1, work, {.program = optimise_name, .take = take}).findings;
    }
    require_no_failures(findings.failed, layouts_.size(), "layouts have no result");
    if (findings.incomplete > 0)
      throw SolverError(fmt::format("{} could not verify what was found", flags_.verify_by));
  }

  std::string trace() const { return read_all(trace_); }

 private:
  MemberResult find(const StreamMember& member) {
    const int dimensions = static_cast<int>(free_.size());
    Optimisation optimisation(member, problem_, free_, by_, trace_);
    optimisation.begin();
    if (verifier_) optimisation.require_treated_by(*verifier_);
    optimisation.find({.num_inequalities = problem_.num_inequalities(),
                       .evaluations = flags_.evaluations.value_or(default_evaluations(dimensions)),
                       .seed = static_cast<unsigned long>(flags_.seed)});
    const bool is_unverified = verifier_ && !optimisation.verify(*verifier_);
    LayoutDocument layout = optimisation.best();
    layout.provenance.push_back(provenance_record(program_));
    const Json json = layout_to_json(layout);
    return {.line = is_single_ && !is_line_ ? dump_json(json) : dump_json_line(json),
            .findings = {.incomplete = is_unverified}};
  }

  const Flags& flags_;
  const CLI::App& program_;
  const Problem problem_;
  const std::vector<FreeValue> free_;
  StoredStream layouts_;
  bool is_single_ = false;
  bool is_line_ = false;  ///< of a single layout: it is a line
  const OpenFile trace_ = temporary_file();
  const NamedEvaluator by_;
  std::optional<NamedEvaluator> verifier_;
};

int run(int argc, char** argv) {
  Flags flags;
  const auto program = optimise_program(flags);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  require_compatible(flags);
  require_trace(flags);
  std::unique_ptr<MpiSession> mpi;
  if (is_model(flags.model) || is_model(flags.verify_by)) mpi = mpi_for_models(argc, argv);
  Searches searches(flags, *program);
  const auto write_trace = [&] {
    if (!flags.trace.empty()) write_text(flags.trace, searches.trace());
  };
  try {
    searches.run();
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
  return beadswim::guarded_main(beadswim::optimise_name, [&] { return beadswim::run(argc, argv); });
}
