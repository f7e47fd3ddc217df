#pragma once

#include <CLI/CLI.hpp>

#include "swimmer_flags.hpp"

namespace beadswim {

/// Command "beadswim-layout swimmer": writes a layout of one swimmer to standard output.
class SwimmerCommand {
 public:
  explicit SwimmerCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  CLI::App* command_;
  SwimmerFlags flags_;
  PlaceFlags place_;
  bool json_lines_ = false;
};

}  // namespace beadswim
