#pragma once

#include "beadswim/core/names.hpp"

namespace beadswim {

/// Law by which the velocities of spheres follow from the forces on them (mobility_product.hpp).
enum class MobilityModel {
  oseen,     ///< Oseen tensor of point forces
  rpy,       ///< Rotne-Prager-Yamakawa tensor of spheres
  rpy_near,  ///< rpy with near-field correction; spheres 3k, 3k + 1 and 3k + 2 are one swimmer
};

template <>
inline constexpr auto name_table<MobilityModel> = std::to_array<NamedValue<MobilityModel>>(
    {{MobilityModel::rpy, "rpy"}, {MobilityModel::rpy_near, "rpy+near"}, {MobilityModel::oseen, "oseen"}});

/// Returns true if the interaction depends on the radii.
inline bool has_finite_radii(MobilityModel model) {
  return model != MobilityModel::oseen;
}

}  // namespace beadswim
