#include "lattice_state.hpp"

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

/// The populations of one rank, as they are stored.
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

/// Of all swimmers, those that this rank owns, read some thousands at a time.
std::vector<SwimmerSnapshot> owned_swimmers(const CheckpointReader& file, const CoupledSystem& system) {
  const std::uint64_t all = file.size(swimmers_section), some = 4096 * snapshot_size();
  std::vector<SwimmerSnapshot> owned;
  for (std::uint64_t first = 0; first < all; first += some) {
    for (SwimmerSnapshot& swimmer :
         snapshots_from_bytes(file.bytes(swimmers_section, first, std::min(some, all - first)))) {
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

void read_lattice_state(const CheckpointReader& file, CoupledSystem& system, const SystemMoment& moment,
                        const Communicator& communicator) {
  const LatticePart part = part_of(system, communicator);
  system.restore(moment, owned_swimmers(file, system), [&](Populations& populations) {
    in_precision(populations.precision(),
                 [&]<class Real>() { read_populations<Real>(file, populations, part); });
  });
}

}  // namespace beadswim
