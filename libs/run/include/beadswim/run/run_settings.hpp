#pragma once

#include <fmt/core.h>

#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"

namespace beadswim {

/// Model that moves the beads: a lattice-Boltzmann fluid, or a mobility.
enum class RunModel {
  lbm,
  rpy,
  rpy_near,
  multipole,
  unsteady,
  oseen,
  automatic,  ///< the cheapest model whose expected error is within the tolerance
};

template <>
inline constexpr auto name_table<RunModel> =
    std::to_array<NamedValue<RunModel>>({{RunModel::lbm, "lbm"},
                                         {RunModel::rpy, "rpy"},
                                         {RunModel::rpy_near, "rpy+near"},
                                         {RunModel::multipole, "multipole"},
                                         {RunModel::unsteady, "unsteady"},
                                         {RunModel::oseen, "oseen"},
                                         {RunModel::automatic, "auto"}});

// Convert between RunModel and MobilityModel. A mobility model has the same name in both enumerations. The
// function mobility_model() returns nullopt for other models.
inline RunModel run_model(MobilityModel model) {
  return from_text<RunModel>(to_text(model));
}
inline std::optional<MobilityModel> mobility_model(RunModel model) {
  return value_named<MobilityModel>(to_text(model));
}

/// What frames of a trajectory have beside positions and velocities.
enum class FrameContent { none, forces };

template <>
inline constexpr auto name_table<FrameContent> =
    std::to_array<NamedValue<FrameContent>>({{FrameContent::none, "none"}, {FrameContent::forces, "forces"}});

/// Models to which a setting of a run applies.
enum class SettingScope { all, lattice, mobility, moments, unsteady };

/// Subject of a setting, under which the help of a program lists it.
enum class SettingGroup { model, length, lattice, checkpoints, output };

/// What is known of a setting of a run beside its type and its default: mark of a field of RunSettings.
/// Numbers must lie between `low` and `high`.
struct SettingRow {
  Setting setting{};  ///< its name
  SettingGroup group = SettingGroup::lattice;
  SettingScope scope = SettingScope::all;
  std::string_view value = "";  ///< stands for the value in the help, such as N
  /// What the setting is, without full stop, and its unit in brackets at the end.
  std::string_view help = "";
  std::string_view unset = "";  ///< what a run uses if the setting has no value
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool allows_low = false;             ///< a number with decimals: `low` itself is allowed
  std::string_view too_low = "";       ///< why a number must be above `low`; empty: needs no reason
  std::string_view word_of_none = "";  ///< word for a setting without value
  std::string_view word_of_zero = "";  ///< word for 0
  bool changes_results = true;   ///< its value must stay the same when a run continues from a checkpoint
  bool is_always_named = false;  ///< a command that describes a run names it even if it has its default
};

/// Settings that determine the results, the cost and the files of a run of a layout. Their list of fields is
/// the table of all settings: flags, help, commands, checkpoints and messages follow from it.
struct RunSettings {
  RunModel model = RunModel::lbm;
  LatticeSettings lattice;    ///< used by the model lbm
  MobilitySettings mobility;  ///< used by mobility models
  double cycles = 6;          ///< length of the run [base period]
  int frames_per_cycle = 40;  ///< frames of the trajectory per base cycle
  FrameContent frames_with = FrameContent::none;
  std::optional<double> checkpoint_every;  ///< checkpoint interval [base period]; nullopt: only at early stop
  std::optional<double> flow_every;        ///< interval of flow fields [base period]; nullopt: none
  std::optional<int> flow_mean;            ///< cycles of the mean flow; nullopt: none
  std::string flow_frame = "box";          ///< box, swimmer or swimmer:ID
  std::string flow_region;                 ///< X0:X1,Y0:Y1,Z0:Z1; empty: flow_request() chooses
  std::optional<double> flow_spacing;      ///< edge of the cells [length]; nullopt: flow_request() chooses
  std::string flow_points;                 ///< CSV file; empty: a grid

