#pragma once

#include <limits>
#include <string_view>

#include "beadswim/core/setting.hpp"

namespace beadswim {

/// Models to which a setting of a run applies.
enum class SettingScope { all, lattice, mobility, moments, unsteady };

/// Subject of a setting, under which the help of a program lists it.
enum class SettingGroup { model, length, lattice, checkpoints, output };

/// What is known of a setting of a run beside its type and its default (run_settings.hpp): mark of a field of
/// RunSettings. Numbers must lie between `low` and `high`.
struct SettingRow {
  Setting setting;  ///< its name in messages
  SettingGroup group = SettingGroup::lattice;
  SettingScope scope = SettingScope::all;
  std::string_view value = "";  ///< stands for the value in the help, such as N
  /// What the setting is, without full stop, and its unit in brackets at the end.
  std::string_view help = "";
  std::string_view unset = "";  ///< what a run uses if the setting has no value
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool allows_low = false;             ///< a number with decimals: `low` itself is allowed
  std::string_view too_low = "";       ///< why a number must be above `low`; empty: needs no reason
  std::string_view word_of_none = "";  ///< word for a setting without value
  std::string_view word_of_zero = "";  ///< word for 0
  bool changes_results = true;   ///< its value must stay the same when a run continues from a checkpoint
  bool is_always_named = false;  ///< a command that describes a run names it even if it has its default
};

}  // namespace beadswim
