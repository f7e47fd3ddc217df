#include "beadswim/study/named_quantity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/scene/presets.hpp"

namespace beadswim {
namespace {

using enum QuantityRange;

constexpr const char* driving_law =
    "Driving: F1 = A sin(2 pi t/T), F3 = B sin(2 pi t/T + alpha), F2 = -(F1 + F3)";

double number_at(const Json& value, std::size_t index) {
  return value.is_array() ? value.at(value.size() == 1 ? 0 : index).get<double>() : value.get<double>();
}

/// Sets one field of the parameters.
struct FieldSetter {
  SwimmerParameters& parameters;
  const Json& value;

  void operator()(double Bead::*field) const { set_each(parameters.swimmer.beads, field); }
  void operator()(double Spring::*field) const { set_each(parameters.swimmer.springs, field); }
  void operator()(double ThreeBeadSwimmer::*field) const { parameters.swimmer.*field = number_at(value, 0); }
  void operator()(double ThreeBeadDriving::*field) const {
    parameters.swimmer.driving.*field = number_at(value, 0);
  }
  void operator()(std::array<double, 2> ThreeBeadDriving::*field) const {
    parameters.swimmer.driving.*field = {number_at(value, 0), number_at(value, 1)};
  }
  void operator()(DrivingFrame ThreeBeadDriving::*field) const {
    value.get_to(parameters.swimmer.driving.*field);
  }
  void operator()(double Fluid::*field) const { parameters.fluid.*field = number_at(value, 0); }

  void set_each(auto& parts, auto field) const {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].*field = number_at(value, i);
  }
};

bool are_equal(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::abs(b);
}

bool are_equal(const Resolution& a, const Resolution& b) {
  return are_equal(a.cells_per_radius, b.cells_per_radius) && are_equal(a.relaxation_time, b.relaxation_time);
}

}  // namespace

const std::vector<NamedQuantity>& named_quantities() {
  static const std::vector<NamedQuantity> quantities{
      {"radius", "Beads", "Radius of the beads: one value for all, or one per bead [length]", "R|R1,R2,R3", 3,
       positive, &Bead::radius},
      {"arm", "Springs", "Rest length of the springs, between the centres of adjacent beads [length]",
       "L|L1,L2", 2, positive, &Spring::rest_length},
      {"stiffness", "Springs", "Stiffness k of the springs, force per extension [mass/time^2]", "K|K1,K2", 2,
       positive, &Spring::stiffness},
      {"damping", "Springs",
       "Damping c of the dashpots parallel to the springs, force per rate of extension [mass/time]",
       "C|C1,C2", 2, non_negative, &Spring::damping, "the preset's, else 0"},
      {"angular-stiffness", "Springs",
       "Stiffness K_A of the angular spring with energy K_A theta^2/2; theta: angle between the arms [mass "
       "length^2/time^2]",
       "KA", 1, non_negative, &ThreeBeadSwimmer::angular_stiffness, "10 k l^2"},
      {"bead-density", "Beads", "Mass density of the beads [mass/length^3]", "RHO", 1, positive,
       &Bead::density, "the preset's, else the fluid's"},
      {"amplitude", driving_law,
       "Amplitudes A and B of the driving forces on beads 1 and 3 [mass length/time^2]", "A|A,B", 2,
       non_negative, &ThreeBeadDriving::amplitude},
      {"phase", driving_law,
       "Phase alpha by which the force on bead 3 is ahead of that on bead 1, as 1.5 or 90deg; write a "
       "negative phase after an equals sign [rad]",
       "ALPHA", 1, angle, &ThreeBeadDriving::phase, "the preset's, else pi/2"},
      {"period", driving_law, "Period T of the driving forces [time]", "T", 1, positive,
       &ThreeBeadDriving::period},
      {"frame", driving_law,
       "Direction of the driving forces: the x axis (lab), the swimmer's axis at time 0 (initial-axis), or "
       "its arms as they turn (body)",
       "", 1, frame, &ThreeBeadDriving::frame, "lab"},
      {"viscosity", "Fluid and box", "Kinematic viscosity nu of the fluid [length^2/time]", "NU", 1, positive,
       &Fluid::kinematic_viscosity},
      {"density", "Fluid and box", "Mass density of the fluid [mass/length^3]", "RHO", 1, positive,
       &Fluid::density, "1"},
      {"thermal-energy", "Fluid and box",
       "Thermal energy kT of the fluid, whose noise moves beads in mobility models; 0: no noise [mass "
       "length^2/time^2]",
       "KT", 1, non_negative, &Fluid::thermal_energy, "0"}};
  return quantities;
}

const NamedQuantity* find_quantity(const std::string& name) {
  const auto found = std::ranges::find(named_quantities(), name, &NamedQuantity::name);
  return found == named_quantities().end() ? nullptr : &*found;
}

void set_quantities(SwimmerParameters& parameters, const QuantityValues& values) {
  for (const auto& [name, value] : values)
    std::visit(FieldSetter{parameters, value}, find_quantity(name)->field);
}

void set_quantities(Layout& layout, const QuantityValues& values, const std::string& source) {
  const SwimmerType& first = layout.types.begin()->second;
  const bool has_unit_resolution =
      layout.resolution && are_equal(*layout.resolution, unit_resolution(first, layout.fluid));
  SwimmerParameters parameters{.fluid = layout.fluid};
  for (auto& [name, type] : layout.types) {
    const std::optional<ThreeBeadSwimmer> swimmer = three_bead_form(type);
    if (!swimmer)
      throw InputError(
          fmt::format("{}:/types/{}", source, name),
          "this is not a swimmer of three beads on a line, which flags of beadswim-layout swimmer "
          "describe; name what varies by a JSON pointer, such as /types/a/beads/0/radius");
    const bool is_straightened = are_equal(swimmer->angular_stiffness, straightening_stiffness(*swimmer));
    parameters.swimmer = *swimmer;
    set_quantities(parameters, values);
    if (is_straightened && !values.contains("angular-stiffness"))
      parameters.swimmer.angular_stiffness = straightening_stiffness(parameters.swimmer);
    type = swimmer_type(parameters.swimmer);
  }
  layout.fluid = parameters.fluid;
  if (has_unit_resolution) layout.resolution = unit_resolution(first, layout.fluid);
}

std::string value_fault(const NamedQuantity& quantity, const Json& value) {
  if (value.is_array()) {
    if (value.size() != 1 && value.size() != quantity.count)
      return fmt::format("{}: the value must be {} numbers", value.dump(),
                         quantity.count == 1 ? "1" : fmt::format("1 or {}", quantity.count));
    for (const Json& each : value)
      if (const std::string fault = value_fault(quantity, each); !fault.empty()) return fault;
    return "";
  }
  const std::string text =
      value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
  if (quantity.range == frame)
    return value_named<DrivingFrame>(text) ? "" : format_unknown_name(text, all_names<DrivingFrame>());
  const double number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (number > 0 || (number == 0 && quantity.range != positive) || (number < 0 && quantity.range == angle))
    return "";
  return fmt::format("\"{}\": the value must be a finite number{}", text,
                     quantity.range == positive       ? " greater than 0"
                     : quantity.range == non_negative ? ", 0 or greater"
                                                      : " of radians, or of degrees such as 90deg");
}

}  // namespace beadswim
