#pragma once

#include "beadswim/coupling/saturated_sums.hpp"
#include "beadswim/lattice/d3q19.hpp"

// The arithmetic of many cells of one bead side by side. saturated_kernel.cpp is compiled once for each
// instruction set; saturated_kernels() chooses at run time.

namespace beadswim {

/// Cells of a row that one bead and no other touches, one after the other.
template <class Real>
struct SaturatedBatch {
  static constexpr int most = 64;

  int cells = 0;
  Real* places[d3q19::directions];      ///< incoming populations of the first cell
  double solid_fraction[most];          ///< zeros after the last cell, up to whole lanes
  double x[most];                       ///< centre of the cell relative to the bead's, likewise
  double y, z;                          ///< of all cells
  double terms[saturated_terms][most];  ///< result: what each cell hands to the bead
};

struct SaturatedBead {
  double velocity[3], angular_velocity[3];
  double viscosity;  ///< of the fluid [cell^2/step]
};

/// Pushes what streams into the cells of a batch, and adds what they hand to the bead to its sums. False, and
/// nothing is added, if a term is too large, or not a number.
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

/// The best that this processor can run.
const SaturatedKernels& saturated_kernels();

}  // namespace beadswim
