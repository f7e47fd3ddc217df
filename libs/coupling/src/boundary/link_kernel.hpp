#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/link_sums.hpp"

// The arithmetic of many links of one bead side by side. link_kernel.cpp is compiled once for each
// instruction set; link_kernels() chooses at run time.

namespace beadswim {

/// Links of one bead. Places after the last one, up to whole lanes, have direction (1, 0, 0) and zeros.
struct LinkBatch {
  static constexpr int most = 64;

  int links = 0;
  double x[most], y[most], z[most];     ///< centre of the covered cell relative to the bead's
  double cx[most], cy[most], cz[most];  ///< direction from the covered cell into the fluid
  double weight[most];                  ///< of the direction
  double outgoing[most];                ///< what the fluid sends
  double fluid_behind[most];  ///< fluid cells behind the link's; for cli and mr, which do with what there is
  double behind[most];        ///< what the fluid cell behind sends along the same direction; for cli and mr
  double arrived[most];       ///< what the fluid cell sends the other way; for cli and mr
  double two_behind[most];    ///< what the second fluid cell behind sends along the same direction; for mr
  double arrived_behind[most];     ///< what the fluid cell behind sends the other way; for mr
  double speed[most];              ///< momentum of the fluid cell along the link, into the bead; for mr
  double returned[most];           ///< result: what comes back, rounded to the precision of the populations
  double terms[link_terms][most];  ///< result: what each link hands to the bead
};

struct LinkBead {
  double velocity[3], angular_velocity[3];
  double mass_source;  ///< fluid mass that each link returns, over its weight
  double radius;
  double slip;  ///< of the fluid's relaxation (multireflection.hpp); for mr
};

/// Reflects what goes out along the links of a batch, and adds what they hand to the bead to its sums. False,
/// and nothing is added, if a term is too large, or not a number.
struct LinkKernels {
  using Reflect = bool(LinkBatch&, const LinkBead&, LinkSums&);
  Reflect* of[3][2];  ///< [scheme with links][is single precision]

  /// Real: the type of the populations.
  template <class Real>
  bool reflect(BeadScheme scheme, LinkBatch& batch, const LinkBead& bead, LinkSums& sums) const {
    return of[static_cast<int>(scheme)][sizeof(Real) == sizeof(float)](batch, bead, sums);
  }
};

#define BEADSWIM_DECLARE_LINK_KERNELS(instruction_set)  \
  namespace instruction_set {                           \
  template <BeadScheme scheme, class Real>              \
  bool reflect(LinkBatch&, const LinkBead&, LinkSums&); \
  }

BEADSWIM_DECLARE_LINK_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_LINK_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_LINK_KERNELS(x86_64_v4)
#endif

/// Those of one instruction set, in the order of BeadScheme.
#define BEADSWIM_LINK_KERNELS_OF(set, scheme) \
  { set::reflect<BeadScheme::scheme, double>, set::reflect<BeadScheme::scheme, float> }
#define BEADSWIM_LINK_KERNELS(set)                                                            \
  (LinkKernels{{BEADSWIM_LINK_KERNELS_OF(set, staircase), BEADSWIM_LINK_KERNELS_OF(set, cli), \
                BEADSWIM_LINK_KERNELS_OF(set, mr)}})

/// The best that this processor can run.
const LinkKernels& link_kernels();

}  // namespace beadswim
