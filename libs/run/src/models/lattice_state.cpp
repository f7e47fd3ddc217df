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

/// Calls work.operator()<Real>(populations, part) for the populations of this rank on each level. Real: their
/// type.
template <class Work>
void for_each_level(auto& levels, const Work& work) {
  for (int n = 0; n < levels.count(); ++n) {
    auto& populations = levels[n].populations;
    const LatticePart part = part_of(levels[n], levels.count() - 1 - n);
    in_precision(populations.precision(),
                 [&]<class Real>() { work.template operator()<Real>(populations, part); });
  }
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
  const auto size_of = [&](std::span<const PlacedSwimmer> swimmers) {
    std::uint64_t bytes = 0;
    for (const PlacedSwimmer& swimmer : swimmers) bytes += snapshot_size(scene.type_of(swimmer).beads.size());
    return bytes;
  };
  if (size_of(scene.swimmers) != file.size(swimmers_section)) throw_other_swimmers(file);
  constexpr std::size_t swimmers_per_chunk = 4096;
  std::vector<SwimmerSnapshot> owned;
  std::uint64_t first_byte = 0;
  for (std::size_t first = 0; first < scene.swimmers.size(); first += swimmers_per_chunk) {
    const auto of_scene =
        std::span(scene.swimmers).subspan(first, std::min(swimmers_per_chunk, scene.swimmers.size() - first));
    auto chunk =
        values_from_bytes<SwimmerSnapshot>(file.bytes(swimmers_section, first_byte, size_of(of_scene)));
    first_byte += size_of(of_scene);
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
  for_each_level(system.levels(), [&]<class Real>(const Populations& populations, const LatticePart& part) {
    file.add_lattice<Real>(part, d3q19::directions, [&](int i, std::span<Real> numbers) {
      auto next = numbers.begin();
      for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
        *next++ = static_cast<Real>(populations.outgoing(i, cell));
      });
    });
  });
}

void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress) {
  system.restore(progress, owned_swimmers(file, system), [&](Levels& levels) {
    for_each_level(levels, [&]<class Real>(Populations& populations, const LatticePart& part) {
      file.read_lattice<Real>(part, d3q19::directions, [&](int i, std::span<const Real> numbers) {
        auto next = numbers.begin();
        for_each_cell(populations, [&](const Index3&, std::ptrdiff_t cell) {
          populations.set_outgoing(i, cell, static_cast<double>(*next++));
        });
      });
    });
  });
}

}  // namespace beadswim
