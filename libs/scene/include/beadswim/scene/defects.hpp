#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Defects of an ordered swarm: swimmers removed, added or changed at random. The random numbers of a swimmer
// depend only on the seed and on its id, and not on its place in the list or on other swimmers. The selection
// of the swimmers that are changed depends on the ids of all swimmers of the layout. The random numbers of
// domains and of changes of layer distances depend on the seed and on the number of the domain or distance. A
// caller that applies several defects should use a different seed for each, because some defects use the same
// random numbers.

namespace beadswim {

/// Amount of a defect: a fraction of the swimmers (double, rounded to the nearest number of swimmers) or a
/// number of swimmers (integer).
using ShareOrCount = std::variant<double, std::int64_t>;

/// Selects swimmers at random, each at most once. Returns their indices in Layout::swimmers in ascending
/// order. Throws InputError if the layout has fewer swimmers than requested.
std::vector<std::size_t> draw_swimmer_indices(const Layout& layout, const ShareOrCount& share_or_count,
                                              std::uint64_t seed);

/// Removes swimmers that are selected at random. The remaining swimmers keep their ids. Throws InputError if
/// no swimmer would remain.
void add_vacancies(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Adds swimmers at random free positions, with the type and the axis of the first swimmer. The gap between a
/// new bead and all other surfaces is at least a tenth of the smallest bead radius. New ids follow the
/// largest id. Throws InputError if there is no box, or if no free position is found after many trials.
void add_interstitials(Layout& layout, const ShareOrCount& share_or_count, std::uint64_t seed);

/// Displaces each chosen swimmer. Adds to each coordinate a normally distributed random number with mean 0
/// and standard deviation `sigma` [length].
void jitter(Layout& layout, const std::vector<std::size_t>& chosen, double sigma, std::uint64_t seed);

/// Rotates each chosen swimmer about its position (bead 2 of a three-bead swimmer). The angle is a normally
/// distributed random number with mean 0 and standard deviation `sigma` [rad], and the rotation axis is a
/// random line perpendicular to the swimmer. Without `sigma`, the new orientation is isotropically random.
void rotate(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
            std::uint64_t seed);

/// Gives swimmers in the same region of the box the same random axis. The regions (domains) belong to
/// `domains` random points: a swimmer is in the domain of the point that is nearest to it, periodic images of
/// the points included. Throws InputError if there is no box.
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

/// Parameters of random changes of the distances between neighbouring layers. A layer consists of the
/// swimmers whose positions have the same coordinate along `axis`.
struct LayerSpacing {
  int axis = 0;      ///< 0, 1 or 2 for x, y or z
  double sigma = 0;  ///< standard deviation of the change of a layer distance [length]
  double whole = 0;  ///< changes are rounded to multiples of this length; 0: not rounded [length]
};

/// Changes some distances between neighbouring layers. `share_or_count` states how many of these distances
/// are selected at random. Each selected distance changes by a normally distributed random length. All layers
/// beyond a changed distance are displaced by its change, so that the other distances stay unchanged, and the
/// box grows by the sum of all changes. In a periodic box, the distance between the last layer and the
/// periodic image of the first layer can also be selected. Throws InputError if a distance would become zero
/// or negative.
void space_layers(Layout& layout, const LayerSpacing& spacing, const ShareOrCount& share_or_count,
                  std::uint64_t seed);

/// Displaces swimmers until each bead has a gap of at least a twentieth of the smallest bead radius to walls
/// and to beads of other swimmers. Swimmers whose beads are too close are displaced along the line between
/// the centres of these beads, without rotation. Throws InputError if a gap is still smaller after 1000
/// iterations.
void repair_overlaps(Layout& layout);

}  // namespace beadswim
