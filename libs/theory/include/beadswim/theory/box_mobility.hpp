#pragma once

#include <optional>
#include <string>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/question.hpp"

// Rotne-Prager mobility of a swimmer's beads in a box, including all images of the beads.
//
//   mu_ij =                      oseen_ij + (a_i^2 + a_j^2) laplacian_ij,   i != j: bead j and its images
//   mu_ii = 1/(6 pi eta a_i)  +  oseen_ii +      2 a_i^2    laplacian_ii,   ii: images of bead i only
//
//   oseen_ij, laplacian_ij   flow at bead i per force at bead j, and 1/6 of its Laplacian (line_flow.hpp)
//   a_i, eta                 bead radius [length], dynamic viscosity [mass/(length time)]
//
// If walls cross the swimmer's axis, the mobility depends on the position of the swimmer. The derivatives
// with respect to the three bead positions then do not sum to zero, and a velocity is valid for this position
// only. Page: docs/method/boxes.md.

namespace beadswim {

/// Returns the mobility [time/mass] of beads at `positions` [length] on the line of `flow`, with its
/// derivatives with respect to the positions [time/(mass length)].
CollinearMobility rotne_prager_mobility(const LineFlow& flow, const CollinearSwimmer& swimmer,
                                        const LinePositions& positions);

/// Returns the flow of point forces on the swimmer's axis in its box. `viscosity`: dynamic viscosity
/// [mass/(length time)].
LineFlow box_line_flow(const BoxPlace& place, double viscosity);

/// Returns the bead positions at rest, measured along the axis from the corner of the box [length].
LinePositions rest_positions(const CollinearSwimmer& swimmer, const BoxPlace& place);

/// Returns a message if beads at rest overlap with images or reach through walls; nullopt if they do not.
std::optional<std::string> image_overlap(const CollinearSwimmer& swimmer, const BoxPlace& place);

}  // namespace beadswim
