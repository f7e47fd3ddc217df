#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// Command "beadswim-layout reduce": finds the smallest periodic box whose periodic copies give the scene of
/// a layout. It reads a file or standard input and writes the layout of this box to standard output.
class ReduceCommand {
 public:
  explicit ReduceCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  CLI::App* command_;
  std::string file_ = "-";
  double tolerance_ = 1e-6;
};

}  // namespace beadswim
