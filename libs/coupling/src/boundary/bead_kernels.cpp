// This file is compiled once per instruction set; BEADSWIM_INSTRUCTION_SET is the namespace. It must not emit
// functions outside this namespace (reason: lattice/src/row_kernels.cpp).
#include "bead_kernels.hpp"

#include "beadswim/core/kernel.hpp"
#include "beadswim/core/order_free_lanes.hpp"
#include "beadswim/coupling/link_laws.hpp"
#include "beadswim/coupling/saturated_cell.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

template <BeadScheme scheme, class Real>
bool reflect(LinkBatch& batch, const KernelBead& bead, LinkSums& sums) {
  const KernelBead b = bead;
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

/// Loads one population of each of `cells` cells, cells <= lanes. The other lanes are zero.
template <class Real>
BEADSWIM_KERNEL Lanes load_populations(const Real* from, int cells) {
  Real __attribute__((vector_size(lanes * sizeof(Real)))) stored{};
  if (cells == lanes) {
    __builtin_memcpy(&stored, from, sizeof stored);
  } else {
    for (int k = 0; k < cells; ++k) stored[k] = from[k];
  }
  return __builtin_convertvector(stored, Lanes);
}

/// Stores one population of each of `cells` cells. Returns the stored values, which are rounded to the type
/// Real.
template <class Real>
BEADSWIM_KERNEL Lanes store_populations(Lanes f, int cells, Real* to) {
  Real __attribute__((vector_size(lanes * sizeof(Real)))) stored;
  stored = __builtin_convertvector(f, decltype(stored));
  if (cells == lanes) {
    __builtin_memcpy(to, &stored, sizeof stored);
  } else {
    for (int k = 0; k < cells; ++k) to[k] = stored[k];
  }
  return __builtin_convertvector(stored, Lanes);
}

/// Stores the momentum p and the angular momentum r x p as six terms per cell, for the cells from `first` on.
BEADSWIM_KERNEL void store_terms(double (*terms)[64], int first, const Lanes (&p)[3], const Lanes (&r)[3]) {
  // clang-format off
  const Lanes values[6]{p[0], p[1], p[2],
                        r[1] * p[2] - r[2] * p[1],
                        r[2] * p[0] - r[0] * p[2],
                        r[0] * p[1] - r[1] * p[0]};
  // clang-format on
#pragma GCC unroll 6
  for (int t = 0; t < 6; ++t) __builtin_memcpy(&terms[t][first], &values[t], sizeof values[t]);
}

/// Applies the force of the bead on the fluid in up to `lanes` cells of the batch, beginning with cell
/// `first`.
template <class Real>
BEADSWIM_KERNEL void push_lanes(SaturatedBatch<Real>& batch, const KernelBead& b, int first) {
  const int cells = batch.cells - first < lanes ? batch.cells - first : lanes;
  Lanes f[d3q19::directions], density, u[3], pushed[3];
#pragma GCC unroll 19
  for (int i = 0; i < d3q19::directions; ++i) f[i] = load_populations(batch.places[i] + first, cells);
  moments_of(f, density, u);

  const Lanes fraction = load(&batch.solid_fraction[first]);
  const Lanes rate = forcing_rate(3 * b.viscosity * resistance(fraction));
  const Lanes r[3]{load(&batch.x[first]), Lanes{} + batch.y, Lanes{} + batch.z};
  const auto &v = b.velocity, &omega = b.angular_velocity;
  const Lanes velocity[3]{v[0] + (omega[1] * r[2] - omega[2] * r[1]),
                          v[1] + (omega[2] * r[0] - omega[0] * r[2]),
                          v[2] + (omega[0] * r[1] - omega[1] * r[0])};
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) pushed[a] = u[a] + rate * (velocity[a] - u[a]);

  const Lanes squares = squares_difference(u, pushed);
#pragma GCC unroll 19
  for (int i = 0; i < d3q19::directions; ++i) {
    const Lanes changed = f[i] + equilibrium_change(i, u, pushed, squares);
    f[i] = store_populations(changed, cells, batch.places[i] + first) - f[i];
  }
  Lanes gained[3], given[3], inner[3];
  moments_of(f, density, gained);
#pragma GCC unroll 3
  for (int a = 0; a < 3; ++a) {
    given[a] = -gained[a];
    inner[a] = fraction * (u[a] + gained[a]);
  }
  store_terms(batch.terms, first, given, r);
  store_terms(batch.terms + 6, first, inner, r);
}

template <class Real>
bool push_cells(SaturatedBatch<Real>& batch, const KernelBead& bead, SaturatedSums& sums) {
  for (int first = 0; first < batch.cells; first += lanes) push_lanes(batch, bead, first);
  return order_free::add_terms(batch.terms, batch.cells, sums);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

/// The links are in the order of BeadScheme.
const BeadKernels BeadKernels::BEADSWIM_INSTRUCTION_SET{
    .reflect_by_scheme = {{BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::staircase, double>,
                           BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::staircase, float>},
                          {BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::cli, double>,
                           BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::cli, float>},
                          {BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::mr, double>,
                           BEADSWIM_INSTRUCTION_SET::reflect<BeadScheme::mr, float>}},
    .push_fp64 = BEADSWIM_INSTRUCTION_SET::push_cells,
    .push_fp32 = BEADSWIM_INSTRUCTION_SET::push_cells};

}  // namespace beadswim
