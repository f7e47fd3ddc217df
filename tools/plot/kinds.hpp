#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/tools/program.hpp"

namespace beadswim {

/// The files of the command line.
struct PlotFiles {
  std::vector<std::string> inputs;
  std::string output = "-";
};

/// Reads the inputs and returns the figure as an SVG document. Throws InputError.
using Drawing = std::function<std::string(const PlotFiles&)>;

/// A kind of figure, which is a command of the program.
struct PlotKind {
  const char* name;
  const char* description;
  const char* inputs;                       ///< help on the files that the kind reads
  Drawing (*add_flags)(CLI::App& command);  ///< adds the kind's own flags, and returns what draws by them
  std::array<const char*, 2> examples;      ///< at the end of its help
};

Drawing add_stroke_flags(CLI::App& command);
Drawing add_period_flags(CLI::App& command);
Drawing add_separation_flags(CLI::App& command);
Drawing add_speed_flags(CLI::App& command);
Drawing add_trajectory_flags(CLI::App& command);
Drawing add_swarm_flags(CLI::App& command);
Drawing add_swimmer_flags(CLI::App& command);
Drawing add_product_flags(CLI::App& command);

/// All kinds, in the order of the program's help.
std::span<const PlotKind> plot_kinds();

}  // namespace beadswim
