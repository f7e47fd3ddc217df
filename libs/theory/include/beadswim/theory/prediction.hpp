#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/theory/passive_diffusion.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// Estimated errors of a predicted stroke.
struct StrokeUncertainty {
  std::array<double, 2> arm_amplitudes{};  ///< relative errors of the arm amplitudes
  double sin_phase_shift = 0;              ///< absolute error of sin(delta_1 - delta_2)

  BEADSWIM_FIELDS(arm_amplitudes, sin_phase_shift)
};

/// Velocity and stroke of a swimmer by one method, with their uncertainty, in the units of the swimmer.
struct Prediction {
  std::string method;
  bool usable = true;    ///< false: printed, but not used as a reference
  std::string validity;  ///< range of validity and known errors, as text
  double velocity = 0;   ///< mean over a period, along the axis of the swimmer [length/time]
  /// Velocity and angular velocity in the box [length/time, radian/time]; nullopt for three beads on a line
  /// in fluid at rest without half-space.
  std::optional<Vec3> velocity_vector{}, angular_velocity{};
  /// Estimated error of `velocity`, relative to the exact velocity; nullopt if unknown. The exact velocity
  /// follows from the Stokes equations at finite amplitude, or from the Navier-Stokes equations for methods
  /// with inertia.
  std::optional<double> uncertainty;
  Stroke stroke;
  std::optional<StrokeUncertainty> stroke_uncertainty;  ///< nullopt if unknown
  double sin_phase_shift = 0;                           ///< sin(delta_1 - delta_2)
  std::optional<double> power;       ///< mean power of the driving forces [mass length^2/time^3]
  std::optional<double> efficiency;  ///< Lighthill efficiency; predict() sets it and `power` (methods.hpp)
  std::optional<ForceDipole> dipole{};           ///< mean, [mass length^2/time^2]; nullopt if not predicted
  std::optional<std::vector<double>> arm_means;  ///< mean arm lengths [length]; nullopt if not predicted
  std::optional<ThermalPrediction> thermal{};    ///< nullopt without thermal energy

  using Setting = std::pair<std::string, std::variant<std::string, double>>;
  std::vector<Setting> settings;  ///< names and values: assumptions, contributions to `velocity`

  static void visit_fields(auto&& visit, auto& prediction) {
    visit("method", prediction.method);
    visit("usable", prediction.usable);
    visit("validity", prediction.validity);
    visit("velocity", prediction.velocity);
    visit("velocity_vector", prediction.velocity_vector, omitted_if_none);
    visit("angular_velocity", prediction.angular_velocity, omitted_if_none);
    visit("uncertainty", prediction.uncertainty);
    visit("arm_amplitudes", prediction.stroke.amplitude);
    visit("arm_phases", prediction.stroke.phase);
    visit("sin_phase_shift", prediction.sin_phase_shift);
    visit("power", prediction.power, omitted_if_none);
    visit("efficiency", prediction.efficiency, omitted_if_none);
    visit("dipole", prediction.dipole, omitted_if_none);
    visit("stroke_uncertainty", prediction.stroke_uncertainty);
    visit("arm_means", prediction.arm_means);
    visit("thermal", prediction.thermal, omitted_if_none);
    visit("settings", prediction.settings);
  }
};

}  // namespace beadswim
