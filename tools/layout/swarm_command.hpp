#pragma once

#include <CLI/CLI.hpp>

#include "beadswim/scene/swarm.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {

/// Command "beadswim-layout swarm": writes a layout to standard output. The layout consists of equal blocks
/// of swimmers in a periodic box.
class SwarmCommand {
 public:
  explicit SwarmCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  SwarmPlan plan() const;

  CLI::App* command_;
  SwimmerFlags flags_;
  std::string block_swimmers_, blocks_, core_gap_, block_gap_;
};

}  // namespace beadswim
