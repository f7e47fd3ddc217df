#pragma once

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/impulse_sums.hpp"
#include "beadswim/lattice/d3q19.hpp"

// Vectorised evaluation of many links, or of many saturated cells, of one bead. bead_kernels.cpp is compiled
// once per instruction set.

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

/// Data of a bead that the kernels need, in lattice units.
struct KernelBead {
  double velocity[3], angular_velocity[3];
  double mass_source = 0;  ///< returned mass: fluid mass that each link returns, divided by its weight
  double radius = 0;       ///< [cell]
  double slip = 0;         ///< multireflection_slip() of the relaxation rates; for mr
  double viscosity = 0;    ///< kinematic viscosity of the fluid [cell^2/step]; for psm
};

/// Kernels of one instruction set. They add the contributions of a batch to the sums of the bead. If a term
/// is too large or non-finite, they add nothing to the sums and return false.
struct BeadKernels {
  using Reflect = bool(LinkBatch&, const KernelBead&, LinkSums&);
  Reflect* reflect_by_scheme[3][2];  ///< [scheme with links][is single precision]
  bool (*push_fp64)(SaturatedBatch<double>&, const KernelBead&, SaturatedSums&);
  bool (*push_fp32)(SaturatedBatch<float>&, const KernelBead&, SaturatedSums&);

  /// Reflects the populations that leave fluid cells along the links of a batch. Real: their type.
  template <class Real>
  bool reflect(BeadScheme scheme, LinkBatch& batch, const KernelBead& bead, LinkSums& sums) const {
    return reflect_by_scheme[static_cast<int>(scheme)][sizeof(Real) == sizeof(float)](batch, bead, sums);
  }

  /// Applies the force of the bead to the incoming populations of a batch of cells.
  bool push(SaturatedBatch<double>& batch, const KernelBead& bead, SaturatedSums& sums) const {
    return push_fp64(batch, bead, sums);
  }
  bool push(SaturatedBatch<float>& batch, const KernelBead& bead, SaturatedSums& sums) const {
    return push_fp32(batch, bead, sums);
  }

  static const BeadKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
