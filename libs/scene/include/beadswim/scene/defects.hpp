#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Defects of an ordered swarm: swimmers removed, added or changed at random. The random numbers of a swimmer
// depend only on the seed and on its id. They do not depend on its place in the list or on other swimmers.
// Layers, domains and added swimmers have separate sequences of random numbers. The random choice of a
// fraction of the swimmers depends on all swimmers of the layout. A caller that applies several defects
// should use a different seed for each.

namespace beadswim {

/// Amount of a defect: a fraction of the swimmers (double, rounded to the nearest number of swimmers) or a
/// number of swimmers (integer).
using ShareOrCount = std::variant<double, std::int64_t>;

/// Draws different swimmers at random. Returns their indices in ascending order. Throws InputError if the
/// layout has fewer swimmers than requested.
std::vector<std::size_t> draw_swimmer_indices(const Layout& layout, const ShareOrCount& share_or_count,
                                              std::uint64_t seed);

/// Removes random swimmers. The remaining swimmers keep their ids. Throws InputError if none remains.
void add_vacancies(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Adds swimmers, with the type and axis of the first swimmer, at random free positions. The gap between a
/// new bead and all other surfaces is at least a tenth of the smallest radius. New ids follow the largest id.
/// Throws InputError if there is no box, or if no free position is found after many trials.
void add_interstitials(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Displaces each chosen swimmer. Adds to each coordinate a normally distributed random number with mean 0
/// and standard deviation `sigma` [length].
void jitter(Layout& layout, const std::vector<std::size_t>& chosen, double sigma, std::uint64_t seed);

/// Rotates each chosen swimmer about its middle bead. The angle is a normally distributed random number with
/// mean 0 and standard deviation `sigma` [rad], and the rotation axis is a random line perpendicular to the
/// swimmer. Without `sigma`, the new orientation is isotropically random.
void rotate(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
            std::uint64_t seed);

/// Draws `domains` random points in the box. Each point defines a domain: the region in which this point, or
/// one of its periodic images, is the nearest. All swimmers of a domain get the same random axis. Throws
/// InputError if there is no box.
void add_domains(Layout& layout, std::int64_t domains, std::uint64_t seed);

/// Change the driving of each chosen swimmer by a random number x with normal distribution, mean 0 and
/// variance 1.
///   disorder_phases       adds sigma x [rad] to the phase offset; without `sigma`, a uniformly random angle
///   disorder_amplitudes   multiplies both driving amplitudes by 1 + sigma x
///   disorder_frequencies  multiplies the driving frequency by 1 + sigma x
/// Throw InputError if the factor 1 + sigma x is not positive.
void disorder_phases(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
                     std::uint64_t seed);
void disorder_amplitudes(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                         std::uint64_t seed);
void disorder_frequencies(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                          std::uint64_t seed);

/// Parameters of random changes of the distances between layers. A layer consists of the swimmers whose
/// middle beads have the same coordinate along `axis`.
struct LayerSpacing {
  int axis = 0;      ///< 0, 1 or 2 for x, y or z
  double sigma = 0;  ///< standard deviation of the change of a gap between two layers [length]
  double whole = 0;  ///< changes are rounded to multiples of this length; 0: not rounded [length]
};

/// Draws gaps between neighbouring layers at random, and changes each of them by a normally distributed
/// length. All layers beyond a changed gap are displaced by the same length, and the box grows by the sum of
/// all changes. In a periodic box, the gap between the last layer and the periodic image of the first layer
/// can also be drawn. Throws InputError if a change would close a gap or reverse the order of two layers.
void space_layers(Layout& layout, const LayerSpacing& spacing, const ShareOrCount& share_or_count,
                  std::uint64_t seed);

/// Separates swimmers that overlap each other or walls, until all gaps are at least a twentieth of the
/// smallest radius. Swimmers are displaced along the line between the centres of the overlapping beads,
/// without rotation. Throws InputError if gaps are still smaller after 1000 iterations.
void repair_overlaps(Layout& layout);

}  // namespace beadswim
