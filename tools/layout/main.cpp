#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"
#include "check_command.hpp"
#include "defect_command.hpp"
#include "reduce_command.hpp"
#include "shape_command.hpp"
#include "swarm_command.hpp"
#include "swimmer_command.hpp"
#include "vary_command.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace beadswim;
  const auto program = make_program(
      "beadswim-layout",
      "Makes, disturbs, reduces, varies and checks layouts: JSON files that describe a fluid and the "
      "bead-spring swimmers in it. Results are written to standard output.");
  program->require_subcommand(1);
  SwimmerCommand swimmer(*program);
  SwarmCommand swarm(*program);
  ShapeCommand shape(*program);
  DefectCommand defect(*program);
  ReduceCommand reduce(*program);
  VaryCommand vary(*program);
  CheckCommand check(*program);
  set_footer(*program,
             {"beadswim-layout swimmer --preset paper-single --box 72,30,30 --boundary periodic >layout.json",
              "beadswim-layout check layout.json"},
             "tutorial.md");
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;

  if (swimmer.is_chosen()) swimmer.run(*program);
  if (swarm.is_chosen()) swarm.run(*program);
  if (shape.is_chosen()) shape.run(*program);
  if (defect.is_chosen()) defect.run(*program);
  if (reduce.is_chosen()) reduce.run(*program);
  if (vary.is_chosen()) vary.run(*program);
  if (check.is_chosen()) check.run();
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-layout", [&] { return run(argc, argv); });
}
