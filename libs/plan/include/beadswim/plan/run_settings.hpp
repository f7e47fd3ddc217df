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

/// Settings that determine the results, the cost and the files of a run of a layout.
struct RunSettings {
  RunModel model = RunModel::lbm;
  LatticeSettings lattice;                 ///< used by the model lbm
  MobilitySettings mobility;               ///< used by mobility models
  double cycles = 6;                       ///< length of the run [base period]
  int frames_per_cycle = 40;               ///< frames of the trajectory per base cycle
  std::optional<double> checkpoint_every;  ///< checkpoint interval [base period]; nullopt: only at early stop
  std::optional<double> flow_every;        ///< interval of flow fields [base period]; nullopt: no flow fields
};

}  // namespace beadswim
