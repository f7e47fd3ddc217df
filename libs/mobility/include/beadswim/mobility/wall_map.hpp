#pragma once

#include "beadswim/mobility/line_map_table.hpp"

// Map S_w of the force on a sphere over a plane no-slip wall. It makes the Rotne-Prager mobility of the
// sphere exact across the wall: S_w multiplies the component of the force across the wall by s, and S_w^T the
// component of the velocity,
//
//   s = sqrt(1/(D m))
//
//   D  exact drag of a sphere that moves towards the wall, divided by the drag far from the wall
//   m  Rotne-Prager mobility across the wall, divided by the mobility far from the wall
//
// Heights are those of the centre of the sphere over the wall [radius]. Page: docs/method/near-field.md.

namespace beadswim {

/// Returns D at a height above 1. Brenner, Chem. Eng. Sci. 16 (1961) 242.
double drag_towards_wall(double height);

/// Returns m at a height of 1 or more. Swan & Brady, Phys. Fluids 19 (2007) 113306.
double rotne_prager_towards_wall(double height);

/// Table of log s by the height, with interpolation errors below 1e-7. Below the height of 1.0001, log s is
/// constant; above 64, where it is -2e-8, it is 0.
class WallMapTable {
 public:
  WallMapTable();

  double log_map(double height) const;

 private:
  LazyTable<1, 1> table_;
};

}  // namespace beadswim
