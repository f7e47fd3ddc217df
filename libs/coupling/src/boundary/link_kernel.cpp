// This file is compiled once per instruction set; BEADSWIM_INSTRUCTION_SET is the namespace. It must not emit
// functions outside this namespace (reason: lattice/src/row_kernels.cpp).
#include "link_kernel.hpp"

#include "beadswim/core/order_free_terms.hpp"
#include "beadswim/coupling/interpolated_bounce_back.hpp"
#include "beadswim/coupling/moving_bounce_back.hpp"
#include "beadswim/coupling/multireflection.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

template <BeadScheme scheme, class Real>
bool reflect(LinkBatch& batch, const LinkBead& bead, LinkSums& sums) {
  const LinkBead b = bead;
  const int places = (batch.links + LinkSums::lanes - 1) / LinkSums::lanes * LinkSums::lanes;
#pragma GCC ivdep
  for (int k = 0; k < places; ++k) {
    const double c[3] = {-batch.cx[k], -batch.cy[k], -batch.cz[k]};
    const double r[3] = {batch.x[k], batch.y[k], batch.z[k]};
    const double w = batch.weight[k], outgoing = batch.outgoing[k];
    const double approach = speed_along(c, b.velocity, b.angular_velocity, r);
    double bounced_back;
    if constexpr (scheme == BeadScheme::staircase) {
      bounced_back = bounced(w, outgoing, approach);
    } else {
      const double q = wall_distance(c, r, b.radius * b.radius);
      const double k_of_link = batch.fluid_behind[k] > 0 ? interpolation_weight(q) : 0;
      bounced_back =
          bounced_interpolated(w, k_of_link, outgoing, batch.behind[k], batch.arrived[k], approach);
      if constexpr (scheme == BeadScheme::mr) {
        const MultireflectionLink f{.outgoing = outgoing,
                                    .arrived = batch.arrived[k],
                                    .behind = batch.behind[k],
                                    .arrived_behind = batch.arrived_behind[k],
                                    .two_behind = batch.two_behind[k],
                                    .speed = batch.speed[k]};
        const double reflected = bounced_multireflection(w, q, b.slip, f, approach);
        bounced_back = batch.fluid_behind[k] > 1 ? reflected : bounced_back;
      }
    }
    const double returned = static_cast<double>(static_cast<Real>(bounced_back + w * b.mass_source));
    batch.returned[k] = returned;
    const double sum = outgoing + returned;
    const double p[3] = {c[0] * sum, c[1] * sum, c[2] * sum};
    batch.terms[0][k] = p[0];  // impulse
    batch.terms[1][k] = p[1];
    batch.terms[2][k] = p[2];
    batch.terms[3][k] = r[1] * p[2] - r[2] * p[1];  // angular impulse
    batch.terms[4][k] = r[2] * p[0] - r[0] * p[2];
    batch.terms[5][k] = r[0] * p[1] - r[1] * p[0];
    batch.terms[6][k] = outgoing - returned;  // fluid mass that the bead takes up
    batch.terms[7][k] = w;
  }
  return order_free::add_terms(batch.terms, places, sums);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

/// In the order of BeadScheme.
const LinkKernels LinkKernels::BEADSWIM_INSTRUCTION_SET{{
    {BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::staircase, double>,
     BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::staircase, float>},
    {BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::cli, double>,
     BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::cli, float>},
    {BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::mr, double>,
     BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::mr, float>},
}};

}  // namespace beadswim
