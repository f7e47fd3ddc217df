#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// beadswim-layout check: refuses a faulty layout; of a sound one, its dimensionless numbers.
class CheckCommand {
 public:
  explicit CheckCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run() const;

 private:
  CLI::App* command_;
  std::string file_ = "-";
  bool json_ = false;
};

}  // namespace beadswim
