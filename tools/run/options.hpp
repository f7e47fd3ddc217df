#pragma once

#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/run/run_settings.hpp"
#include "progress.hpp"

namespace beadswim {

constexpr const char* program_name = "beadswim-run";

/// The command line of beadswim-run.
struct RunOptions {
  std::vector<std::string> layouts{"-"};
  std::string output;
  RunSettings settings;              ///< the model is `automatic` until a plan has chosen one
  std::set<Setting> chosen;          ///< settings whose flags are on the command line
  bool plan = false;                 ///< true: prints the plan and does not run
  std::optional<double> tolerance;   ///< of a plan: largest relative error of velocity and arm amplitudes
  std::string restart;               ///< checkpoint or trajectory; empty: begins at time 0
  std::optional<double> time_limit;  ///< wall time [s]
  ProgressStyle progress = ProgressStyle::automatic;
  std::optional<int> ranks_per_run;  ///< ranks of one run of a stream; nullopt: as few as keep all busy
  bool with_provenance = true;
  bool names_layouts = false;  ///< true: layouts are on the command line
  Json provenance;             ///< provenance record of this program

  RecordProvenance record_provenance() const {
    return with_provenance ? RecordProvenance::written : RecordProvenance::left_out;
  }
};

/// Parses the command line. For --help and --version, prints the requested text and returns an exit status.
/// `defaults`: settings of flags that are not on the command line, for example from a checkpoint. Throws
/// InputError if the command line is invalid.
std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv,
                                                const std::optional<RunSettings>& defaults = {});

}  // namespace beadswim
