#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "beadswim/core/names.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/plan/run_settings.hpp"

namespace beadswim {

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
  std::string layout = "-";
  std::string output;
  RunSettings settings;              ///< model: also auto, until a plan has chosen
  bool plan = false;                 ///< say what runs could be, and run none
  std::string restart;               ///< empty: a run that begins anew
  std::optional<double> time_limit;  ///< [s]
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

/// Throws InputError if a flag of the lattice is on the command line, which `model`, a mobility, has not.
void refuse_lattice_flags(const RunOptions& options, RunModel model);

/// The flags that set the course of a run, with the values of these settings: a run goes on with the same.
FlagValues course_of(const RunSettings& settings);

/// Flags that a run goes on with unless it is given others.
FlagValues length_and_outputs_of(const RunSettings& settings);

}  // namespace beadswim
