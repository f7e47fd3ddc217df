#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace beadswim {

/// Command "beadswim-layout vary": reads layouts and writes each with all values of the varied quantities,
/// one layout per line.
class VaryCommand {
 public:
  explicit VaryCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  CLI::App* command_;
  std::vector<std::string> files_{"-"}, variations_;
  bool together_ = false;
};

}  // namespace beadswim
