#pragma once

#include <map>
#include <optional>
#include <set>
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
  std::string model = "lbm";  ///< lbm, rpy, rpy+near or oseen; auto: what a plan finds (run_plan.hpp)
  bool plan = false;          ///< say what runs could be, and run none
  double tolerance = 1e-4;    ///< of mobility sums; with model auto of the run
  int steps_per_cycle = 100;  ///< of the mobility models, for the shortest period
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
  std::optional<double> checkpoint_every;  ///< [cycle]
  std::string restart;                     ///< empty: a run that begins anew
  std::optional<double> time_limit;        ///< [s]
  std::optional<double> flow_every;        ///< [cycle]
  ProgressStyle progress = ProgressStyle::automatic;
  bool with_provenance = true;
  Json provenance;              ///< this program's own record
  std::set<std::string> given;  ///< flags on the command line, by their long names, and "LAYOUT"
};

/// Flags and their values, as text.
using FlagValues = std::map<std::string, std::string>;

/// The options, or an exit status if --help or --version was all that was asked for. Throws InputError.
/// `defaults`: of flags that the command line may leave out, instead of the usual ones.
std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv,
                                                const FlagValues& defaults = {});

/// Throws InputError, `why` after the flag's name, if one of these is on the command line.
void refuse_flags(const RunOptions& options, std::initializer_list<const char*> flags,
                  const std::string& why);

/// The flags that set the course of a run, with the values of these options: a run goes on with the same.
FlagValues course_of(const RunOptions& options);

/// Flags that a run goes on with unless it is given others.
FlagValues length_and_outputs_of(const RunOptions& options);

}  // namespace beadswim
