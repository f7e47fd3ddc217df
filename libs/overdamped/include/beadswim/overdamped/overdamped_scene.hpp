#pragma once

#include <optional>
#include <vector>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"

namespace beadswim {

/// Vectors of all beads, three a swimmer, in order of the swimmers.
using Beads = std::vector<Vec3>;

/// A swarm without inertia. Any coherent unit system.
struct OverdampedScene {
  struct Swimmer {
    int id = 0;
    int type = 0;                  ///< index into types
    Vec3 position = Vec3::Zero();  ///< centre of bead 2, unwrapped
    Vec3 axis = Vec3::UnitX();     ///< unit vector from bead 1 to bead 3
  };

  PointModel model = PointModel::rotne_prager;
  double viscosity = 0;    ///< dynamic
  std::optional<Box> box;  ///< none: open space
  std::vector<SwimmerType> types;
  std::vector<Swimmer> swimmers;  ///< in order of their ids
  double step = 0;                ///< [time]
  double tolerance = 1e-4;        ///< of the mobility product; a third of it of the step's solution

  const SwimmerType& type_of(std::size_t swimmer) const { return types[swimmers[swimmer].type]; }
};

/// Radii of all beads.
std::vector<double> radii_of(const OverdampedScene& scene);

/// Where they are at time 0.
Beads rest_places(const OverdampedScene& scene);

}  // namespace beadswim
