#include <fmt/format.h>

#include <sstream>

#include "beadswim/core/error.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/program.hpp"
#include "predict_layout.hpp"

// beadswim-theory: predictions for a layout's swimmer, by all methods that can treat it or by those named.

namespace beadswim {
namespace {

std::string method_names() {
  std::string names = "all";
  for (const Method& method : methods()) names += ", " + method.name;
  return names;
}

std::unique_ptr<CLI::App> theory_program(TheoryRequest& request) {
  auto program =
      make_program("beadswim-theory",
                   "Predicts velocity and stroke of one swimmer in unbounded fluid without inertia, in the "
                   "layout's units. Reads a layout, writes predictions as JSON on stdout.");
  program->add_option("LAYOUT", request.layout_path, "Layout file; - is stdin.");
  program
      ->add_option("--method", request.methods,
                   "Methods, joined by commas: " + method_names() +
                       ". all leaves out those that cannot treat the swimmer.")
      ->delimiter(',')
      ->allow_extra_args(false)  // or it would swallow the layout's name
      ->default_str("all")
      ->type_name("NAME,...");
  program
      ->add_option("--swimmer", request.swimmer,
                   "Predict the swimmer of this id; needed if the swimmers differ.")
      ->type_name("ID");
  program
      ->add_option(
          "--stroke-from", request.stroke_path,
          "Run record whose last cycle gives oseen-stroke-closed the stroke, of the swimmer of --swimmer or "
          "of the first.")
      ->type_name("FILE");
  program->add_flag("--jsonl", request.json_lines,
                    "Read one layout a line, write one prediction document a line.");
  return program;
}

/// What messages call the layout.
std::string layout_source(const TheoryRequest& request) {
  return request.layout_path == "-" ? "standard input" : request.layout_path;
}

/// The document's JSON, with this program's record in its provenance.
Json predictions_json(PredictionDocument predicted, const CLI::App& program) {
  predicted.provenance.push_back(provenance_record(program));
  return predictions_to_json(predicted);
}

void predict_lines(const TheoryRequest& request, const std::optional<MeasuredStroke>& measured,
                   const CLI::App& program) {
  std::istringstream lines(read_text(request.layout_path));
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string source = fmt::format("{} line {}", layout_source(request), ++number);
    const LayoutDocument layout = layout_from_json(parse_json(line, source), source);
    const PredictionDocument predicted = predict_layout(layout, source, request, measured);
    write_text("-", dump_json_line(predictions_json(predicted, program)));
  }
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
  }
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace
}  // namespace beadswim

int main(int argc, char** argv) {
  try {
    return beadswim::run(argc, argv);
  } catch (...) {
    return beadswim::report_current_exception("beadswim-theory");
  }
}
