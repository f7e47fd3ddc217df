#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/defects.hpp"

namespace beadswim {

/// beadswim-layout defect KIND: filters that disturb a layout, from a file or standard input to standard
/// output.
class DefectCommand {
 public:
  explicit DefectCommand(CLI::App& program);

  bool is_chosen() const { return command_->parsed(); }
  void run(const CLI::App& program) const;

 private:
  using Change = std::function<void(Layout&)>;

  /// Adds a kind of defect with the flags common to all kinds. `examples`: flags of the examples in its help.
  CLI::App& add_kind(const std::string& name, const std::vector<std::string>& examples,
                     const std::string& help, Change change);
  void add_how_many(CLI::App& kind, const std::string& things, const std::string& otherwise);
  void add_sigma(CLI::App& kind, const std::string& help);
  void add_random(CLI::App& kind, const std::string& help);
  void add_mixture();
  void add_numbers();
  void add_places();
  void add_drivings();
  void add_spacing();

  ShareOrCount share_or_count() const;  ///< throws InputError if that is not said
  ShareOrCount how_many_or_all() const;
  std::vector<std::size_t> chosen(const Layout& layout) const;

  CLI::App* command_;
  std::vector<std::pair<CLI::App*, Change>> kinds_;
  std::string file_ = "-", other_, axis_;
  std::optional<double> fraction_, sigma_;
  std::optional<std::int64_t> count_;
  double whole_ = 0;
  std::int64_t seed_ = 1;
  bool random_ = false, repair_ = false;
};

}  // namespace beadswim
