#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/io/document_stream.hpp"
#include "beadswim/study/stream.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/program.hpp"
#include "predict_layout.hpp"

// beadswim-theory predicts velocity and stroke of a swimmer by all theory methods that can treat it, or by
// the methods that --method names.

namespace beadswim {
namespace {

std::string method_names() {
  std::string names = "all";
  for (const Method& method : methods()) names += ", " + method.name;
  return names;
}

std::string stroke_methods() {
  std::vector<std::string> names;
  for (const Method& method : methods()) {
    if (method.uses_stroke()) names.push_back(method.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::unique_ptr<CLI::App> theory_program(TheoryRequest& request) {
  auto program = make_program("beadswim-theory",
                              "Predicts the velocity and stroke of one swimmer by every method that can "
                              "treat it, from closed formulas to exact Stokes flow, in unbounded fluid or in "
                              "the layout's box, with and without inertia. Prints the predictions as JSON.");
  program->add_option("LAYOUT", request.layout_paths, "Layout files (JSON, JSON Lines); - is standard input.")
      ->default_str("-");
  begin_group(*program, "Methods");
  program
      ->add_option("--method", request.methods,
                   "Methods to use, from the list below; all uses every method that can treat the swimmer")
      ->delimiter(',')
      ->allow_extra_args(false)  // otherwise CLI11 takes the name of the layout as a method
      ->default_str("all")
      ->type_name("NAME,...");
  begin_group(*program, "Input");
  program
      ->add_option("--swimmer", request.swimmer,
                   "Id of the swimmer to predict; required if the swimmers of the layout differ")
      ->check(whole_number(0, std::numeric_limits<int>::max()))
      ->type_name("ID");
  program
      ->add_option("--stroke-from", request.stroke_path,
                   "Run record with the measured stroke (last cycle) for " + stroke_methods())
      ->type_name("FILE");
  begin_group(*program, "Methods");
  program
      ->add_option("--tolerance", request.tolerance,
                   "Expected relative error of the methods of second order in the driving amplitude above "
                   "which a warning is printed [1]")
      ->type_name("E")
      ->check(finite_positive())
      ->capture_default_str();
  begin_group(*program, "Streams of layouts");
  program
      ->add_option("--jobs", request.jobs,
                   "Number of processes that treat the layouts of a stream at the same time")
      ->type_name("N")
      ->check(whole_number(1, 1024))
      ->default_str("one per processor");
  program->add_flag("--jsonl", request.json_lines,
                    "Write the document on one line also if the input is a single layout.");
  set_footer(*program,
             {"beadswim-theory layout.json >theory.json",
              "beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
              "beadswim-layout vary --over period=2400,4800,9600 | beadswim-theory >study.jsonl"},
             "theory.md");
  program->footer("Methods:\n" + wrapped(method_names(), 2) + "\n" + program->get_footer());
  return program;
}

/// Adds this program to the provenance of the document and converts the document to JSON.
Json predictions_json(PredictionDocument predicted, const CLI::App& program) {
  predicted.provenance.push_back(provenance_record(program));
  return predictions_to_json(predicted);
}

/// Prints one line per reason, which lists the theory methods that were omitted for this reason.
void print_left_out_methods(const std::vector<LeftOutMethod>& left_out) {
  std::map<std::string, std::vector<std::string>> methods_by_reason;
  for (const auto& [method, reason] : left_out) methods_by_reason[reason].push_back(method);
  for (const auto& [reason, names] : methods_by_reason) {
    print_to_stderr(
        fmt::format("beadswim-theory: methods left out: {}; reason: {}\n", fmt::join(names, ", "), reason));
  }
}

void print_warnings(const PredictionDocument& predicted) {
  for (const std::string& warning : predicted.warnings)
    print_to_stderr("beadswim-theory: warning: " + warning + "\n");
  print_left_out_methods(predicted.left_out);
}

void predict_stream(const StoredStream& layouts, const TheoryRequest& request,
                    const std::optional<MeasuredStroke>& measured, const CLI::App& program) {
  const auto work = [&](const StreamMember& member) {
    const PredictionDocument predicted = predict_layout(layout_of(member), member.source, request, measured);
    return MemberResult{
        .line = dump_json_line(predictions_json(predicted, program)),
        .findings = {.warned = !predicted.warnings.empty(), .incomplete = !predicted.left_out.empty()}};
  };
  const auto tell = [](const std::string& text) { print_to_stderr("beadswim-theory: " + text + "\n"); };
  const int count = layouts.size();
  const auto [failed, warned, incomplete, negative] =
      work_in_processes(layouts, request.jobs, work,
                        {.program = program.get_name(),
                         .take = [](int, const MemberResult& result) { write_text("-", result.line); },
                         .progress = tell})
          .findings;
  if (warned > 0)
    tell(fmt::format("{} of {} layouts have warnings: see the key \"warnings\" of each prediction", warned,
                     count));
  if (incomplete > 0)
    tell(
        fmt::format("methods were left out for {} of {} layouts: see the key \"left_out\" of each prediction",
                    incomplete, count));
  require_no_failures(failed, count, "layouts have no prediction");
}

int run(int argc, char** argv) {
  TheoryRequest request;
  request.jobs = usable_processors();
  const auto program = theory_program(request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  std::optional<MeasuredStroke> measured;
  if (request.stroke_path) measured = read_measured_stroke(*request.stroke_path, request.swimmer);
  DocumentStream layouts(request.layout_paths);
  if (!layouts.is_single()) {
    for (const std::string& name : request.methods)
      if (name != "all") find_method(name);  // throws InputError if there is none
    const StoredStream all(layouts, [](const StreamMember& layout) { layout_of(layout); });
    predict_stream(all, request, measured, *program);
  } else {
    const StreamMember layout = *layouts.next();
    const PredictionDocument predicted = predict_layout(layout_of(layout), layout.source, request, measured);
    const Json json = predictions_json(predicted, *program);
    write_text("-", request.json_lines || layouts.is_lines() ? dump_json_line(json) : dump_json(json));
    print_warnings(predicted);
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-theory", [&] { return beadswim::run(argc, argv); });
}
