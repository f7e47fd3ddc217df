#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/defects.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {

/// Command "beadswim-layout defect KIND": applies random changes to a layout. It reads a file or standard
/// input and writes to standard output, so that commands for several defects can be joined by pipes.
class DefectCommand {
 public:
  explicit DefectCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  using Change = std::function<void(Layout&)>;

  /// Adds the command for one kind of defect, with the flags that all kinds have in common. `examples`: flags
  /// of each example in the help of the command.
  CLI::App& add_kind(const std::string& name, const std::vector<std::string>& examples,
                     const std::string& help, Change change);
  /// Adds the flags --fraction and --count. `things`: what the flags count, and `otherwise`: the default,
  /// both for the help.
  void add_amount_flags(CLI::App& kind, const std::string& things, const std::string& otherwise);
  void add_sigma(CLI::App& kind, const std::string& help,
                 const CLI::Validator& values = number_between(0, 1e6));
  void add_random(CLI::App& kind, const std::string& help);
  void add_mixture();
  void add_numbers();
  void add_places();
  void add_drivings();
  void add_spacing();

  /// Returns the value of --fraction or --count. Throws InputError if neither is given.
  ShareOrCount share_or_count() const;
  /// Returns the value of --fraction or --count. Returns the fraction 1 if neither is given.
  ShareOrCount amount_or_all() const;
  /// Draws the swimmers to change at random and returns their indices.
  std::vector<std::size_t> chosen_swimmers(const Layout& layout) const;

  CLI::App* command_;
  std::vector<std::pair<CLI::App*, Change>> kinds_;
  std::vector<std::string> files_{"-"};
  std::string other_, axis_;
  std::optional<double> fraction_, sigma_;
  std::optional<std::int64_t> count_;
  double whole_ = 0;
  std::int64_t seed_ = 1;
  bool random_ = false, repair_ = false;
};

}  // namespace beadswim
