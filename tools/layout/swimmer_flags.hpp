#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// The vector that a flag's text is: three numbers, or one for all three.
Vec3 vector_of(const std::string& text);

/// A scene of the paper, to start from.
struct Preset {
  std::string name;
  Layout (*layout)() = nullptr;
};

/// The flags that describe a type of swimmer and its fluid, as text; empty where not given.
class SwimmerFlags {
 public:
  /// preset_help: what the presets are.
  SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help);

  /// The preset's scene with the flags' values in place, or a scene of the flags alone; its one type is "a".
  /// Throws InputError that names the flags that are missing, `further` among them if there is no preset.
  Layout layout(const std::vector<std::string>& further) const;

  const std::string& preset() const { return preset_; }  ///< empty if none

 private:
  void add_swimmer(CLI::App& command);
  void add_driving(CLI::App& command);
  void add_fluid(CLI::App& command);

  void require_complete(const std::vector<std::string>& further) const;
  Layout preset_layout() const;
  void apply_beads(SwimmerType& type, double default_density) const;
  void apply_springs(SwimmerType& type) const;
  void apply_driving(Driving& driving) const;
  void apply_fluid(Fluid& fluid) const;
  Units units() const;

  std::vector<Preset> presets_;
  std::string preset_;
  std::string radius_, arm_, stiffness_, damping_, angular_stiffness_, bead_density_;
  std::string amplitude_, phase_, period_;
  std::optional<DrivingFrame> frame_;
  std::string viscosity_, density_, units_;
};

/// The flags that say where one swimmer is, and in what box.
class PlaceFlags {
 public:
  explicit PlaceFlags(CLI::App& command);

  /// Whether a box, or none, is asked for.
  bool say_box() const { return !box_.empty() || unbounded_; }

  /// Puts a swimmer of the layout's type "a" into it, and changes its box to what the flags say.
  void apply(Layout& layout) const;

 private:
  void apply_domain(std::optional<Box>& domain) const;

  std::string box_, boundary_;
  bool unbounded_ = false;
  std::string position_, axis_;
};

}  // namespace beadswim
