#pragma once

// Map S_w of the force on a sphere over a plane no-slip wall. It makes the mobility of the sphere exact
// across the wall: S_w multiplies the component of the force across the wall by s, and S_w^T the component of
// the velocity,
//
//   s = sqrt(1/(D m))
//
//   D  exact drag of a sphere that moves towards the wall, divided by the drag far from the wall
//   m  mobility of the sphere across the wall before the map, divided by the mobility far from the wall
//
// Heights are those of the centre of the sphere over the wall [radius]. Page: docs/method/near-field.md.

namespace beadswim {

/// Height [radius] below which a sphere is corrected as at this height.
constexpr double min_wall_height = 1.0001;

/// Returns D at a height above 1. Brenner, Chem. Eng. Sci. 16 (1961) 242.
double drag_towards_wall(double height);

/// Returns the Rotne-Prager mobility across the wall, divided by the mobility far from the wall, at a height
/// of 1 or more. Swan & Brady, Phys. Fluids 19 (2007) 113306.
double rotne_prager_towards_wall(double height);

/// Returns log s at a height above 1. Above 64, where log s is -2e-8 for the Rotne-Prager mobility, it is 0.
double log_wall_map(double height, double mobility);

}  // namespace beadswim
