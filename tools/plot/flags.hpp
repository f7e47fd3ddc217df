#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/tools/named_flags.hpp"
#include "plot_inputs.hpp"

// Flags that several kinds of figures share, and flags whose values need their own parser.

namespace beadswim {

/// A name that is written beside a swimmer in the figure.
struct SwimmerMark {
  std::string name;
  int id = 0;
};

/// Methods and cycles of figures that show predictions and runs.
struct ResultFlags {
  MethodChoice methods{};
  std::string cycle = "last";

  /// Throws InputError if --cycle has another form.
  CycleChoice cycle_choice() const { return parse_cycle_choice(cycle); }
};

/// Adds the flags --method, which selects the methods whose predictions are drawn, and --cycle, which selects
/// the cycles of runs.
void add_result_flags(CLI::App& command, ResultFlags& flags);

/// Ids of swimmers, or numbers of frames.
CLI::Validator id_or_frame_number();

/// Adds a flag whose value is a list of whole numbers, joined by commas. `check`: number_list() of them.
CLI::Option* add_whole_numbers(CLI::App& command, const std::string& flag, std::vector<int>& numbers,
                               const CLI::Validator& check, const std::string& help);

/// Adds the flag --swimmers, which lists ids of swimmers.
CLI::Option* add_swimmers(CLI::App& command, std::vector<int>& ids, const std::string& help);

/// Adds the flag --frame, which selects a frame of a trajectory. `frame` is nullopt for the last frame.
void add_frame(CLI::App& command, std::optional<std::size_t>& frame);

/// Adds the flag --mark, which lists names to write beside swimmers.
void add_marks(CLI::App& command, std::vector<SwimmerMark>& marks);

}  // namespace beadswim
