#include <fmt/core.h>

#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the torque on a slowly rotating sphere in a cubic array, divided by 8 pi eta R^3 Omega.

namespace beadswim::verification {
namespace {

double torque(const CubicArray& array, const Vec3& offset, double tau, BeadScheme scheme) {
  constexpr double rate = 1e-7, settled_to = 1e-5;
  const Index3 cells = Index3::Constant(array.edge);
  SpheresInFluid fluid(cells, tau, scheme, {{array.radius, Vec3::Constant(array.edge / 2.0) + offset}});
  fluid.motion(0).angular_velocity = Vec3(0, 0, rate);
  const int interval = settling_interval(cells, tau);
  Settling settling(settled_to);
  while (!settling.settled()) {
    for (int n = 0; n < interval - 2; ++n) fluid.step();
    const double before = fluid.step()[0].torque[2];
    settling.add({0.5 * (before + fluid.step()[0].torque[2])});
  }
  return -settling.limits()[0] / (8 * pi * lattice_viscosity(tau) * std::pow(array.radius, 3) * rate);
}

void measure(double phi, int cells_per_diameter, int places, double tau, BeadScheme scheme,
             const Emit& emit) {
  const CubicArray array = cubic_array(phi, cells_per_diameter);
  std::vector<double> torques;
  for (const Vec3& place : random_places(places)) torques.push_back(torque(array, place, tau, scheme));
  emit(array_record("torque", scheme, tau, array, cells_per_diameter, torques, array_torque(phi)));
}

}  // namespace

void measure_torque(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) {
    for (const int cells : {6, 8, 12}) measure(0.027, cells, 2, 1.5, scheme, emit);
    return;
  }
  for (const int cells : {4, 6, 8, 12, 16, 24}) measure(0.027, cells, cells <= 16 ? 8 : 4, 1.5, scheme, emit);
  for (const double tau : {0.8, 3.0}) measure(0.027, 8, 8, tau, scheme, emit);
}

Law torque_law() {
  Law law{
      .title = "Torque on a rotating sphere",
      .claim = "Torque/(8πηR³Ω) on one sphere of a cubic array, φ = 0.027",
      .reference = "1/(1 - φ), exact to 6e-6",
      .test = "6, 8, 12 cells per diameter",
  };
  for (const int cells : {4, 6, 8, 12, 24}) {
    law.rows.push_back({fmt::format("{} cells", cells), {{"tau", 1.5}, {"cells_per_diameter", cells}}});
  }
  return law;
}

}  // namespace beadswim::verification
