#include "beadswim/coupling/bead_corrections.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "beadswim/lattice/trt.hpp"

namespace beadswim {
namespace {

struct Calibration {
  double radius;                 ///< radius as set [cell]
  std::array<double, 4> excess;  ///< hydrodynamic radius minus `radius`, in the order of BeadScheme [cell]
};

/// Measured excess radii, rounded from the case hydrodynamic-radius in docs/results/verification.jsonl, with
/// which a test compares this table. docs/verification.md lists their standard deviations over positions of
/// the bead within a cell.
constexpr std::array calibrations{std::to_array<Calibration>({
    {1.5, {-0.0659, -0.0705, -0.0183, -0.0641}}, {1.75, {-0.0702, -0.0666, -0.0095, -0.0420}},
    {2, {-0.0710, -0.0658, -0.0082, -0.0336}},   {2.25, {-0.0438, -0.0502, -0.0013, -0.0341}},
    {2.5, {-0.0170, -0.0345, 0.0060, -0.0288}},  {2.75, {-0.0089, -0.0288, 0.0088, -0.0164}},
    {3, {-0.0186, -0.0329, 0.0070, -0.0113}},    {3.25, {-0.0093, -0.0275, 0.0087, -0.0143}},
    {3.5, {0.0193, -0.0161, 0.0122, -0.0127}},   {3.75, {0.0193, -0.0147, 0.0122, -0.0031}},
    {4, {0.0010, -0.0209, 0.0096, 0.0015}},      {4.5, {0.0263, -0.0104, 0.0118, -0.0041}},
    {5, {0.0279, -0.0111, 0.0107, 0.0077}},      {5.5, {0.0441, -0.0047, 0.0110, 0.0018}},
    {6, {0.0257, -0.0091, 0.0089, 0.0123}},      {7, {0.0367, -0.0058, 0.0079, 0.0159}},
    {8, {0.0432, -0.0039, 0.0069, 0.0186}},      {10, {0.0531, -0.0011, 0.0054, 0.0218}},
    {12, {0.0607, 0.0002, 0.0038, 0.0239}},
})};

/// Returns the hydrodynamic radius of a bead minus its radius `radius` on the lattice [cell]. The result is
/// interpolated linearly between the radii at which it was measured. Outside the range of these radii it is
/// constant.
double excess_radius(BeadScheme scheme, double radius) {
  const auto scheme_index = static_cast<std::size_t>(scheme);
  const auto above = std::ranges::lower_bound(calibrations, radius, {}, &Calibration::radius);
  if (above == calibrations.begin()) return above->excess[scheme_index];
  const Calibration& below = *(above - 1);
  if (above == calibrations.end()) return below.excess[scheme_index];
  return std::lerp(below.excess[scheme_index], above->excess[scheme_index],
                   (radius - below.radius) / (above->radius - below.radius));
}

}  // namespace

// Solves r + excess(r) = radius by the fixed-point iteration r -> radius - excess(r). It converges because
// |d excess/dr| <= 0.15.
double corrected_radius(BeadScheme scheme, double radius) {
  double corrected = radius;
  for (int n = 0; n < 40; ++n) corrected = radius - excess_radius(scheme, corrected);
  return corrected;
}

double delay_density(const Bead& bead, double relaxation_time) {
  return 4.5 * lattice_viscosity(relaxation_time) * force_delay(relaxation_time) /
         (bead.radius * bead.radius);
}

}  // namespace beadswim
