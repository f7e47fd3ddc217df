#pragma once

#include <fmt/core.h>

#include <string>

#include "beadswim/core/error.hpp"

// Settings (parameters that the user of a program or the caller of a library chooses) and their names in
// messages. A name is a flag of the program, or the identifier in words.

namespace beadswim {

// clang-format off
#define BEADSWIM_SETTINGS                                                                                    \
  amplitude, arm, bead_boundary, boundary, box, cells_per_radius, checkpoint_every, count, cycle, cycles,    \
  damping, delay_correction, evaluations, flow_every, flow_frame, flow_mean, flow_points, flow_region,       \
  flow_spacing, fraction, frame, frames_per_cycle, frames_with, free_quantity, friction, limit, lubrication,  \
  maximise, method, minimise, model, multipole_order, noise_tolerance, output, period, plan, precision, radius_correction, ranks,       \
  refinement, relaxation_time, repair, restart, reynolds_stress, seed, sigma, steps_per_cycle, stiffness,    \
  stroke_record, sum_tolerance, swimmer, temperature, thermal_energy, tolerance, unbounded, verification, viscosity
// clang-format on

enum class Setting : int { BEADSWIM_SETTINGS };

const char* identifier_of(Setting setting);  ///< returns for example "relaxation_time"

/// Returns the identifier of a setting in words, for example "relaxation time".
std::string words_of(Setting setting);

/// Returns the name of a setting in messages: the result of the function given to set_setting_names(), or
/// words_of(setting) if a program has not called set_setting_names().
std::string name_of(Setting setting);

/// Sets the function `name`, which returns the name of a setting in all later messages, for example the flag
/// of the program. A program calls set_setting_names() once, before it uses a library.
void set_setting_names(std::string (*name)(Setting));

}  // namespace beadswim

template <>
struct fmt::formatter<beadswim::Setting> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  template <typename Context>
  auto format(beadswim::Setting setting, Context& context) const {
    return fmt::format_to(context.out(), "{}", beadswim::name_of(setting));
  }
};
