#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

// Quantities of layouts that have names: the parameters of the paper's three-bead swimmer and of its fluid.

namespace beadswim {

/// Fluid and swimmer that the named quantities describe.
struct SwimmerParameters {
  ThreeBeadSwimmer swimmer{};
  Fluid fluid{};
};

/// Values that a quantity may have: numbers, an angle [radian], or the name of a DrivingFrame.
enum class QuantityRange { positive, non_negative, angle, frame };

/// Field of each bead, of each spring, of the swimmer, of its driving or of the fluid.
using QuantityField = std::variant<double Bead::*, double Spring::*, double ThreeBeadSwimmer::*,
                                   double ThreeBeadDriving::*, std::array<double, 2> ThreeBeadDriving::*,
                                   DrivingFrame ThreeBeadDriving::*, double Fluid::*>;

struct NamedQuantity {
  std::string name;     ///< with words joined by "-"
  std::string group;    ///< of quantities, for the help
  std::string help;     ///< description with the unit
  std::string symbols;  ///< forms of the value: "R|R1,R2,R3"
  std::size_t count;    ///< number of values that may differ between beads, springs or forces
  QuantityRange range;
  QuantityField field;
  std::string initial{};  ///< describes the value without preset; empty: it must be given
};

/// Returns all quantities, in the order of messages.
const std::vector<NamedQuantity>& named_quantities();

/// Returns the quantity with this name, or nullptr.
const NamedQuantity* find_quantity(const std::string& name);

/// Values by the names of quantities: a number, a list of `count` numbers, or a word.
using QuantityValues = std::map<std::string, Json>;

/// Sets the values, which must be allowed.
void set_quantities(SwimmerParameters& parameters, const QuantityValues& values);

/// Sets the values in all types and in the fluid of a layout. The angular stiffness of a type and the
/// resolution follow if they have their defaults. Throws InputError if a type is not a swimmer of three beads
/// on a line; `source`: name of the layout for the message.
void set_quantities(Layout& layout, const QuantityValues& values, const std::string& source);

/// Returns why the quantity cannot have the value, a number or a word; empty if it can.
std::string value_fault(const NamedQuantity& quantity, const Json& value);

}  // namespace beadswim
