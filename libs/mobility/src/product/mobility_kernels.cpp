// Compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the instruction set.
#include "mobility_kernels.hpp"

#include "mesh_kernels.hpp"
#include "moment_pair_kernels.hpp"
#include "pair_kernels.hpp"

namespace beadswim {

namespace kernels = BEADSWIM_INSTRUCTION_SET;

const MobilityKernels MobilityKernels::BEADSWIM_INSTRUCTION_SET{
    .find_near_spheres = kernels::find_near_spheres,
    .pair_velocities = kernels::pair_velocities,
    .near_radials = kernels::near_radials,
    .moment_pairs = kernels::moment_pairs,
    .mirror_flow = kernels::mirror_flow,
    .spread = kernels::spread,
    .gather = kernels::gather,
    .multiply_waves = kernels::multiply_waves,
    .multiply_tensors = kernels::multiply_tensors};

}  // namespace beadswim
