#pragma once

#include <set>

#include "beadswim/run/run_settings.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {

/// Adds the flags of the settings of one group to the program: names, help, defaults and allowed values
/// follow from the table of settings. Parsing a flag stores its value in `settings`.
void add_setting_flags(CLI::App& program, SettingGroup group, RunSettings& settings);

/// Returns the settings whose flags are on the command line, after parsing.
std::set<Setting> chosen_settings(const CLI::App& program);

}  // namespace beadswim
