#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "beadswim/scene/layout.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/study/named_quantity.hpp"

namespace beadswim {

/// Converts a flag's value to a vector. The value is three numbers joined by commas, or one number for all
/// components.
Vec3 parse_vector(const std::string& text);

/// Returns the known unit with this name. Throws InputError if there is none.
const Units::Unit& unit_named(Quantity quantity, const std::string& name, const std::string& flag);

/// Parses "lattice" or the names of the units of length, time and mass: "um,s,pg".
Units parse_units(const std::string& text, const std::string& flag);

/// Flags of named quantities (study/named_quantity.hpp), of the units of the layout and of its temperature.
class QuantityFlags {
 public:
  /// Adds the flag of a quantity to the command. `initial`: describes the default, for the help; empty if the
  /// quantity has none.
  void add(CLI::App& command, const NamedQuantity& quantity, const std::string& initial);
  void add_units(CLI::App& command);

  /// Returns the values of the flags that are given. Throws InputError for a temperature without SI units.
  QuantityValues values() const;
  void apply(Fluid& fluid) const;
  Units units() const { return parse_units(units_, "--units"); }

 private:
  QuantityValues values_;
  std::string units_;
  std::string temperature_;  ///< in kelvin, as 300K
};

/// Prints a warning if a phase in radian is more than one turn, and was probably meant in degrees. `phase`:
/// value of the flag.
void warn_of_turns(const std::string& phase);

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
