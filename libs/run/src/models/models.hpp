#pragma once

#include <memory>

#include "beadswim/run/model.hpp"

namespace beadswim {

// Return descriptions of runs. The communicator must exist as long as they do. Collective.

/// Model lbm: resolved beads in a lattice-Boltzmann fluid (libs/coupling). Throws the errors of
/// put_on_lattice() (scene_on_lattice.hpp), and InputError if the memory of the machine does not suffice.
std::unique_ptr<ModelPlan> lattice_plan(const Layout& layout, const RunSettings& requested,
                                        const std::string& source, const Communicator& communicator);

/// The mobility models (libs/overdamped): beads without inertia. Throws InputError if the layout has no-slip
/// walls, or if its box is too narrow.
std::unique_ptr<ModelPlan> overdamped_plan(const Layout& layout, const RunSettings& requested,
                                           const std::string& source, const Communicator& communicator);

}  // namespace beadswim
