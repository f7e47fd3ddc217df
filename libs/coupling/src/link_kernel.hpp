#pragma once

#include "beadswim/coupling/link_sums.hpp"

// The arithmetic of many links of one bead side by side. link_kernel.cpp is compiled once for each
// instruction set; link_kernels() chooses at run time.

namespace beadswim {

/// Links of one bead.
struct LinkBatch {
  static constexpr int most = 64;

  int links = 0;                        ///< places after them, up to the next whole lanes, hold zeros
  double x[most], y[most], z[most];     ///< centre of the covered cell relative to the bead's
  double cx[most], cy[most], cz[most];  ///< direction from the covered cell into the fluid
  double weight[most];                  ///< of the direction
  double outgoing[most];                ///< what the fluid sends
  double returned[most];           ///< result: what comes back, rounded to the precision of the populations
  double terms[link_terms][most];  ///< result: what each link hands to the bead
};

struct LinkBead {
  double velocity[3], angular_velocity[3];
  double mass_source;  ///< fluid mass that each link returns, over its weight
};

/// Reflects what goes out along the links of a batch, and adds what they hand to the bead to its sums. False,
/// and nothing is added, if a term is too large, or not a number.
struct LinkKernels {
  bool (*reflect_fp64)(LinkBatch&, const LinkBead&, LinkSums&);
  bool (*reflect_fp32)(LinkBatch&, const LinkBead&, LinkSums&);

  /// Real: the type of the populations.
  template <class Real>
  bool reflect(LinkBatch& batch, const LinkBead& bead, LinkSums& sums) const {
    return (sizeof(Real) == sizeof(float) ? reflect_fp32 : reflect_fp64)(batch, bead, sums);
  }
};

#define BEADSWIM_DECLARE_LINK_KERNELS(instruction_set)                       \
  namespace instruction_set {                                                \
  bool reflect_fp64(LinkBatch& batch, const LinkBead& bead, LinkSums& sums); \
  bool reflect_fp32(LinkBatch& batch, const LinkBead& bead, LinkSums& sums); \
  }

BEADSWIM_DECLARE_LINK_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_LINK_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_LINK_KERNELS(x86_64_v4)
#endif

/// The best that this processor can run.
const LinkKernels& link_kernels();

}  // namespace beadswim
