#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace beadswim;
  const auto program = make_program("beadswim-layout",
                                    "Makes, disturbs, combines, reduces, varies and checks layouts: JSON "
                                    "files that describe a fluid and the bead-spring swimmers in it. "
                                    "Results are written to standard output.");
  program->require_subcommand(1);
  const std::vector<Command> commands{add_swimmer_command(*program), add_swarm_command(*program),
                                      add_shape_command(*program),   add_from_run_command(*program),
                                      add_defect_command(*program),  add_combine_command(*program),
                                      add_reduce_command(*program),  add_units_command(*program),
                                      add_vary_command(*program),    add_check_command(*program)};
  set_footer(*program,
             {"beadswim-layout swimmer --preset paper-single --box 72,30,30 --boundary periodic >layout.json",
              "beadswim-layout check layout.json"},
             "tutorial.md");
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;

  for (const Command& command : commands)
    if (command.flags->parsed()) command.run();
  return static_cast<int>(ExitStatus::fine);
}

}  // namespace

int main(int argc, char** argv) {
  return beadswim::guarded_main("beadswim-layout", [&] { return run(argc, argv); });
}
