#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/io/document_stream.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/program.hpp"
#include "beadswim/tools/stream_jobs.hpp"
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

/// Findings of the work on one layout of a stream, combined as bits.
enum Findings { warned = 1, incomplete = 2, failed = 4 };

/// Reads all layouts. Throws InputError if one is invalid. Returns their number.
int check_layouts(DocumentStream& layouts) {
  int count = 0;
  for (; const auto member = layouts.next(); ++count) layout_of(*member);
  layouts.rewind();
  return count;
}

void predict_stream(DocumentStream& layouts, const TheoryRequest& request,
                    const std::optional<MeasuredStroke>& measured, const CLI::App& program) {
  for (const std::string& name : request.methods)
    if (name != "all") find_method(name);  // throws InputError if there is none
  const int count = check_layouts(layouts);
  const auto failure_of = [&](const StreamMember& member, const std::string& reason) {
    const FailureDocument failure{.program = program.get_name(),
                                  .member = member.number,
                                  .reason = reason,
                                  .study = layout_of(member).study};
    return MemberResult{failure_line(failure), failed};
  };
  const auto work = [&](const StreamMember& member) {
    try {
      const PredictionDocument predicted =
          predict_layout(layout_of(member), member.source, request, measured);
      return MemberResult{
          dump_json_line(predictions_json(predicted, program)),
          (predicted.warnings.empty() ? 0 : warned) | (predicted.left_out.empty() ? 0 : incomplete)};
    } catch (const std::exception& error) {
      return failure_of(member, error.what());
    }
  };
  StreamProgress progress(program.get_name(), count);
  std::map<int, int> layouts_with;  // number of layouts, by finding
  const auto take = [&](const StreamMember& member, const std::optional<MemberResult>& result) {
    const MemberResult done =
        result ? *result : failure_of(member, "the process ended; its memory may not have been sufficient");
    write_text("-", done.text);
    for (const int finding : {warned, incomplete, failed})
      layouts_with[finding] += (done.state & finding) != 0;
    progress.update(member.number);
  };
  for_each_member(layouts, std::min(request.jobs, count), work, take);
  if (layouts_with[warned] > 0)
    print_to_stderr(fmt::format(
        "beadswim-theory: {} of {} layouts have warnings: see the key \"warnings\" of each prediction\n",
        layouts_with[warned], count));
  if (layouts_with[incomplete] > 0)
    print_to_stderr(
        fmt::format("beadswim-theory: methods were left out for {} of {} layouts: see the key "
                    "\"left_out\" of each prediction\n",
                    layouts_with[incomplete], count));
  require_no_failures(layouts_with[failed], count, "layouts have no prediction");
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
    predict_stream(layouts, request, measured, *program);
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
