#pragma once

#include <string>

#include "beadswim/overdamped/overdamped_setup.hpp"

// Mesh and limits of the memory of the fluid (mobility/fluid_memory.hpp). Page: docs/method/fluid-memory.md.

namespace beadswim {

/// Returns the periodic cube that replaces open space: five times as long as the largest extent of the
/// beads at rest. Its images change the velocity of a lone swimmer by some 0.2 %.
Box box_for_open_space(const OverdampedScene& scene);

/// Returns the memory of the layout's fluid. The mesh resolves the smallest bead and the penetration depth.
/// `scene` has box and time step. `source` is the name of the layout in messages. Throws InputError in these
/// cases:
///   - The largest radius is above 1.5 penetration depths of the fastest oscillation.
///   - The largest radius is more than four times the smallest.
///   - A bead is so light that the time steps would be unstable.
///   - Driving forces in open space do not sum to zero.
///   - The mesh would have more than 3e8 points.
FluidMemory fluid_memory(const Layout& layout, const OverdampedScene& scene, bool has_reynolds_stress,
                         const std::string& source);

}  // namespace beadswim
