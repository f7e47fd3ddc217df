#pragma once

#include <string>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/question.hpp"

// Rotne-Prager mobility of the beads of a swimmer in a box, including all periodic and mirror images of the
// beads.
//
//   mu_ij =                      oseen_ij + (a_i^2 + a_j^2) laplacian_ij,   i != j: bead j and its images
//   mu_ii = 1/(6 pi eta a_i)  +  oseen_ii +      2 a_i^2    laplacian_ii,   ii: only the images of bead i
//
//   oseen_ij       flow at bead i per force on bead j (line_flow.hpp)
//   laplacian_ij   1/6 of the Laplacian of this flow
//   a_i, eta       bead radius [length], dynamic viscosity [mass/(length time)]
//
// If walls are perpendicular to the swimmer's axis, the mobility depends on the position of the swimmer. Then
// the sum of the derivatives with respect to the three bead positions is not zero, and a velocity is valid
// only at this position. Page: docs/method/boxes.md.

namespace beadswim {

/// Returns the mobility of beads at `positions` on the swimmer's axis [time/mass], with its derivatives with
/// respect to the positions [time/(mass length)]. `flow`: flow of point forces on this axis. `positions`:
/// coordinates in which `flow` is defined [length].
CollinearMobility rotne_prager_mobility(const LineFlow& flow, const CollinearSwimmer& swimmer,
                                        const LinePositions& positions);

/// Returns the flow of point forces on the axis of a swimmer in a box. `place`: box and position of the
/// swimmer, `viscosity`: dynamic viscosity [mass/(length time)].
LineFlow box_line_flow(const BoxPlace& place, double viscosity);

/// Returns the bead positions at rest, measured along the swimmer's axis from the corner of the box [length].
LinePositions rest_positions(const CollinearSwimmer& swimmer, const BoxPlace& place);

/// Returns the smallest gap at rest of the beads, their images and the walls of a box [length]; negative if
/// they overlap.
double smallest_gap_in_box(const CollinearSwimmer& swimmer, const BoxPlace& place);

}  // namespace beadswim
