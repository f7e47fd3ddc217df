#pragma once

#include "beadswim/core/names.hpp"

namespace beadswim {

/// Law that gives the velocities of spheres from the forces on them (mobility.hpp).
enum class MobilityModel {
  oseen,      ///< Oseen tensor of point forces
  rpy,        ///< Rotne-Prager-Yamakawa tensor of spheres
  rpy_near,   ///< rpy, corrected for close spheres and for MobilityScene::lines (near_field.hpp)
  multipole,  ///< moments of the force up to MobilityScene::moment_order (force_moments.hpp); order 0 is rpy
  unsteady,   ///< as multipole, in a fluid with inertia (fluid_memory.hpp)
};

template <>
inline constexpr auto name_table<MobilityModel> =
    std::to_array<NamedValue<MobilityModel>>({{MobilityModel::rpy, "rpy"},
                                              {MobilityModel::rpy_near, "rpy+near"},
                                              {MobilityModel::multipole, "multipole"},
                                              {MobilityModel::unsteady, "unsteady"},
                                              {MobilityModel::oseen, "oseen"}});

/// Returns true if the mobility of two spheres by this model depends on their radii.
inline bool has_finite_radii(MobilityModel model) {
  return model != MobilityModel::oseen;
}

/// Returns true if the model has moments of the forces up to MobilityScene::moment_order.
inline bool has_moment_order(MobilityModel model) {
  return model == MobilityModel::multipole || model == MobilityModel::unsteady;
}

}  // namespace beadswim
