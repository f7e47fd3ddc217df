#pragma once

#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Vectorised evaluation of many cells of one bead. saturated_kernel.cpp is compiled once per instruction set;
// saturated_kernels() selects the instruction set at run time.

namespace beadswim {

/// Consecutive cells of a row that exactly one bead touches.
template <class Real>
struct SaturatedBatch {
  static constexpr int max_cells = 64;

  int cells = 0;
  Real* places[d3q19::directions];           ///< addresses of the incoming populations of the first cell
  double solid_fraction[max_cells];          ///< zero after the last cell, up to the end of its vector
  double x[max_cells];                       ///< centre of the cell relative to the centre of the bead
  double y, z;                               ///< the same for all cells
  double terms[saturated_terms][max_cells];  ///< result: contributions of each cell to the bead
};

/// Data of a bead that the kernel needs, in lattice units.
struct SaturatedBead {
  double velocity[3], angular_velocity[3];
  double viscosity;  ///< kinematic, of the fluid [cell^2/step]
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
};

#define BEADSWIM_DECLARE_SATURATED_KERNELS(instruction_set)                     \
  namespace instruction_set {                                                   \
  template <class Real>                                                         \
  bool push_cells(SaturatedBatch<Real>&, const SaturatedBead&, SaturatedSums&); \
  }

BEADSWIM_DECLARE_SATURATED_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_SATURATED_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_SATURATED_KERNELS(x86_64_v4)
#endif

/// Returns the kernels of the best instruction set that this processor supports.
const SaturatedKernels& saturated_kernels();

}  // namespace beadswim
