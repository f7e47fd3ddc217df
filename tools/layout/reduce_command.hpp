#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Command "beadswim-layout reduce": finds the smallest periodic box whose periodic copies give the scene of
/// a layout, or puts a single swimmer in another box. It reads a file or standard input and writes the layout
/// of the box to standard output.
class ReduceCommand {
 public:
  explicit ReduceCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  void reduce_to_cell(Layout& layout) const;
  void put_in_box(Layout& layout) const;

  CLI::App* command_;
  std::vector<std::string> files_{"-"};
  std::string box_;
  double tolerance_ = 1e-6;
};

}  // namespace beadswim
