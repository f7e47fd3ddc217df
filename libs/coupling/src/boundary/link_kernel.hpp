#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/link_sums.hpp"

// Vectorised evaluation of many links of one bead. link_kernel.cpp is compiled once per instruction set.

namespace beadswim {

/// Links of one image of a bead, one array entry per link. x is the fluid cell of a link and c the direction
/// from x to the covered cell. f(x) is the outgoing population of x along c, and g(x) the outgoing population
/// along -c. Unused entries of the last vector have direction (1, 0, 0) and are otherwise zero.
struct LinkBatch {
  static constexpr int max_links = 64;

  int links = 0;
  double x[max_links], y[max_links], z[max_links];     ///< vector from the bead centre to the covered cell
  double cx[max_links], cy[max_links], cz[max_links];  ///< -c
  double weight[max_links];                            ///< weight of the direction
  double outgoing[max_links];                          ///< f(x)
  /// BeadLink::fluid_behind. If it is 0, cli and mr use the equation of staircase; if 1, mr uses that of cli.
  double fluid_behind[max_links];
  double behind[max_links];          ///< f(x - c); for cli and mr
  double arrived[max_links];         ///< g(x); for cli and mr
  double two_behind[max_links];      ///< f(x - 2 c); for mr
  double arrived_behind[max_links];  ///< g(x - c); for mr
  double speed[max_links];           ///< c.u(x), where u is the momentum; for mr
  double returned[max_links];  ///< result: reflected population, rounded to the precision of the populations
  double terms[link_terms][max_links];  ///< result: contributions of each link to the bead
};

/// Data of a bead that the link kernel needs, in lattice units.
struct LinkBead {
  double velocity[3], angular_velocity[3];
  double mass_source;  ///< returned mass: fluid mass that each link returns, divided by its weight
  double radius;       ///< [cell]
  double slip;         ///< multireflection_slip() of the relaxation rates; for mr
};

/// Link kernels of one instruction set. A kernel reflects the populations that leave fluid cells along the
/// links of a batch, and adds the contributions of the links to the sums of the bead. If a term is too large
/// or non-finite, it adds nothing to the sums and returns false.
struct LinkKernels {
  using Reflect = bool(LinkBatch&, const LinkBead&, LinkSums&);
  Reflect* reflect_by_scheme[3][2];  ///< [scheme with links][is single precision]

  /// Real: the type of the populations.
  template <class Real>
  bool reflect(BeadScheme scheme, LinkBatch& batch, const LinkBead& bead, LinkSums& sums) const {
    return reflect_by_scheme[static_cast<int>(scheme)][sizeof(Real) == sizeof(float)](batch, bead, sums);
  }

  static const LinkKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel_choice.hpp)
};

}  // namespace beadswim
