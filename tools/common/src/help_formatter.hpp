#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// Help with a flag and its values on one line, and below it, wrapped, what it means and its default.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_description(const CLI::App* program) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

}  // namespace beadswim
