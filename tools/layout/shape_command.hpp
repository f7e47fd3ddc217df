#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/gallery.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {

/// Command "beadswim-layout shape KIND": writes a layout of one swimmer of the gallery to standard output.
class ShapeCommand {
 public:
  explicit ShapeCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  /// One kind of swimmer. `type` makes its type in a fluid.
  struct Kind {
    CLI::App* command = nullptr;
    std::function<SwimmerType(const Fluid&)> type;
    FluidFlags fluid;
    std::optional<PlaceFlags> place;
    bool json_lines = false;
  };

  /// Adds the kind of swimmer with these parameters. `examples`: flags of each example in the help.
  template <class Parameters>
  void add_kind(const std::string& name, const std::string& help, const std::vector<std::string>& examples);

  CLI::App* command_;
  std::vector<std::unique_ptr<Kind>> kinds_;  // flags refer to the members of a kind
};

}  // namespace beadswim
