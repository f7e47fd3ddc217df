#pragma once

#include <optional>
#include <string>

#include "beadswim/coupling/lattice_settings.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"

namespace beadswim {

/// The settings that fix the results, the cost and the files of a run of a layout.
struct RunSettings {
  std::string model = "lbm";               ///< lbm, rpy, rpy+near or oseen
  LatticeSettings lattice;                 ///< of lbm
  MobilitySettings mobility;               ///< of the other models
  double cycles = 6;                       ///< length of the run [base period]
  int frames_per_cycle = 40;               ///< of the trajectory
  std::optional<double> checkpoint_every;  ///< none: only when the run is stopped [cycle]
  std::optional<double> flow_every;        ///< none: no flow fields [cycle]
};

}  // namespace beadswim
