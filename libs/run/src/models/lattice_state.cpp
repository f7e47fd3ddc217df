#include "models/lattice_model.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/swimmer_state.hpp"

namespace beadswim {
namespace {

constexpr const char* swimmers_section = "swimmers";

/// Returns the part of a level that this rank owns. `finer_levels`: number of finer levels.
LatticePart part_of(const Level& level, int finer_levels) {
  return {.cells = level.place.lattice.size,
          .offset = level.block.offset - level.place.lattice.offset,
          .size = level.block.size,
          .lattice = finer_levels};
}

/// Writes the populations of this rank to a checkpoint, in the floating-point precision of the run.
template <class Real>
void add_populations(CheckpointWriter& file, const Populations& populations, const LatticePart& part) {
  file.add_lattice<Real>(part, d3q19::directions, [&](int i, std::span<Real> numbers) {
    auto next = numbers.begin();
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      *next++ = static_cast<Real>(populations.outgoing(i, cell));
    });
  });
}

template <class Real>
void read_populations(const CheckpointReader& file, Populations& populations, const LatticePart& part) {
  file.read_lattice<Real>(part, d3q19::directions, [&](int i, std::span<const Real> numbers) {
    auto next = numbers.begin();
    for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
      populations.set_outgoing(i, cell, static_cast<double>(*next++));
    });
  });
}

/// Upper bound of a valid bead coordinate [cell].
constexpr double max_coordinate = 1e9;

bool is_sound(const SwimmerSnapshot& snapshot, const PlacedSwimmer& of_scene, std::size_t beads) {
  const SwimmerState& swimmer = snapshot.state;
  bool has_all_beads = snapshot.pending_impulses.size() == beads;
  SwimmerState::visit_bead_fields(
      [&](const char*, const auto& list) { has_all_beads &= list.size() == beads; }, swimmer);
  return has_all_beads && swimmer.id == of_scene.id && swimmer.type == of_scene.type &&
         std::ranges::all_of(swimmer.motion, [](const BeadMotion& bead) {
           return (bead.position.array().abs() < max_coordinate).all() && bead.velocity.allFinite() &&
                  bead.angular_velocity.allFinite();
         });
}

[[noreturn]] void throw_other_swimmers(const CheckpointReader& file) {
  throw DataError(file.path(), "the checkpoint contains other swimmers than the layout");
}

/// Reads the swimmers of a checkpoint in chunks and returns those swimmers that this rank owns. Throws
/// DataError if the checkpoint contains the swimmers of another scene.
std::vector<SwimmerSnapshot> owned_swimmers(const CheckpointReader& file, const CoupledSystem& system) {
  const CoupledScene& scene = system.scene();
  const auto size_of = [&](const PlacedSwimmer& swimmer) {
    return snapshot_size(scene.type_of(swimmer).beads.size());
  };
  std::uint64_t total_bytes = 0;
  for (const PlacedSwimmer& swimmer : scene.swimmers) total_bytes += size_of(swimmer);
  if (total_bytes != file.size(swimmers_section)) throw_other_swimmers(file);
  constexpr std::size_t swimmers_per_chunk = 4096;
  std::vector<SwimmerSnapshot> owned;
  std::uint64_t first_byte = 0;
  for (std::size_t first = 0; first < scene.swimmers.size(); first += swimmers_per_chunk) {
    const auto of_scene =
        std::span(scene.swimmers).subspan(first, std::min(swimmers_per_chunk, scene.swimmers.size() - first));
    std::uint64_t bytes = 0;
    for (const PlacedSwimmer& swimmer : of_scene) bytes += size_of(swimmer);
    auto chunk = states_from_bytes<SwimmerSnapshot>(file.bytes(swimmers_section, first_byte, bytes));
    first_byte += bytes;
    const auto is_of_scene = [&](const SwimmerSnapshot& swimmer, const PlacedSwimmer& placed) {
      return is_sound(swimmer, placed, scene.type_of(placed).beads.size());
    };
    if (!std::ranges::equal(chunk, of_scene, is_of_scene)) throw_other_swimmers(file);
    for (SwimmerSnapshot& swimmer : chunk)
      if (system.owns(swimmer.state)) owned.push_back(std::move(swimmer));
  }
  return owned;
}

}  // namespace

void write_lattice_state(CheckpointWriter& file, CoupledSystem& system) {
  file.add(swimmers_section, bytes_of(system.gather_snapshots()));
  const Levels& levels = system.levels();
  for (int n = 0; n < levels.count(); ++n) {
    const Populations& populations = levels[n].populations;
    in_precision(populations.precision(), [&]<class Real>() {
      add_populations<Real>(file, populations, part_of(levels[n], levels.count() - 1 - n));
    });
  }
}

void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress) {
  system.restore(progress, owned_swimmers(file, system), [&](Levels& levels) {
    for (int n = 0; n < levels.count(); ++n) {
      Populations& populations = levels[n].populations;
      in_precision(populations.precision(), [&]<class Real>() {
        read_populations<Real>(file, populations, part_of(levels[n], levels.count() - 1 - n));
      });
    }
  });
}

}  // namespace beadswim
