#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadswim/figure/drawing.hpp"
#include "beadswim/tools/named_flags.hpp"
#include "result_series.hpp"

// Kinds of figures, and the flags that several kinds share. Each kind is a command of the program.

namespace beadswim {

/// The files of the command line.
struct PlotFiles {
  std::vector<std::string> inputs;
  std::string output = "-";
  std::string data;  ///< file of the numbers drawn; empty: none
};

/// Reads the inputs and draws the figure. Throws InputError for invalid inputs.
using DrawFigure = std::function<Drawing(const PlotFiles&)>;

// Add the flags of a kind, and return the function that draws.
DrawFigure add_against_flags(CLI::App& command);
DrawFigure add_stroke_flags(CLI::App& command);
DrawFigure add_velocity_flags(CLI::App& command, AbscissaKind abscissa);
DrawFigure add_speed_flags(CLI::App& command);
DrawFigure add_trajectory_flags(CLI::App& command);
DrawFigure add_diffusion_flags(CLI::App& command);
DrawFigure add_swarm_flags(CLI::App& command);
DrawFigure add_flow_flags(CLI::App& command);
DrawFigure add_swimmer_flags(CLI::App& command);
DrawFigure add_product_flags(CLI::App& command);

/// Adds the flag --method.
void add_method_flag(CLI::App& command, InputChoice& choice);

/// Adds the flags --method, which selects the methods whose predictions are drawn, and --cycle, which selects
/// the cycles of runs.
void add_result_flags(CLI::App& command, InputChoice& choice);

/// Ids of swimmers, or numbers of frames.
CLI::Validator id_or_frame_number();

/// Adds the flag --swimmers, which lists ids of swimmers.
void add_swimmers(CLI::App& command, std::vector<int>& ids, const std::string& name,
                  const std::string& initial, const std::string& help);

}  // namespace beadswim
