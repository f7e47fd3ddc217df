#pragma once

#include "beadswim/core/names.hpp"

namespace beadswim {

/// How the velocities of spheres follow from the forces on them (mobility_product.hpp).
enum class MobilityModel {
  oseen,     ///< point forces
  rpy,       ///< Rotne and Prager's tensor of spheres
  rpy_near,  ///< rpy, and exact along the line of near spheres; spheres 3k, 3k + 1, 3k + 2 are one swimmer
};

template <>
inline constexpr auto name_table<MobilityModel> = std::to_array<NamedValue<MobilityModel>>(
    {{MobilityModel::rpy, "rpy"}, {MobilityModel::rpy_near, "rpy+near"}, {MobilityModel::oseen, "oseen"}});

/// Whether spheres have a size to others.
inline bool are_spheres(MobilityModel model) {
  return model != MobilityModel::oseen;
}

}  // namespace beadswim
