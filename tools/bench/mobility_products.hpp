#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"

namespace beadswim {

/// Domain of the beads: a periodic cube or open space.
enum class Surroundings { periodic, open };

template <>
inline constexpr auto name_table<Surroundings> = std::to_array<NamedValue<Surroundings>>(
    {{Surroundings::periodic, "periodic"}, {Surroundings::open, "open"}});

/// The mobility products that the command line requests.
struct ProductRequest {
  std::vector<int> beads;    ///< numbers of beads
  double tolerance = 1e-4;   ///< relative error of the velocities
  int multipole_order = 0;   ///< highest moment of the force on each bead (mobility/force_moments.hpp)
  bool is_unsteady = false;  ///< a fluid with inertia in a periodic box (mobility/fluid_memory.hpp)
  bool has_noise = false;    ///< the root of the mobility, too (mobility/mobility_root.hpp)
  int rounds = 9;            ///< repetitions of each product
};

/// Time, error and memory of a mobility product (class Mobility): the evaluation of the velocities of
/// all beads from the forces on them.
struct ProductRow {
  int beads = 0;
  Surroundings surroundings = Surroundings::open;
  int ranks = 1;
  double tolerance = 0;
  int multipole_order = 0;
  int iterations = 0;                    ///< of the moments, in one product
  double seconds = 0, seconds_best = 0;  ///< time per product: median and minimum over the rounds [s]
  /// Only in a fluid with inertia: the part of a product on the mesh, and the end of a step [s].
  std::optional<double> mesh_seconds{}, end_of_step_seconds{};
  std::optional<double> noise_seconds{};  ///< of the thermal noise of a step, median [s]
  /// Relative error of the velocities, measured relative to a product with 1/1000 of the tolerance. Empty if
  /// the product sums all pairs directly, for more than 100,000 beads (5000 with force moments), and for
  /// tolerances below 1e-9.
  std::optional<double> error{};
  std::int64_t memory_bytes = 0;  ///< growth of the resident memory of all ranks [byte]

  BEADSWIM_FIELDS(beads, surroundings, ranks, tolerance, (multipole_order, omitted_if(0)),
                  (iterations, omitted_if(0)), seconds, seconds_best, (mesh_seconds, omitted_if_none),
                  (end_of_step_seconds, omitted_if_none), (noise_seconds, omitted_if_none), error,
                  memory_bytes)
};

/// Times mobility products of beads of radius 6 at random positions, in a periodic box and in open space, on
/// one rank and on all ranks. The volume per bead is 32^3, as in the uniform swarm of the paper (Pickl et al.
/// 2017). The forces on the beads are random and sum to zero. Only rank 0 returns all rows. Collective.
std::vector<ProductRow> measure_products(const ProductRequest& request, const Communicator& world);

}  // namespace beadswim
