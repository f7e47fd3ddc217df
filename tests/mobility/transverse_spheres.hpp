#pragma once

#include <array>
#include <cmath>
#include <cstddef>

// Exact results for two spheres that move perpendicularly to their line of centres in Stokes flow, by Lamb's
// solution around both spheres. tests/mobility/two_spheres.py prints these numbers in two minutes and defines
// their signs. Bispherical harmonics (Dean & O'Neill 1963), with the traction integrated over the surfaces,
// give the same digits.

namespace beadswim {

struct TransverseResistance {
  double gap;             ///< xi: gap divided by the radius a
  double sliding_torque;  ///< centres fixed, equal rotation w: torque / (8 pi eta a^3 w)
  double sliding_force;   ///< equal rotation w: force on sphere 1 / (6 pi eta a^2 w)
  double rolling_torque;  ///< opposite rotation w: torque / (8 pi eta a^3 w)
};
inline constexpr std::array transverse_resistances{
    TransverseResistance{0.002, 2.23264894, -1.91375662, 1.66457283},
    TransverseResistance{0.005, 2.00780688, -1.61152704, 1.52969578},
    TransverseResistance{0.01, 1.84061580, -1.38516795, 1.42951364},
    TransverseResistance{0.02, 1.67783306, -1.16234997, 1.33225072},
    TransverseResistance{0.05, 1.47432098, -0.87749292, 1.21179733},
    TransverseResistance{0.1, 1.33476781, -0.67443358, 1.13128805},
    TransverseResistance{0.2, 1.21406795, -0.48840401, 1.06554595},
    TransverseResistance{0.3, 1.15484982, -0.39030966, 1.03633984},
    TransverseResistance{0.5, 1.09445320, -0.28078650, 1.01102241},
    TransverseResistance{1.0, 1.03965038, -0.16142308, 0.99632105},
    TransverseResistance{2.0, 1.01268376, -0.07898913, 0.99576771}};

/// Returns the sliding torque at any xi in the range of the table. The difference from ln(1 + 1/xi)/4 is
/// smooth; it is interpolated in ln xi with an error of 1e-3.
inline double sliding_torque(double xi) {
  const auto smooth = [](const TransverseResistance& r) {
    return r.sliding_torque - 0.25 * std::log1p(1 / r.gap);
  };
  std::size_t n = 1;
  while (n + 1 < transverse_resistances.size() && transverse_resistances[n].gap < xi) ++n;
  const TransverseResistance &below = transverse_resistances[n - 1], &above = transverse_resistances[n];
  const double t = std::log(xi / below.gap) / std::log(above.gap / below.gap);
  return (1 - t) * smooth(below) + t * smooth(above) + 0.25 * std::log1p(1 / xi);
}

/// Results for spheres of radii 1 and 2 with fixed centres and equal angular velocity w, at xi = 2 gap/(a_1 +
/// a_2): torques divided by 8 pi eta a_i^3 w, forces divided by 6 pi eta a_i^2 w.
struct UnequalSliding {
  double gap, torque_1, torque_2, force_1;
};
inline constexpr std::array unequal_sliding{UnequalSliding{0.002, 2.86066142, 1.76826449, -4.27996306},
                                            UnequalSliding{0.005, 2.50391829, 1.63299543, -3.63522897},
                                            UnequalSliding{0.02, 1.98685762, 1.43355313, -2.67651822},
                                            UnequalSliding{0.1, 1.47002940, 1.22239892, -1.62969585}};

}  // namespace beadswim
