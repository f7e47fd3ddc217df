#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/figure/figure.hpp"
#include "beadswim/figure/swarm_picture.hpp"
#include "beadswim/figure/swimmer_sketch.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {

/// The files of the command line.
struct PlotFiles {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string data;  ///< file of the numbers drawn; empty: none
};

/// A drawn figure: SVG, and its numbers as comma-separated values.
struct Drawn {
  Drawn(const Figure& figure) : svg(figure_to_svg(figure)), csv(figure_to_csv(figure)) {}
  Drawn(const SwarmPicture& picture)
      : svg(swarm_picture_to_svg(picture)), csv(swarm_picture_to_csv(picture)) {}
  Drawn(const SwimmerSketch& sketch)
      : svg(swimmer_sketch_to_svg(sketch)), csv(swimmer_sketch_to_csv(sketch)) {}

  std::string svg, csv;
};

/// Reads the inputs and draws the figure. Throws InputError for invalid inputs.
using Drawing = std::function<Drawn(const PlotFiles&)>;

/// A kind of figure. Each kind is a command of the program.
struct PlotKind {
  const char* name;
  const char* description;
  const char* inputs;                       ///< help on the input files
  Drawing (*add_flags)(CLI::App& command);  ///< adds flags, and returns the function that draws
  std::array<const char*, 2> examples;      ///< examples at the end of the help
};

Drawing add_against_flags(CLI::App& command);
Drawing add_stroke_flags(CLI::App& command);
Drawing add_period_flags(CLI::App& command);
Drawing add_separation_flags(CLI::App& command);
Drawing add_speed_flags(CLI::App& command);
Drawing add_trajectory_flags(CLI::App& command);
Drawing add_swarm_flags(CLI::App& command);
Drawing add_swimmer_flags(CLI::App& command);
Drawing add_product_flags(CLI::App& command);

/// Returns all kinds, in the order of the program's help.
std::span<const PlotKind> plot_kinds();

}  // namespace beadswim
