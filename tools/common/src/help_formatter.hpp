#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// Formats the help of a program. The first line of each flag contains its name and the type of its value.
/// The next lines contain its description, followed by unit, default and "required" in brackets. If a flag
/// has a unit, the description that is passed to CLI11 must end with the unit in brackets.
///
/// The program help2man converts the output of --help-all to a manual page. A heading *command* begins a
/// section of this page. Lines that begin with $ are examples, which form one section for all commands.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_help(const CLI::App* program, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* program) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_subcommands(const CLI::App* program, CLI::AppFormatMode mode) const override;
  std::string make_expanded(const CLI::App* command) const override;

 private:
  std::string make_flag_groups(const CLI::App* program, CLI::AppFormatMode mode) const;
};

}  // namespace beadswim
