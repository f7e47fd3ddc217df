#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace beadswim {

/// beadswim-layout reduce: the smallest periodic cell of a layout, as a filter.
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
