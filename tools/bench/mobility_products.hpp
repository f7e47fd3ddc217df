#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"

namespace beadswim {

/// What surrounds the beads of a mobility product.
enum class Surroundings { periodic, open };

template <>
inline constexpr auto name_table<Surroundings> = std::to_array<NamedValue<Surroundings>>(
    {{Surroundings::periodic, "periodic"}, {Surroundings::open, "open"}});

struct ProductRequest {
  std::vector<int> beads;
  double tolerance = 1e-4;
  int rounds = 9;
};

/// Velocities of so many beads by forces on them (MobilityProduct).
struct ProductRow {
  int beads = 0;
  Surroundings surroundings = Surroundings::open;
  int ranks = 1;
  double tolerance = 0;
  double seconds = 0, seconds_best = 0;  ///< of a product: median, and fastest round
  std::optional<double> error{};  ///< relative, against a sum a thousand times as accurate; none of many
                                  ///< beads, where all pairs are summed, or of tolerances under 1e-9
  std::int64_t memory_bytes = 0;  ///< that all ranks' programs have grown by with it

  static void visit_fields(auto&& visit, auto& row) {
    visit("beads", row.beads);
    visit("surroundings", row.surroundings);
    visit("ranks", row.ranks);
    visit("tolerance", row.tolerance);
    visit("seconds", row.seconds);
    visit("seconds_best", row.seconds_best);
    visit("error", row.error);
    visit("memory_bytes", row.memory_bytes);
  }
};

/// Beads of radius 6 at random in a cube with 32^3 for each, as many as the paper's uniform swarm has, with
/// random forces of sum zero; in a periodic box and in open space, on one rank and on all. On rank 0.
/// Collective.
std::vector<ProductRow> measure_products(const ProductRequest& request, const Communicator& world);

}  // namespace beadswim
