#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "beadswim/scene/layout.hpp"

// The commands of beadswim-layout. Each function adds a command to the program. `run` executes the command
// with the flags of the command line, and throws InputError if they or the layouts are invalid.

namespace beadswim {

struct Command {
  CLI::App* flags = nullptr;
  std::function<void()> run;
  std::function<Layout()> make{};  ///< of a command that makes a layout from flags: returns this layout
};

Command add_swimmer_command(CLI::App& program);  ///< writes a layout of one swimmer
Command add_swarm_command(CLI::App& program);    ///< writes a layout of equal blocks of swimmers
Command add_shape_command(CLI::App& program);    ///< writes a layout of one swimmer of the gallery
Command add_defect_command(CLI::App& program);   ///< applies random changes to layouts
Command add_combine_command(CLI::App& program);  ///< writes one scene with the swimmers of several layouts
Command add_reduce_command(CLI::App& program);   ///< finds the smallest periodic box of layouts
Command add_from_run_command(CLI::App& program);  ///< writes a layout that starts where a run was
Command add_units_command(CLI::App& program);     ///< writes layouts in other units
Command add_vary_command(CLI::App& program);     ///< writes layouts with all values of varied quantities
Command add_check_command(CLI::App& program);    ///< checks layouts and prints their dimensionless numbers

}  // namespace beadswim
