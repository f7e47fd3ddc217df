#pragma once

#include <fmt/core.h>

#include <string>

#include "beadswim/core/names.hpp"

// Settings (parameters that the user of a program or the caller of a library chooses) and their names in
// messages. A name is a flag of the program, or the words in the table below.

namespace beadswim {

enum class Setting : int {
  amplitude,
  arm,
  bead_boundary,
  boundary,
  box,
  cells_per_radius,
  checkpoint_every,
  count,
  cycle,
  cycles,
  damping,
  delay_correction,
  evaluations,
  flow_every,
  fraction,
  frame,
  frames_per_cycle,
  free_quantity,
  friction,
  limit,
  lubrication,
  maximise,
  method,
  minimise,
  model,
  multipole_order,
  output,
  period,
  plan,
  precision,
  radius_correction,
  ranks,
  refinement,
  relaxation_time,
  repair,
  restart,
  reynolds_stress,
  seed,
  sigma,
  steps_per_cycle,
  stiffness,
  stroke_record,
  sum_tolerance,
  swimmer,
  tolerance,
  unbounded,
  verification,
  viscosity,
};

template <>
inline constexpr auto name_table<Setting> =
    std::to_array<NamedValue<Setting>>({{Setting::amplitude, "the amplitude"},
                                        {Setting::arm, "the arms' length"},
                                        {Setting::bead_boundary, "bead boundary"},
                                        {Setting::boundary, "boundary"},
                                        {Setting::box, "box"},
                                        {Setting::cells_per_radius, "cells per radius"},
                                        {Setting::checkpoint_every, "interval of checkpoints"},
                                        {Setting::count, "count"},
                                        {Setting::cycle, "cycle"},
                                        {Setting::cycles, "cycles"},
                                        {Setting::damping, "the damping"},
                                        {Setting::delay_correction, "delay correction"},
                                        {Setting::evaluations, "evaluations"},
                                        {Setting::flow_every, "interval of flow fields"},
                                        {Setting::fraction, "fraction"},
                                        {Setting::frame, "the frame of the forces"},
                                        {Setting::frames_per_cycle, "frames per cycle"},
                                        {Setting::free_quantity, "free quantity"},
                                        {Setting::friction, "friction coefficient"},
                                        {Setting::limit, "limit"},
                                        {Setting::lubrication, "lubrication correction"},
                                        {Setting::maximise, "maximise"},
                                        {Setting::method, "method"},
                                        {Setting::minimise, "minimise"},
                                        {Setting::model, "model"},
                                        {Setting::multipole_order, "multipole order"},
                                        {Setting::output, "trajectory"},
                                        {Setting::period, "the period"},
                                        {Setting::plan, "a plan"},
                                        {Setting::precision, "precision"},
                                        {Setting::radius_correction, "radius correction"},
                                        {Setting::ranks, "ranks"},
                                        {Setting::refinement, "number of finer levels"},
                                        {Setting::relaxation_time, "relaxation time"},
                                        {Setting::repair, "repair of overlaps"},
                                        {Setting::restart, "a checkpoint"},
                                        {Setting::reynolds_stress, "Reynolds stress"},
                                        {Setting::seed, "seed"},
                                        {Setting::sigma, "sigma"},
                                        {Setting::steps_per_cycle, "steps per cycle"},
                                        {Setting::stiffness, "the stiffness"},
                                        {Setting::stroke_record, "a run's record"},
                                        {Setting::sum_tolerance, "tolerance of sums"},
                                        {Setting::swimmer, "swimmer"},
                                        {Setting::tolerance, "tolerance"},
                                        {Setting::unbounded, "unbounded fluid"},
                                        {Setting::verification, "verification"},
                                        {Setting::viscosity, "the viscosity"}});

/// Returns the name of a setting in messages: the result of the function given to set_setting_names(), or the
/// words in the table above if a program has not called set_setting_names().
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
