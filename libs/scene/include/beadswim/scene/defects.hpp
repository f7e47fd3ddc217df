#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Defects of an ordered swarm: swimmers removed, added or changed at random. The random numbers of a swimmer
// depend only on the seed and on its id. They do not depend on its place in the list or on other swimmers.
// Layers, domains and added swimmers have random numbers of their own. Which swimmers a fraction selects
// depends on all swimmers present. A caller that applies several defects should give each its own seed.

namespace beadswim {

/// Amount of a defect: a fraction of the swimmers (double, rounded to the nearest number of swimmers) or a
/// number of swimmers (integer).
using ShareOrCount = std::variant<double, std::int64_t>;

/// Draws swimmers without replacement. Returns their indices in ascending order. Throws InputError if the
/// layout has fewer swimmers.
std::vector<std::size_t> draw_swimmer_indices(const Layout& layout, const ShareOrCount& share_or_count,
                                              std::uint64_t seed);

/// Removes random swimmers. The remaining swimmers keep their ids. Throws InputError if none remains.
void add_vacancies(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Adds swimmers, with the type and axis of the first swimmer, at random free positions. The gap between a
/// new bead and all other surfaces is at least a tenth of the smallest radius. New ids follow the largest id.
/// Throws InputError if there is no box, or if no free position is found after many trials.
void add_interstitials(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Displaces each chosen swimmer: adds to each coordinate a normal deviate of standard deviation `sigma`
/// [length].
void jitter(Layout& layout, const std::vector<std::size_t>& chosen, double sigma, std::uint64_t seed);

/// Rotates each chosen swimmer about its middle bead. The angle is a normal deviate of standard deviation
/// `sigma` [rad], the rotation axis a random line perpendicular to the swimmer. Without `sigma` the new
/// direction is uniformly random.
void rotate(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
            std::uint64_t seed);

/// Divides the box into domains: the regions nearest to each of `domains` random points, with periodic
/// images. All swimmers of a domain get the same random direction. Throws InputError if there is no box.
void add_domains(Layout& layout, std::int64_t domains, std::uint64_t seed);

/// Change the driving of each chosen swimmer by a normal deviate x. The phase offset increases by sigma x
/// [rad] (without `sigma`: by a uniformly random angle). Both amplitudes, or the frequency, are multiplied by
/// 1 + sigma x. Throw InputError if this factor is not positive.
void disorder_phases(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
                     std::uint64_t seed);
void disorder_amplitudes(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                         std::uint64_t seed);
void disorder_frequencies(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                          std::uint64_t seed);

/// Random changes of the spacing of layers. A layer consists of the swimmers whose middle beads have the same
/// coordinate along `axis`.
struct LayerSpacing {
  int axis = 0;      ///< 0, 1 or 2 for x, y or z
  double sigma = 0;  ///< standard deviation of the change of a gap between two layers [length]
  double whole = 0;  ///< changes are rounded to multiples of this length; 0: not rounded [length]
};

/// Changes randomly drawn gaps between neighbouring layers by normal deviates. All layers beyond a changed
/// gap move with it, and the box grows by the sum of the changes. In a periodic box the gap between the first
/// layer and the image of the last layer is included. Throws InputError if two layers would exchange their
/// order.
void space_layers(Layout& layout, const LayerSpacing& spacing, const ShareOrCount& share_or_count,
                  std::uint64_t seed);

/// Separates swimmers that overlap each other or walls, until all gaps are at least a twentieth of the
/// smallest radius. Swimmers move along the line between the overlapping beads, as rigid bodies without
/// rotation. Throws InputError if this takes too many passes.
void repair_overlaps(Layout& layout);

}  // namespace beadswim
