#pragma once

#include <optional>
#include <string>

#include "beadswim/run/model.hpp"
#include "beadswim/scene/fault.hpp"

namespace beadswim {

/// Run in which a fault was found.
struct FaultyRun {
  double length = 1;  ///< unit of lengths of the fault [length of the layout]
  long steps_per_cycle = 1;
  std::optional<double> mach;  ///< largest Mach number of a bead; nullopt: mobility model
  std::string cause;           ///< likely cause of an unstable state, with a remedy
  std::string other_model;     ///< further remedy: a model that is more stable; empty if there is none
};

/// Returns status and message of a run that ends with this fault. The message states step, place, fault,
/// likely cause and remedy.
EarlyStop model_fault(const Fault& fault, const FaultyRun& run);

}  // namespace beadswim
