#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace beadswim {

/// How the velocities of spheres follow from the forces on them (mobility_product.hpp).
enum class MobilityModel {
  oseen,     ///< point forces
  rpy,       ///< Rotne and Prager's tensor of spheres
  rpy_near,  ///< rpy, and exact along the line of near spheres; spheres 3k, 3k + 1, 3k + 2 are one swimmer
};

/// Names in flags and documents.
inline constexpr std::array<std::pair<MobilityModel, std::string_view>, 3> mobility_model_names{
    {{MobilityModel::rpy, "rpy"}, {MobilityModel::rpy_near, "rpy+near"}, {MobilityModel::oseen, "oseen"}}};

/// Whether spheres have a size to others.
inline bool are_spheres(MobilityModel model) {
  return model != MobilityModel::oseen;
}

}  // namespace beadswim
