#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// Estimated errors of a stroke.
struct StrokeUncertainty {
  std::array<double, 2> arm_amplitudes{};  ///< relative, of d_1 and d_2
  double sin_phase_shift = 0;              ///< absolute

  static void visit_fields(auto&& visit, auto& uncertainty) {
    visit("arm_amplitudes", uncertainty.arm_amplitudes);
    visit("sin_phase_shift", uncertainty.sin_phase_shift);
  }
};

/// What a method says of a swimmer, and how far to trust it. Units are those of the swimmer.
struct Prediction {
  std::string method;
  bool usable = true;    ///< false: shown, but never to be judged by
  std::string validity;  ///< where the method holds and how large its known errors are
  double velocity = 0;   ///< mean over a period, towards bead 3 if positive [length/time]
  /// Estimated relative error of the velocity: against exact Stokes flow at finite amplitude, and of methods
  /// with inertia against the Navier-Stokes flow; none if unknown.
  std::optional<double> uncertainty;
  Stroke stroke;
  std::optional<StrokeUncertainty> stroke_uncertainty;  ///< none if unknown
  double sin_phase_shift = 0;                           ///< sin(delta_1 - delta_2)
  std::optional<std::array<double, 2>> arm_means;       ///< l_i + mean change [length]; none if not predicted

  using Setting = std::pair<std::string, std::variant<std::string, double>>;
  std::vector<Setting> settings;  ///< what the method assumed, and its parts, by name

  static void visit_fields(auto&& visit, auto& prediction) {
    visit("method", prediction.method);
    visit("usable", prediction.usable);
    visit("validity", prediction.validity);
    visit("velocity", prediction.velocity);
    visit("uncertainty", prediction.uncertainty);
    visit("arm_amplitudes", prediction.stroke.amplitude);
    visit("arm_phases", prediction.stroke.phase);
    visit("sin_phase_shift", prediction.sin_phase_shift);
    visit("stroke_uncertainty", prediction.stroke_uncertainty);
    visit("arm_means", prediction.arm_means);
    visit("settings", prediction.settings);
  }
};

}  // namespace beadswim
