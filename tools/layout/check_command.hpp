#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace beadswim {

/// Command "beadswim-layout check": checks a layout and prints its dimensionless numbers. run() throws
/// InputError if the layout is invalid.
class CheckCommand {
 public:
  explicit CheckCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run() const;

 private:
  CLI::App* command_;
  std::vector<std::string> files_{"-"};
  bool json_ = false;
};

}  // namespace beadswim
