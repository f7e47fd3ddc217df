#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Disorder: what is taken from an ordered swarm, added to it, or changed swimmer by swimmer. A swimmer's
// random numbers depend on the seed and its id alone, not on its place in the list or on others; layers,
// domains and added swimmers have numbers of their own. Which swimmers a share draws depends on who is there.
// Whoever applies several defects gives each its own seed.

namespace beadswim {

/// How many of a swarm: a share, of which the nearest whole number is taken, or a number.
using HowMany = std::variant<double, std::int64_t>;

/// Indices of that many swimmers drawn without replacement, in ascending order. Throws InputError if there
/// are fewer.
std::vector<std::size_t> drawn_swimmers(const Layout& layout, const HowMany& how_many, std::uint64_t seed);

/// Takes swimmers away; those that stay keep their ids. Throws InputError if none stays.
void add_vacancies(Layout& layout, const HowMany& how_many, std::uint64_t seed);

/// Adds swimmers of the first one's type and axis at random places that are free, a tenth of a radius around
/// each bead; their ids follow the largest. Throws InputError if there is no box, or no room after many
/// trials.
void add_interstitials(Layout& layout, const HowMany& how_many, std::uint64_t seed);

/// Moves the chosen by a normal deviate in each coordinate, of standard deviation `sigma` [length].
void jitter(Layout& layout, const std::vector<std::size_t>& chosen, double sigma, std::uint64_t seed);

/// Turns the chosen about their middle bead: by a normal deviate of standard deviation `sigma` [radian] about
/// a random line across the axis; none: to random directions.
void rotate(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
            std::uint64_t seed);

/// Parts the scene by random points, periodic images included, and gives the swimmers nearest to each a
/// random direction of their own. Throws InputError if there is no box.
void add_domains(Layout& layout, std::int64_t domains, std::uint64_t seed);

/// Changes the chosen's driving by normal deviates x: its phase offset by sigma x [radian] (none: to any
/// offset, all alike), its amplitudes by a factor 1 + sigma x, its frequency likewise. Throws InputError if a
/// factor is not positive.
void disorder_phases(Layout& layout, const std::vector<std::size_t>& chosen, std::optional<double> sigma,
                     std::uint64_t seed);
void disorder_amplitudes(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                         std::uint64_t seed);
void disorder_frequencies(Layout& layout, const std::vector<std::size_t>& chosen, double sigma,
                          std::uint64_t seed);

/// Swimmers whose middle beads are at one height form a layer across `axis`. Drawn layers move along it, with
/// all that is beyond, by a normal deviate of standard deviation `sigma` each, rounded to whole multiples of
/// `whole` if that is not 0; the box grows by their sum. In a periodic box there is a gap before the first
/// layer too, to the last one's image. Throws InputError if layers would change places.
struct LayerSpacing {
  int axis = 0;
  double sigma = 0;  ///< [length]
  double whole = 0;  ///< [length]
};
void space_layers(Layout& layout, const LayerSpacing& spacing, const HowMany& how_many, std::uint64_t seed);

/// Moves swimmers that overlap apart along the line between the beads, as rigid bodies without turning, until
/// all beads are a twentieth of the smallest radius apart. Throws InputError if that does not come to an end.
void repair_overlaps(Layout& layout);

}  // namespace beadswim
