#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/run_settings.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "beadswim/tools/stream_jobs.hpp"
#include "layout_filter.hpp"
#include "optimisation.hpp"

// beadswim-optimise searches the values of a few quantities of a layout for which a swimmer swims fastest,
// farthest per energy, and so on.

namespace beadswim {
namespace {

struct Flags {
  std::vector<std::string> files{"-"}, free, limits;
  std::optional<Outcome> maximise, minimise;
  std::string method = "rpy-ode", model, verify_by, trace;
  std::optional<int> evaluations;
  int seed = 1;
  EvaluatorSettings evaluator;
};

/// Objectives are all outcomes but the gap.
std::vector<std::string> objectives() {
  return {"velocity", "angular_velocity", "efficiency", "power"};
}

std::vector<std::string> mobility_models() {
  std::vector<std::string> names;
  for (const auto& [model, name] : name_table<RunModel>)
    if (mobility_model(model)) names.emplace_back(name);
  return names;
}

void add_objective(CLI::App& program, const std::string& flag, std::optional<Outcome>& objective,
                   const std::string& help) {
  add_word(program, flag, objectives(), "", help,
           [&objective](const std::string& word) { objective = from_text<Outcome>(word); });
}

std::unique_ptr<CLI::App> optimise_program(Flags& flags) {
  auto program =
      make_program(optimise_name,
                   "Searches the values of a few quantities of a layout for which its swimmer swims "
                   "fastest, most efficiently or with least power. Writes the layout with these "
                   "values.");
  add_layout_files(*program, flags.files);
  program
      ->add_option("--free", flags.free,
                   "What may change (a flag of beadswim-layout swimmer without --, or a JSON pointer; "
                   "several have equal values), and its bounds. Repeatable")
      ->type_name("NAME[,NAME...]=FROM:TO")
      ->required()
      ->allow_extra_args(false);
  add_objective(*program, "--maximise", flags.maximise, "What is to be as large as possible");
  add_objective(*program, "--minimise", flags.minimise, "What is to be as small as possible, signs included");
  program
      ->add_option(
          "--subject-to", flags.limits,
          "A limit of velocity, angular_velocity, efficiency, power, or of gap, the smallest between "
          "the beads of an arm. Repeat the flag for more.")
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
      ->default_str("100 per free quantity");
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
  return program;
}

Aims aims_of(const Flags& flags) {
  if (flags.maximise.has_value() == flags.minimise.has_value())
    throw InputError("--maximise", "name one objective with --maximise or --minimise");
  Aims aims;
  aims.is_maximised = flags.maximise.has_value();
  aims.objective = aims.is_maximised ? *flags.maximise : *flags.minimise;
  for (const std::string& text : flags.limits) aims.limits.push_back(parse_limit(text));
  return aims;
}

void require_compatible(const Flags& flags) {
  if (is_model(flags.method))
    throw InputError("--method",
                     fmt::format("{0} is a model of beadswim-run; write --model {0}", flags.method));
  if (flags.evaluator.cycles && flags.model.empty() && !is_model(flags.verify_by))
    throw InputError("--cycles", "is for models only; leave it out, or name a model");
}

/// Throws InputError if the trace cannot be written, or would replace an input.
void require_trace(const Flags& flags) {
  if (flags.trace.empty()) return;
  for (const std::string& file : flags.files) require_other_file(file, flags.trace);
  const std::filesystem::path path(flags.trace);
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (std::filesystem::is_directory(path) || access(folder.c_str(), W_OK) != 0)
    throw InputError("--trace",
                     fmt::format("\"{}\" cannot be written; name a file in a folder that exists and "
                                 "that you may write to",
                                 flags.trace));
}

int run(int argc, char** argv) {
  Flags flags;
  const auto program = optimise_program(flags);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  const Aims aims = aims_of(flags);
  const std::vector<FreeValue> free = parse_free_values(flags.free);
  require_compatible(flags);
  require_trace(flags);
  const std::string& by = flags.model.empty() ? flags.method : flags.model;
  std::optional<MpiSession> mpi;
  if (is_model(by) || is_model(flags.verify_by)) mpi.emplace(&argc, &argv);
  const NamedEvaluator evaluator{by, evaluator_named(by, "--method", flags.evaluator)};
  std::optional<NamedEvaluator> verifier;
  if (!flags.verify_by.empty())
    verifier = {flags.verify_by, evaluator_named(flags.verify_by, "--verify-by", flags.evaluator)};

  const int dimensions = static_cast<int>(free.size());
  const int evaluations = flags.evaluations.value_or(100 * dimensions);
  OpenFile trace = temporary_file();
  filter_layouts(flags.files, *program, FilterOutput::like_input,
                 [&](const StreamMember& member, const LayoutDocument&, const auto& emit) {
                   Optimisation optimisation(member, aims, free, evaluator, trace);
                   optimisation.begin();
                   optimisation.find({.constraints = aims.constraints(),
                                      .evaluations = evaluations,
                                      .seed = static_cast<unsigned long>(flags.seed)});
                   if (verifier) optimisation.verify(*verifier);
                   emit(optimisation.best());
                 });
  if (!flags.trace.empty()) write_text(flags.trace, read_all(trace));
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  return beadswim::guarded_main(beadswim::optimise_name, [&] { return beadswim::run(argc, argv); });
}