  static void visit_fields(auto&& visit, auto& settings) {
    using Group = SettingGroup;
    using Scope = SettingScope;
    auto& [model, lattice, mobility, cycles, frames_per_cycle, frames_with, checkpoint_every, flow_every,
           flow_mean, flow_frame, flow_region, flow_spacing, flow_points] = settings;
    const auto add = [&](Setting setting, auto& value, SettingRow row) {
      row.setting = setting;
      visit(identifier_of(setting), value, row);
    };
    add(Setting::model, model,
        {.group = Group::model,
         .help = "lbm (lattice), mobilities rpy, rpy+near, multipole, oseen, unsteady, or auto (the "
                 "cheapest run)",
         .is_always_named = true});
    add(Setting::cycles, cycles,
        {.group = Group::length,
         .value = "C",
         .help = "Length of the run, also fractional; the base period is the driving period that all "
                 "swimmers share, otherwise the period of the first swimmer's type [base period]",
         .changes_results = false});
    add(Setting::frames_per_cycle, frames_per_cycle,
        {.group = Group::length,
         .value = "N",
         .help = "Number of evenly spaced frames of the trajectory per base period; also the number "
                 "of samples per driving period to which strokes are fitted",
         .low = 4,
         .high = 1e6});
    add(Setting::sum_tolerance, mobility.tolerance,
        {.group = Group::model,
         .scope = Scope::mobility,
         .value = "E",
         .help = "Largest relative error (root mean square) of the bead velocities that a mobility "
                 "model sums up in a step [1]",
         .low = 1e-12,
         .high = 1e-2});
    add(Setting::multipole_order, mobility.multipole_order,
        {.group = Group::model,
         .scope = Scope::moments,
         .value = "N",
         .help = "Highest moment of the force on each bead, for the models multipole and unsteady: 0 "
                 "(force alone, as rpy), 1 (with stresslets), 2 (with second moments)",
         .high = max_moment_order,
         .is_always_named = true});
    add(Setting::reynolds_stress, mobility.reynolds_stress,
        {.group = Group::model,
         .scope = Scope::unsteady,
         .help = "Add the Reynolds stress of the flow, for the model unsteady"});
    add(Setting::steps_per_cycle, mobility.steps_per_cycle,
        {.group = Group::length,
         .scope = Scope::mobility,
         .value = "N",
         .help = "Number of time steps per shortest driving period, for mobility models; frames "
                 "between steps are extrapolated",
         .unset = "100, raised to a multiple of the frames",
         .low = 20,
         .high = 1e6});
    add(Setting::seed, mobility.seed,
        {.group = Group::model,
         .scope = Scope::mobility,
         .value = "N",
         .help = "Seed of the thermal noise; runs with equal seeds have the same noise",
         .unset = "the layout's, else 1",
         .high = 2147483647,
         .is_always_named = false});
    add(Setting::noise_tolerance, mobility.noise_tolerance,
        {.group = Group::model,
         .scope = Scope::mobility,
         .value = "E",
         .help = "Largest relative error of the thermal noise in a step [1]",
         .low = 1e-10,
         .high = 0.1});
    add(Setting::cells_per_radius, lattice.cells_per_radius,
        {.scope = Scope::lattice,
         .value = "N",
         .help = "Resolution of the lattice: smallest bead radius in cells [cell]",
         .unset = "the layout's, else 4",
         .is_always_named = true});
    add(Setting::relaxation_time, lattice.relaxation_time,
        {.scope = Scope::lattice,
         .value = "TAU",
         .help = "Relaxation time tau, adjusted to whole steps per period; the time step follows from "
                 "the viscosity nu = (tau - 1/2)/3 cell^2/step [step]",
         .unset = "the layout's, else 1",
         .low = 0.5,
         .too_low = "the viscosity (tau - 1/2)/3 would not be positive; values from 0.6 to 1.5 work well",
         .is_always_named = true});
    add(Setting::precision, lattice.precision,
        {.scope = Scope::lattice,
         .help = "Floating-point precision of the fluid populations; single needs half the memory and "
                 "a little over half the time"});
    add(Setting::bead_boundary, lattice.bead_boundary,
        {.scope = Scope::lattice,
         .help = "No-slip condition on beads: staircase (half-way bounce-back), cli (linear "
                 "interpolation), mr (multireflection), psm (partially saturated cells)"});
    add(Setting::refinement, lattice.refinement,
        {.scope = Scope::lattice,
         .value = "off|auto|N",
         .help = "Number of levels of cells below the coarsest, each with cells of half the size, "
                 "around the beads; auto: the cheapest number; off: cells of one size",
         .low = 1,
         .high = max_finer_levels,
         .word_of_none = "auto",
         .word_of_zero = "off"});
    add(Setting::delay_correction, lattice.delay_correction,
        {.scope = Scope::lattice,
         .help = "Increase the bead density to compensate the delay with which the lattice fluid "
                 "exerts its force on a bead"});
    add(Setting::radius_correction, lattice.radius_correction,
        {.scope = Scope::lattice,
         .help = "Adjust the bead radius on the lattice so that the drag, averaged over positions "
                 "within a cell, is that of a sphere with the layout's radius"});
    add(Setting::lubrication, lattice.lubrication,
        {.scope = Scope::lattice,
         .help = "Add the part of the lubrication force between close surfaces that the lattice does "
                 "not resolve"});
    add(Setting::friction, lattice.friction,
        {.scope = Scope::lattice,
         .value = "MU",
         .help = "Coefficient of Coulomb friction between beads in contact [1]",
         .allows_low = true});
    add(Setting::checkpoint_every, checkpoint_every,
        {.group = Group::checkpoints,
         .value = "C",
         .help = "Interval between checkpoints, which are written alternately to FILE.h5md.ckpt.0 and "
                 "FILE.h5md.ckpt.1 [base period]",
         .unset = "only at a stop by time or signal",
         .changes_results = false});
    add(Setting::frames_with, frames_with,
        {.group = Group::output,
         .help = "What frames have beside positions and velocities: none, or forces (of the fluid on each "
                 "bead, and of the drives)"});
    add(Setting::flow_every, flow_every,
        {.group = Group::output,
         .value = "C",
         .help =
             "Interval between flow fields (velocity, beads, pressure on the lattice) for ParaView, which "
             "FILE.h5md.flow.pvd lists [base period]",
         .unset = "none",
         .changes_results = false});
    add(Setting::flow_mean, flow_mean,
        {.group = Group::output,
         .value = "C",
         .help = "Instead write the mean flow of the last C cycles of the run",
         .unset = "none",
         .low = 1,
         .high = 1e6,
         .changes_results = false});
    add(Setting::flow_frame, flow_frame,
        {.group = Group::output,
         .value = "box|swimmer[:ID]",
         .help = "Frame of the places and of the components of the flow: the box, or a swimmer, with which "
                 "the places move and turn; velocities stay those in the box",
         .changes_results = false});
    add(Setting::flow_region, flow_region,
        {.group = Group::output,
         .value = "X0:X1,Y0:Y1,Z0:Z1",
         .help = "Region of the flow, in which all cells lie; equal ends give one layer [length]",
         .unset = "the box, or three swimmer lengths around all swimmers",
         .changes_results = false});
    add(Setting::flow_spacing, flow_spacing,
        {.group = Group::output,
         .value = "H",
         .help = "Edge of the cells of the flow [length]",
         .unset = "that of the lattice, or the smallest radius",
         .changes_results = false});
    add(Setting::flow_points, flow_points,
        {.group = Group::output,
         .value = "FILE.csv",
         .help = "Instead write the flow at points, the columns x,y,z of this file, to FILE.h5md.flow.csv",
         .unset = "none",
         .changes_results = false});
  }
};

/// Returns whether a setting has an effect in runs with the model, which is not automatic.
bool applies(const SettingRow& row, RunModel model);

/// Throws InputError if a setting that has been chosen has no effect in runs with the model.
void require_settings_apply(const std::set<Setting>& chosen, RunModel model);

/// Throws InputError if the value of a setting is outside its range.
void require_ranges(const RunSettings& settings);

/// A setting with different values in two runs.
struct SettingDifference {
  Setting setting;
  std::string wanted, present;  ///< values as text
};

/// Returns the first setting for which must_be_equal(row) is true and whose values are different; nullopt if
/// there is none. A setting without a value in `wanted` counts as equal.
std::optional<SettingDifference> find_difference(const RunSettings& wanted, const RunSettings& present,
                                                 const std::function<bool(const SettingRow&)>& must_be_equal);

/// Returns the settings that tell a run from others with the model, each with its value, as a command line:
/// the resolution, settings of the model with other values than by default, and those that have been chosen.
std::string settings_text(const RunSettings& settings, const std::set<Setting>& chosen);

/// Returns the value of a setting as text, as a flag takes it; empty if it has none.
template <class T>
std::string setting_text(const SettingRow& row, const T& value) {
  if constexpr (NamedEnum<T>) {
    return to_text(value);
  } else if constexpr (std::same_as<T, bool>) {
    return value ? "on" : "off";
  } else if constexpr (is_optional<T>) {
    return value ? setting_text(row, *value) : std::string(row.word_of_none);
  } else if constexpr (std::same_as<T, std::string>) {
    return value;
  } else {
    return value == 0 && !row.word_of_zero.empty() ? std::string(row.word_of_zero) : fmt::format("{}", value);
  }
}

}  // namespace beadswim
