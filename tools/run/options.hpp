#pragma once

#include <optional>
#include <string>
#include <variant>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/lattice/precision.hpp"

namespace beadswim {

enum class ProgressStyle { automatic, bar, lines, json, none };

/// The command line of beadswim-run.
struct RunOptions {
  std::string layout = "-";
  std::string output;
  double cycles = 6;
  int frames_per_cycle = 40;
  std::optional<double> cells_per_radius;
  std::optional<double> relaxation_time;
  BeadScheme bead_boundary = BeadScheme::mr;
  bool delay_correction = true;
  bool radius_correction = true;
  bool lubrication = true;
  double friction = 0.5;
  Precision precision = Precision::fp64;
  std::optional<double> time_limit;  ///< [s]
  std::optional<double> flow_every;  ///< [cycle]
  ProgressStyle progress = ProgressStyle::automatic;
  bool with_provenance = true;
  Json provenance;  ///< this program's own record
};

/// The options, or an exit status if --help or --version was all that was asked for. Throws InputError.
std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv);

}  // namespace beadswim
