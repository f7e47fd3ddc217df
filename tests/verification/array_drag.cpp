#include <fmt/core.h>

#include "array_drag.hpp"

#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the drag coefficient K = F/(6 pi eta R U) of a simple-cubic array of fixed spheres.

namespace beadswim::verification {

/// Returns K. Keeps the momentum of the fluid constant and waits until the body force that this requires is
/// constant.
double array_drag(const CubicArray& array, const Vec3& offset, double tau, BeadScheme scheme) {
  constexpr double speed = 1e-6, settled_to = 1e-5;  // of K
  const Index3 cells = Index3::Constant(array.edge);
  SpheresInFluid fluid(cells, tau, scheme, {{array.radius, Vec3::Constant(array.edge / 2.0) + offset}});
  fluid.start_fluid(Vec3(speed, 0, 0));
  const Vec3 momentum = fluid.fluid_momentum();
  const int interval = settling_interval(cells, tau);
  Settling settling(settled_to);
  while (!settling.settled()) {
    double force = 0, superficial = 0;  // of the last two steps, which may differ by the way of a staircase
    for (int n = 0; n < interval; ++n) {
      fluid.hold_fluid_momentum(momentum);
      fluid.step();
      if (n < interval - 2) continue;
      force += 0.5 * fluid.body_force[0] * fluid.volume();
      superficial += 0.5 * fluid.mid_step_momentum()[0] / fluid.volume();
    }
    settling.add({force / (6 * pi * lattice_viscosity(tau) * array.radius * superficial)});
  }
  return settling.limits()[0];
}

namespace {

void measure(double phi, int cells_per_diameter, int places, double tau, BeadScheme scheme,
             const Emit& emit) {
  const CubicArray array = cubic_array(phi, cells_per_diameter);
  std::vector<double> drags;
  for (const Vec3& place : random_places(places)) drags.push_back(array_drag(array, place, tau, scheme));
  emit(array_record("array-drag", scheme, tau, array, cells_per_diameter, drags, cubic_array_drag(phi)));
}

constexpr std::array fractions{0.027, 0.064, pi / 48, 0.125, 0.216};

}  // namespace

void measure_array_drag(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) {
    for (const int cells : {6, 8, 12}) measure(pi / 48, cells, 4, 1.5, scheme, emit);
    return;
  }
  for (const double phi : fractions) {
    for (const int cells : {4, 6, 8, 12, 16, 24, 32}) {
      const int places = cells <= 16 ? 8 : (cells == 24 ? 4 : 2);
      measure(phi, cells, places, 1.5, scheme, emit);
    }
  }
  for (const double tau : {0.8, 3.0}) {
    for (const int cells : {4, 8, 16}) measure(pi / 48, cells, 8, tau, scheme, emit);
  }
}

Law array_drag_law() {
  Law law{
      .title = "Drag of a cubic array of fixed spheres",
      .claim =
          "Drag coefficient K = F/(6πηRU); F: force on one sphere with its share of the mean pressure "
          "gradient; U: superficial velocity; φ = π/48 unless stated",
      .reference = "Sangani and Acrivos (1982), eq. (60); within 2e-4 of Zick and Homsy (1982)",
      .test = "φ = π/48; 6, 8, 12 cells per diameter",
  };
  for (const int cells : {4, 6, 8, 12, 16, 32}) {
    law.rows.push_back(
        {fmt::format("{} cells", cells), {{"phi", pi / 48}, {"tau", 1.5}, {"cells_per_diameter", cells}}});
  }
  for (const double phi : {0.027, 0.216}) {
    law.rows.push_back(
        {fmt::format("φ = {:g}, 8 cells", phi), {{"phi", phi}, {"tau", 1.5}, {"cells_per_diameter", 8}}});
  }
  for (const double tau : {0.8, 3.0}) {
    law.rows.push_back(
        {fmt::format("τ = {:g}, 8 cells", tau), {{"phi", pi / 48}, {"tau", tau}, {"cells_per_diameter", 8}}});
  }
  return law;
}

}  // namespace beadswim::verification
