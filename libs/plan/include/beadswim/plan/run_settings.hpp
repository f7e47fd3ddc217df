#pragma once

#include <optional>

#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"

namespace beadswim {

/// What moves the beads: the fluid of a lattice, or a mobility.
enum class RunModel {
  lbm,
  rpy,
  rpy_near,
  oseen,
  automatic,  ///< the cheapest that a plan finds
};

template <>
inline constexpr auto name_table<RunModel> =
    std::to_array<NamedValue<RunModel>>({{RunModel::lbm, "lbm"},
                                         {RunModel::rpy, "rpy"},
                                         {RunModel::rpy_near, "rpy+near"},
                                         {RunModel::oseen, "oseen"},
                                         {RunModel::automatic, "auto"}});

/// A mobility has one name, as a model of runs and by itself.
inline RunModel run_model(MobilityModel model) {
  return from_text<RunModel>(to_text(model));
}
inline std::optional<MobilityModel> mobility_model(RunModel model) {
  return value_named<MobilityModel>(to_text(model));
}

/// The settings that fix the results, the cost and the files of a run of a layout.
struct RunSettings {
  RunModel model = RunModel::lbm;
  LatticeSettings lattice;                 ///< of lbm
  MobilitySettings mobility;               ///< of the other models
  double cycles = 6;                       ///< length of the run [base period]
  int frames_per_cycle = 40;               ///< of the trajectory
  std::optional<double> checkpoint_every;  ///< none: only when the run is stopped [cycle]
  std::optional<double> flow_every;        ///< none: no flow fields [cycle]
};

}  // namespace beadswim
