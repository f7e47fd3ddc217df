#pragma once

#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Vectorised evaluation of many cells of one bead. saturated_kernel.cpp is compiled once per instruction
// set.

namespace beadswim {

/// Consecutive cells of a row that exactly one bead touches.
template <class Real>
struct SaturatedBatch {
  static constexpr int max_cells = 64;

  int cells = 0;
  Real* places[d3q19::directions];   ///< addresses of the incoming populations of the first cell
  double solid_fraction[max_cells];  ///< fraction that the bead fills; zero in unused entries
  double x[max_cells];               ///< x of the centre of each cell, relative to the centre of the bead
  double y, z;                       ///< y and z of the centres, the same for all cells
  double terms[saturated_terms][max_cells];  ///< result: contributions of each cell to the bead
};

/// Data of a bead that the kernel needs, in lattice units.
struct SaturatedBead {
  double velocity[3], angular_velocity[3];
  double viscosity;  ///< kinematic viscosity of the fluid [cell^2/step]
};

/// Kernels of one instruction set. A kernel applies the force of the bead to the incoming populations of a
/// batch of cells and adds the contributions to the sums of the bead. If a term is too large or non-finite,
/// it adds nothing to the sums and returns false.
struct SaturatedKernels {
  bool (*push_fp64)(SaturatedBatch<double>&, const SaturatedBead&, SaturatedSums&);
  bool (*push_fp32)(SaturatedBatch<float>&, const SaturatedBead&, SaturatedSums&);

  bool push(SaturatedBatch<double>& batch, const SaturatedBead& bead, SaturatedSums& sums) const {
    return push_fp64(batch, bead, sums);
  }
  bool push(SaturatedBatch<float>& batch, const SaturatedBead& bead, SaturatedSums& sums) const {
    return push_fp32(batch, bead, sums);
  }

  static const SaturatedKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel_choice.hpp)
};

}  // namespace beadswim
