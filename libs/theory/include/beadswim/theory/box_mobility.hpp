#pragma once

#include <optional>
#include <string>

#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/question.hpp"

// Rotne-Prager mobility of a swimmer's beads in a box: pairs and their images.
//
//   mu_ij = oseen + (a_i^2 + a_j^2) laplacian,    mu_ii = 1/(6 pi eta a_i) + the same of the bead's own
//   images
//
// A swimmer between walls across its axis feels where it is: then the slopes by position do not sum to zero,
// and a velocity is that of this place. Page: docs/method/boxes.md.

namespace beadswim {

/// The mobility of beads at these places on the line of `flow`, and its slopes.
CollinearMobility rotne_prager_in(const LineFlow& flow, const CollinearSwimmer& swimmer,
                                  const LinePositions& positions);

/// The line of a swimmer in its box.
LineFlow flow_in(const BoxPlace& place, double viscosity);

/// Places of the beads at rest in the box [length].
LinePositions rest_positions(const CollinearSwimmer& swimmer, const BoxPlace& place);

/// Why beads and their images do not fit into the box; none if they do.
std::optional<std::string> image_overlap(const CollinearSwimmer& swimmer, const BoxPlace& place);

}  // namespace beadswim
