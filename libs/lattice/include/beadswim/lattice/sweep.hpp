#pragma once

#include <string>

#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// One step of the fluid in the block: every own cell reads its 19 incoming populations, collides them and
/// puts its outgoing ones in their places; then the populations are advanced. The halo must
/// have been filled. Branch-free: beads and walls have written their links' incoming values before.
///
/// The same bits on every instruction set and for every shape of block.
void stream_and_collide(Populations& populations, const RelaxationRates& rates);

/// The instruction set chosen on this processor: "x86-64-v4", "x86-64-v3" or "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
