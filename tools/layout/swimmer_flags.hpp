#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"
#include "beadswim/study/named_quantity.hpp"

namespace beadswim {

/// Converts a flag's value to a vector. The value is three numbers joined by commas, or one number for all
/// components.
Vec3 parse_vector(const std::string& text);

/// A named scene of the paper (Pickl et al. 2017). Its values are used for flags that are not given.
struct Preset {
  std::string name;
  Layout (*layout)() = nullptr;
};

/// Flags of named quantities (study/named_quantity.hpp), and of the units of the layout.
class QuantityFlags {
 public:
  /// Adds the flag of a quantity to the command. `initial`: describes the default, for the help; empty if the
  /// quantity has none.
  void add(CLI::App& command, const NamedQuantity& quantity, const std::string& initial);
  void add_units(CLI::App& command);

  const QuantityValues& values() const { return values_; }  ///< contains only the flags that are given
  void apply(Fluid& fluid) const;
  Units units() const;

 private:
  QuantityValues values_;
  std::string units_;
};

/// Prints a warning if a phase in radian is more than one turn, and was probably meant in degrees. `phase`:
/// value of the flag.
void warn_of_turns(const std::string& phase);

/// Sizes of the units of length, time and mass of a preset, in the units of the flag --units.
struct UnitSizes {
  double length = 1, time = 1, mass = 1;
};

/// Flags that describe a swimmer type and its fluid.
class SwimmerFlags {
 public:
  /// Adds the flags to the command. `preset_help`: description of the presets, for the help.
  SwimmerFlags(CLI::App& command, std::vector<Preset> presets, const std::string& preset_help);

  /// Returns the layout that the flags describe. It has one type, "a". Flags that are not given have the
  /// values of the preset, converted to the units of the flag --units. Without a preset, throws InputError if
  /// required flags are missing; the message lists these flags and `other_missing_flags`.
  Layout layout(const std::vector<std::string>& other_missing_flags) const;

  const std::string& preset() const { return preset_; }  ///< name of the preset; empty if none is given
  /// Returns the sizes of the units of the preset. They follow from the bead radius, the viscosity and the
  /// density of the flags. Throws InputError if one of these is missing.
  UnitSizes preset_units() const;

 private:
  void require_complete(const std::vector<std::string>& other_missing_flags) const;
  Layout preset_layout() const;

  std::vector<Preset> presets_;
  std::string preset_;
  QuantityFlags quantities_;
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
