#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {

/// Converts a flag's value to a vector. The value is three numbers joined by commas, or one number for all
/// components.
Vec3 parse_vector(const std::string& text);

/// A named scene of the paper (Pickl et al. 2017). Its values are used for flags that are not given.
struct Preset {
  std::string name;
  Layout (*layout)() = nullptr;
};

/// Flags that describe a fluid and the units of the layout.
class FluidFlags {
 public:
  /// Adds the flags to the command. `default_viscosity`: for the help; empty if there is none.
  void add_to(CLI::App& command, const std::string& default_viscosity = "");

  const std::string& viscosity() const { return viscosity_; }  ///< empty if the flag is not given
  const std::string& density() const { return density_; }      ///< empty if the flag is not given
  void apply(Fluid& fluid) const;
  Units units() const;

 private:
  std::string viscosity_, density_, units_;
};

/// Sizes of the units of length, time and mass of a preset, in the units of the flag --units.
struct UnitSizes {
  double length = 1, time = 1, mass = 1;
};

/// Flags that describe a swimmer type and its fluid. The value of each flag is stored as text, which is empty
/// if the flag is not given.
class SwimmerFlags {
 public:
  /// Adds the flags to the command. `preset_help`: description of the presets, for the help.
  SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help);

  /// Returns the layout that the flags describe. It has one type, "a". Flags that are not given have the
  /// values of the preset, converted to the units of the flag --units. Without a preset, throws InputError if
  /// required flags are missing; the message lists these flags and `other_missing_flags`.
  Layout layout(const std::vector<std::string>& other_missing_flags) const;

  /// Returns the names of the flags that set one value, without --.
  static const std::vector<std::string>& single_values();
  /// Replaces the values for which flags are given in all types and in the fluid of a layout. The angular
  /// stiffness of a type and the resolution follow if they have their defaults. Throws InputError if a type
  /// is not a swimmer of three beads on a line; `source`: name of the layout for the message.
  void apply(Layout& layout, const std::string& source) const;

  const std::string& preset() const { return preset_; }  ///< name of the preset; empty if none is given
  /// Returns the sizes of the units of the preset. They follow from the bead radius, the viscosity and the
  /// density of the flags. Throws InputError if one of these is missing.
  UnitSizes preset_units() const;

 private:
  void add_swimmer(CLI::App& command);
  void add_driving(CLI::App& command);

  void require_complete(const std::vector<std::string>& other_missing_flags) const;
  Layout preset_layout() const;
  void apply_beads(ThreeBeadSwimmer& type, double default_density) const;
  void apply_springs(ThreeBeadSwimmer& type) const;
  void apply_driving(ThreeBeadDriving& driving) const;

  std::vector<Preset> presets_;
  std::string preset_;
  std::string radius_, arm_, stiffness_, damping_, angular_stiffness_, bead_density_;
  std::string amplitude_, phase_, period_;
  std::optional<DrivingFrame> frame_;
  FluidFlags fluid_;
};

/// Flags for the box, the position and the orientation of one swimmer.
class PlaceFlags {
 public:
  /// Adds the flags to the command. For the help: `origin` and `axis` are what --position and --axis set,
  /// `boundary` is the default of --boundary.
  PlaceFlags(CLI::App& command, const std::string& origin, const std::string& axis,
             const std::string& boundary);

  /// Adds the flag --orientation.
  void add_orientation(CLI::App& command);

  /// Returns true if --box, --unbounded or --half-space is given.
  bool defines_domain() const { return !box_.empty() || unbounded_ || !half_space_.empty(); }

  /// Applies the flags to the box of the layout, and replaces all swimmers by one swimmer of the first type.
  void apply(Layout& layout) const;

 private:
  void apply_domain(Domain& domain) const;

  std::string box_, boundary_, half_space_;
  bool unbounded_ = false;
  std::string position_, axis_, orientation_;
};

}  // namespace beadswim
