#include <fmt/core.h>

#include <cstdio>
#include <sstream>

#include "beadswim/core/communicator.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "cases.hpp"

// beadswim-verification measures the errors of the bead boundary schemes and prints docs/verification.md, the
// page about them.

namespace {

using namespace beadswim;
using namespace beadswim::verification;

struct Options {
  std::vector<std::string> cases;
  std::vector<BeadScheme> schemes{all_values<BeadScheme>.begin(), all_values<BeadScheme>.end()};
  bool brief = false;
  std::string report;
};

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const Case& one : all_cases()) names.push_back(one.name);
  return names;
}

std::unique_ptr<CLI::App> verification_program(Options& options) {
  options.cases = case_names();
  auto program = make_program("beadswim-verification",
                              "Measures beads in the lattice-Boltzmann fluid against references, one JSON "
                              "record a line on stdout. One process.");
  program->add_option("--case", options.cases, "Cases to measure.")
      ->delimiter(',')
      ->check(CLI::IsMember(case_names()))
      ->type_name("NAME,...");
  add_choices(*program, "--scheme", options.schemes, "Bead boundary schemes.");
  program->add_flag("--brief", options.brief, "A part of each case, in seconds.");
  program
      ->add_option("--report", options.report,
                   "Measures nothing: prints the page about the records in this file, Markdown.")
      ->type_name("FILE");
  return program;
}

std::vector<Json> read_records(const std::string& path) {
  std::vector<Json> records;
  std::istringstream lines(read_text(path));
  for (std::string line; std::getline(lines, line);) records.push_back(parse_json(line, path));
  return records;
}

int run(int argc, char** argv) {
  Options options;
  const auto program = verification_program(options);
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;
  if (!options.report.empty()) {
    write_text("-", verification_page(read_records(options.report)));
    return 0;
  }
  const auto emit = [](const Json& record) {
    std::fputs(dump_json_line(record).c_str(), stdout);
    std::fflush(stdout);
  };
  for (const Case& one : all_cases()) {
    if (std::ranges::count(options.cases, one.name) == 0) continue;
    for (const BeadScheme scheme : options.schemes)
      one.measure(scheme, options.brief ? Extent::brief : Extent::whole, emit);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const MpiSession mpi(&argc, &argv);
  return guarded_main("beadswim-verification", [&] { return run(argc, argv); });
}
