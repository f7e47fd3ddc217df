#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// Formats each flag alike: its name and values on one line; below it, wrapped, its description, and in
/// brackets its unit, its default, and whether it is required. A description states the unit in brackets at
/// its end. The help of all commands has the form from which help2man makes sections of a manual page: one
/// per *command*, and all examples, which begin with $, in one.
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
