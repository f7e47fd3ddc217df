#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <map>
#include <sstream>

#include "beadswim/core/error.hpp"
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
  program->add_option("LAYOUT", request.layout_path, "Layout file (JSON); - is standard input.");
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
  begin_group(*program, "Input");
  program->add_flag(
      "--jsonl", request.json_lines,
      "Read one layout per line and write one prediction document per line; stop at the first invalid line.");
  set_footer(*program,
             {"beadswim-theory layout.json >theory.json",
              "for T in 2400 4800; do \\\n"
              "beadswim-layout swimmer --preset paper-single --unbounded --period $T --jsonl; done | \\\n"
              "beadswim-theory --jsonl >sweep.jsonl"},
             "theory.md");
  program->footer("Methods:\n" + wrapped(method_names(), 2) + "\n" + program->get_footer());
  return program;
}

/// Returns the name of the layout in messages.
std::string layout_source(const TheoryRequest& request) {
  return request.layout_path == "-" ? "standard input" : request.layout_path;
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

/// Counters for input with one layout per line: all layouts, layouts with warnings, layouts with omitted
/// methods.
struct Tally {
  int layouts = 0, warned = 0, incomplete = 0;

  void count(const PredictionDocument& predicted) {
    ++layouts;
    warned += predicted.warnings.empty() ? 0 : 1;
    incomplete += predicted.left_out.empty() ? 0 : 1;
  }

  void report() const {
    if (warned > 0)
      print_to_stderr(fmt::format(
          "beadswim-theory: {} of {} layouts have warnings: see the key \"warnings\" of each prediction\n",
          warned, layouts));
    if (incomplete > 0) {
      print_to_stderr(
          fmt::format("beadswim-theory: methods were left out for {} of {} layouts: see the key \"left_out\" "
                      "of each prediction\n",
                      incomplete, layouts));
    }
  }
};

void predict_lines(const TheoryRequest& request, const std::optional<MeasuredStroke>& measured,
                   const CLI::App& program) {
  std::istringstream lines(read_text(request.layout_path));
  int number = 0;
  Tally tally;
  for (std::string line; std::getline(lines, line);) {
    const std::string source = fmt::format("{} line {}", layout_source(request), ++number);
    const LayoutDocument layout = layout_from_json(parse_json(line, source), source);
    const PredictionDocument predicted = predict_layout(layout, source, request, measured);
    write_text("-", dump_json_line(predictions_json(predicted, program)));
    tally.count(predicted);
  }
  tally.report();
}

int run(int argc, char** argv) {
  TheoryRequest request;
  const auto program = theory_program(request);
  if (const auto done = parse_command_line(*program, argc, argv)) return *done;
  std::optional<MeasuredStroke> measured;
  if (request.stroke_path) measured = read_measured_stroke(*request.stroke_path, request.swimmer);
  if (request.json_lines) {
    predict_lines(request, measured, *program);
  } else {
    const PredictionDocument predicted =
        predict_layout(read_layout(request.layout_path), layout_source(request), request, measured);
    write_text("-", dump_json(predictions_json(predicted, *program)));
    print_warnings(predicted);
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-theory", [&] { return beadswim::run(argc, argv); });
}
