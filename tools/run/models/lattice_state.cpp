#include "models/lattice_state.hpp"

#include <algorithm>

#include "beadswim/coupling/swimmer_snapshot.hpp"

namespace beadswim {
namespace {

constexpr const char* swimmers_section = "swimmers";

LatticePart part_of(const CoupledSystem& system, const Communicator& communicator) {
  const Decomposition& decomposition = system.decomposition();
  const Block block = decomposition.block(communicator.rank());
  return {.cells = decomposition.cells(), .offset = block.offset, .size = block.size};
}

/// Writes the populations of this rank to a checkpoint, in the floating-point precision of the run.
template <class Real>
void add_populations(CheckpointWriter& file, const CoupledSystem& system, const LatticePart& part) {
  const Populations& populations = system.populations();
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

bool is_sound(const SwimmerState& swimmer, const PlacedSwimmer& of_scene) {
  return swimmer.id == of_scene.id && swimmer.type == of_scene.type &&
         std::ranges::all_of(swimmer.motion, [](const BeadMotion& bead) {
           return (bead.position.array().abs() < max_coordinate).all() && bead.velocity.allFinite() &&
                  bead.angular_velocity.allFinite();
         });
}

/// Reads the swimmers of a checkpoint in chunks and returns those swimmers that this rank owns. Throws
/// SolverError if the checkpoint contains the swimmers of another scene.
std::vector<SwimmerSnapshot> owned_swimmers(const CheckpointReader& file, const CoupledSystem& system) {
  const std::uint64_t total_bytes = file.size(swimmers_section), chunk_bytes = 4096 * snapshot_size();
  const std::vector<PlacedSwimmer>& of_scene = system.scene().swimmers;
  if (total_bytes != of_scene.size() * snapshot_size())
    throw SolverError(file.path() +
                      ": the checkpoint contains other swimmers than the layout; take the run's other "
                      "checkpoint (.ckpt.0 or .ckpt.1), or "
                      "begin without --restart");
  auto next = of_scene.begin();
  std::vector<SwimmerSnapshot> owned;
  for (std::uint64_t first = 0; first < total_bytes; first += chunk_bytes) {
    for (SwimmerSnapshot& swimmer : snapshots_from_bytes(
             file.bytes(swimmers_section, first, std::min(chunk_bytes, total_bytes - first)))) {
      if (!is_sound(swimmer.state, *next++))
        throw SolverError(file.path() +
                          ": the checkpoint contains other swimmers than the layout; take the run's other "
                          "checkpoint (.ckpt.0 or .ckpt.1), "
                          "or begin without --restart");
      if (system.owns(swimmer.state)) owned.push_back(std::move(swimmer));
    }
  }
  return owned;
}

}  // namespace

void write_lattice_state(CheckpointWriter& file, CoupledSystem& system, const Communicator& communicator) {
  file.add(swimmers_section, bytes_of(system.gather_snapshots()));
  const LatticePart part = part_of(system, communicator);
  in_precision(system.populations().precision(),
               [&]<class Real>() { add_populations<Real>(file, system, part); });
}

void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemProgress& progress,
                        const Communicator& communicator) {
  const LatticePart part = part_of(system, communicator);
  system.restore(progress, owned_swimmers(file, system), [&](Populations& populations) {
    in_precision(populations.precision(),
                 [&]<class Real>() { read_populations<Real>(file, populations, part); });
  });
}

}  // namespace beadswim
