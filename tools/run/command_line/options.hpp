#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_settings.hpp"

namespace beadswim {

/// Form of the progress messages on standard error. `automatic`: a bar on a terminal, otherwise lines.
enum class ProgressStyle { automatic, bar, lines, json, none };

template <>
inline constexpr auto name_table<ProgressStyle> =
    std::to_array<NamedValue<ProgressStyle>>({{ProgressStyle::automatic, "auto"},
                                              {ProgressStyle::bar, "bar"},
                                              {ProgressStyle::json, "json"},
                                              {ProgressStyle::lines, "lines"},
                                              {ProgressStyle::none, "none"}});

/// The command line of beadswim-run.
struct RunOptions {
  std::vector<std::string> layouts{"-"};
  std::string output;
  RunSettings settings;              ///< the model is `automatic` until a plan has chosen one
  bool plan = false;                 ///< true: prints the plan and does not run
  std::optional<double> tolerance;   ///< of a plan: largest relative error of velocity and arm amplitudes
  double accepted_error = 0.1;       ///< largest expected relative error without a warning
  std::string restart;               ///< checkpoint or trajectory; empty: begins at time 0
  std::optional<double> time_limit;  ///< wall time [s]
  ProgressStyle progress = ProgressStyle::automatic;
  std::optional<int> ranks_per_run;  ///< ranks of one run of a stream; nullopt: as few as keep all busy
  bool with_provenance = true;
  Json provenance;              ///< provenance record of this program
  std::set<std::string> given;  ///< long names of the flags on the command line; "LAYOUT" if it is there

  RecordProvenance record_provenance() const {
    return with_provenance ? RecordProvenance::written : RecordProvenance::left_out;
  }
};

/// Values of flags as text, by the name of the flag.
using FlagValues = std::map<std::string, std::string>;

/// Parses the command line. For --help and --version, prints the requested text and returns an exit status.
/// `defaults`: values that replace the program's default values of flags, for example values from a
/// checkpoint. Throws InputError if the command line or `defaults` are invalid.
std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv,
                                                const FlagValues& defaults = {});

/// Throws InputError if the command line contains one of the flags. `why`: text that follows the name of the
/// flag in the message.
void refuse_flags(const RunOptions& options, std::initializer_list<const char*> flags,
                  const std::string& why);

/// Throws InputError if the command line contains a flag of other models than `model`, which is not
/// automatic.
void refuse_flags_of_other_models(const RunOptions& options, RunModel model);

/// Returns the flags that affect the motion of the beads, with their values in `settings`. These values must
/// stay the same when a run continues from a checkpoint.
FlagValues result_flags(const RunSettings& settings);

/// Returns the flags that set the length of the run and its outputs, with their values in `settings`. A run
/// that continues from a checkpoint uses these values, unless its command line contains other values.
FlagValues length_and_output_flags(const RunSettings& settings);

}  // namespace beadswim
