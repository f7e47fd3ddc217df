#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// Command "beadswim-layout reduce": finds the smallest periodic cell that gives the layout when it is
/// repeated. It reads a file or standard input and writes the cell to standard output.
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
