#pragma once

#include <optional>

#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"

namespace beadswim {

/// Model that moves the beads: a lattice-Boltzmann fluid, or a mobility.
enum class RunModel {
  lbm,
  rpy,
  rpy_near,
  oseen,
  automatic,  ///< the cheapest model within the tolerance of a plan
};

template <>
inline constexpr auto name_table<RunModel> =
    std::to_array<NamedValue<RunModel>>({{RunModel::lbm, "lbm"},
                                         {RunModel::rpy, "rpy"},
                                         {RunModel::rpy_near, "rpy+near"},
                                         {RunModel::oseen, "oseen"},
                                         {RunModel::automatic, "auto"}});

// A mobility model has the same name in both enumerations.
inline RunModel run_model(MobilityModel model) {
  return from_text<RunModel>(to_text(model));
}
inline std::optional<MobilityModel> mobility_model(RunModel model) {
  return value_named<MobilityModel>(to_text(model));
}

/// Settings that determine the results, the cost and the files of a run of a layout.
struct RunSettings {
  RunModel model = RunModel::lbm;
  LatticeSettings lattice;                 ///< used by lbm
  MobilitySettings mobility;               ///< used by the other models
  double cycles = 6;                       ///< length of the run [base period]
  int frames_per_cycle = 40;               ///< frames of the trajectory per base cycle
  std::optional<double> checkpoint_every;  ///< nullopt: only if the run is stopped [cycle]
  std::optional<double> flow_every;        ///< nullopt: no flow fields [cycle]
};

}  // namespace beadswim
