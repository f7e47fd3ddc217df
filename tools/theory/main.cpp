#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/io/document_stream.hpp"
#include "beadswim/study/stream.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/named_flags.hpp"

// beadswim-theory predicts velocity and stroke of a swimmer by all theory methods that can treat it, or by
// the methods that --method names.

namespace beadswim {
namespace {

constexpr const char* program_name = "beadswim-theory";

struct Flags {
  std::vector<std::string> layouts{"-"};
  PredictionRequest request;
  std::optional<std::string> stroke_path;  ///< run record that contains the stroke
  bool json_lines = false;                 ///< true: one document per line also for a single layout
  int jobs = usable_processors();          ///< number of processes for a stream
};

/// Returns the names of all methods, or of those that use a measured stroke.
std::string method_names(bool (*is_listed)(const Method&)) {
  std::vector<std::string> names;
  for (const Method& method : methods())
    if (is_listed(method)) names.push_back(method.name);
  return joined(names, ", ");
}

std::unique_ptr<CLI::App> theory_program(Flags& flags) {
  auto program = make_program(program_name,
                              "Predicts the velocity and stroke of one swimmer by every method that can "
                              "treat it, from closed formulas to exact Stokes flow, in unbounded fluid or in "
                              "the layout's box, with and without inertia. Prints the predictions as JSON.");
  program->add_option("LAYOUT", flags.layouts, "Layout files (JSON, JSON Lines); - is standard input.")
      ->default_str("-");
  begin_group(*program, "Methods");
  add_value(*program, "--method", flags.request.methods, {.name = "NAME,...", .initial = "all"},
            "Methods to use, from the list below; all uses every method that can treat the swimmer")
      ->delimiter(',')
      ->allow_extra_args(false);  // otherwise CLI11 takes the name of the layout as a method
  begin_group(*program, "Input");
  add_value(*program, "--swimmer", flags.request.swimmer,
            {"ID", whole_number(0, std::numeric_limits<int>::max())},
            "Id of the swimmer to predict; required if the swimmers of the layout differ");
  add_value(*program, "--stroke-from", flags.stroke_path, {.name = "FILE"},
            "Run record with the measured stroke (last cycle) for " +
                method_names([](const Method& method) { return method.uses_stroke(); }));
  begin_group(*program, "Methods");
  add_value(*program, "--tolerance", flags.request.tolerance, {"E", finite_positive()},
            "Expected relative error of the methods of second order in the driving amplitude above which a "
            "warning is printed [1]");
  begin_group(*program, "Streams of layouts");
  add_value(*program, "--jobs", flags.jobs, {"N", whole_number(1, 1024), "one per processor"},
            "Number of processes that treat the layouts of a stream at the same time");
  program->add_flag("--jsonl", flags.json_lines,
                    "Write the document on one line also if the input is a single layout.");
  set_footer(*program,
             {"beadswim-theory layout.json >theory.json",
              "beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-layout vary --over period=2400,4800,9600 | beadswim-theory >study.jsonl"},
             "theory.md");
  const std::string names = "all, " + method_names([](const Method&) { return true; });
  program->footer("Methods:\n" + wrapped(names, 2) + "\n" + program->get_footer());
  return program;
}

void print_message(const std::string& text) {
  print_to_stderr(fmt::format("{}: {}\n", program_name, text));
}

/// Returns the stroke of the only run of a file that has one. Counts other documents on standard error.
MeasuredStroke read_measured_stroke(const std::string& path, std::optional<int> swimmer) {
  DocumentStream documents({path});
  std::vector<RunRecord> runs;
  int count = 0;
  for (; const auto member = documents.next(); ++count) {
    const Json json = parse_json(member->text, member->source);
    if (is_failure(json)) continue;
    RunRecord run = run_record_from_json(json, member->source);
    const auto has_cycle = [](const SwimmerRecord& each) { return !each.cycles.empty(); };
    if (documents.is_single() || std::ranges::any_of(run.swimmers, has_cycle)) runs.push_back(std::move(run));
  }
  if (runs.size() != 1)
    throw InputError("--stroke-from " + path,
                     "{} of {} documents are runs with a complete cycle; give the record of one such run",
                     runs.size(), count);
  if (count > 1)
    print_message(
        fmt::format("{} of {} documents of {} have no result, and are left out", count - 1, count, path));
  return measured_stroke(runs.front(), swimmer, path);
}

/// Predicts the motion in a layout of the stream. Adds this program to the provenance.
PredictionDocument predict(const StreamMember& member, const Flags& flags, const CLI::App& program) {
  const LayoutDocument document = layout_of(member);
  PredictionDocument predicted{predict_layout(document.layout, member.source, flags.request)};
  if (document.layout.swimmers.size() <= max_swimmers_listed) predicted.scene = document.layout;
  predicted.study = document.study;
  predicted.provenance = document.provenance;
  predicted.provenance.push_back(provenance_record(program));
  return predicted;
}

/// Prints the warnings, and one line per reason, which lists the theory methods that were omitted for this
/// reason.
void print_warnings(const PredictionDocument& predicted) {
  for (const std::string& warning : predicted.warnings) print_message("warning: " + warning);
  std::map<std::string, std::vector<std::string>> methods_by_reason;
  for (const auto& [method, reason] : predicted.left_out) methods_by_reason[reason].push_back(method);
  for (const auto& [reason, names] : methods_by_reason)
    print_message(fmt::format("methods left out: {}; reason: {}", joined(names, ", "), reason));
}

void predict_stream(const StoredStream& layouts, const Flags& flags, const CLI::App& program) {
  const auto work = [&](const StreamMember& member) {
    const PredictionDocument predicted = predict(member, flags, program);
    return MemberResult{
        .line = dump_json_line(predictions_to_json(predicted)),
        .findings = {.warned = !predicted.warnings.empty(), .incomplete = !predicted.left_out.empty()}};
  };
  const int count = layouts.size();
  const auto [failed, warned, incomplete, negative] =
      work_in_processes(layouts, flags.jobs, work,
                        {.program = program_name,
                         .take = [](int, const MemberResult& result) { write_text("-", result.line); },
                         .progress = print_message})
          .findings;
  if (warned > 0)
    print_message(fmt::format("{} of {} layouts have warnings: see the key \"warnings\" of each prediction",
                              warned, count));
  if (incomplete > 0)
    print_message(
        fmt::format("methods were left out for {} of {} layouts: see the key \"left_out\" of each prediction",
                    incomplete, count));
  require_no_failures(failed, count, "layouts have no prediction");
}

int run(int argc, char** argv) {
  Flags flags;
  const auto program = theory_program(flags);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  if (flags.stroke_path)
    flags.request.measured = read_measured_stroke(*flags.stroke_path, flags.request.swimmer);
  DocumentStream layouts(flags.layouts);
  if (!layouts.is_single()) {
    for (const std::string& name : flags.request.methods)
      if (name != all_methods) find_method(name);  // throws InputError if there is none
    predict_stream(StoredStream(layouts, [](const StreamMember& layout) { layout_of(layout); }), flags,
                   *program);
  } else {
    const PredictionDocument predicted = predict(*layouts.next(), flags, *program);
    const Json json = predictions_to_json(predicted);
    write_text("-", flags.json_lines || layouts.is_lines() ? dump_json_line(json) : dump_json(json));
    print_warnings(predicted);
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  return beadswim::guarded_main(beadswim::program_name, [&] { return beadswim::run(argc, argv); });
}
