#include "beadswim/coupling/gather.hpp"

#include <numeric>

#include "beadswim/core/message.hpp"
#include "beadswim/core/sha256.hpp"

namespace beadswim {
namespace {

/// Returns the block of a rank, relative to the first cell of the level.
Block block_of(int rank, const Decomposition& decomposition) {
  Block block = decomposition.block(rank);
  block.offset -= decomposition.lattice().offset;
  return block;
}

/// Returns the number of cells of a block in plane z of the level.
int cells_in_plane(const Block& block, int z) {
  const int local = z - block.offset[2];
  return local >= 0 && local < block.size[2] ? block.size[0] * block.size[1] : 0;
}

/// Sorts the values of a plane from the order of `packed`, block by block, into global order: component
/// (slowest), y, x.
std::vector<double> in_global_order(const Decomposition& decomposition, int z, int components,
                                    const std::vector<double>& packed) {
  const Index3& cells = decomposition.cells();
  std::vector<double> plane(packed.size());
  auto value = packed.begin();
  for (int r = 0; r < decomposition.ranks(); ++r) {
    const Block block = block_of(r, decomposition);
    if (cells_in_plane(block, z) == 0) continue;
    for (int k = 0; k < components; ++k) {
      for (int y = 0; y < block.size[1]; ++y) {
        const std::ptrdiff_t row =
            block.offset[0] + static_cast<std::ptrdiff_t>(cells[0]) *
                                  (block.offset[1] + y + static_cast<std::ptrdiff_t>(cells[1]) * k);
        std::copy_n(value, block.size[0], plane.begin() + row);
        value += block.size[0];
      }
    }
  }
  return plane;
}

}  // namespace

std::vector<double> gather_plane(const Level& level, const Communicator& communicator, int z, int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value) {
  const Decomposition& decomposition = level.decomposition;
  const Block block = block_of(communicator.rank(), decomposition);
  std::vector<double> own;
  for (int k = 0; k < components && cells_in_plane(block, z) > 0; ++k) {
    const std::size_t first = own.size();
    own.resize(first + cells_in_plane(block, z));
    const int local_z = z - block.offset[2];
    for (int y = 0; y < block.size[1]; ++y) {
      for_each_run_outside(level.refined, block.size[0], y, local_z, [&](int x, int end) {
        for (; x < end; ++x)
          own[first + x + block.size[0] * y] = value(k, level.populations.cell(x, y, local_z));
      });
    }
  }
  std::vector<int> sizes(communicator.size()), starts(communicator.size());
  for (int r = 0; r < communicator.size(); ++r)
    sizes[r] = components * cells_in_plane(block_of(r, decomposition), z);
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<double> packed(communicator.is_root() ? starts.back() + sizes.back() : 0);
  MPI_Gatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, packed.data(), sizes.data(),
              starts.data(), MPI_DOUBLE, 0, communicator.get());
  return communicator.is_root() ? in_global_order(decomposition, z, components, packed)
                                : std::vector<double>{};
}

std::string state_sha256(const CoupledSystem& system, const Communicator& communicator) {
  Sha256 hash;
  const Levels& levels = system.levels();
  for (int n = 0; n < levels.count(); ++n) {
    const Level& level = levels[n];
    for (int z = 0; z < level.place.lattice.size[2]; ++z) {
      const std::vector<double> plane =
          gather_plane(level, communicator, z, d3q19::directions,
                       [&](int i, std::ptrdiff_t cell) { return level.populations.outgoing(i, cell); });
      hash.update(std::as_bytes(std::span(plane)));
    }
  }
  OutgoingMessage beads;
  for (const SwimmerState& swimmer : system.gather_swimmers()) {
    for (std::size_t b = 0; b < swimmer.motion.size(); ++b)
      SwimmerState::visit_bead_fields([&](const char*, const auto& of_beads) { beads(of_beads[b]); },
                                      swimmer);
  }
  hash.update(std::as_bytes(std::span(beads.bytes())));
  return communicator.is_root() ? hash.hexadecimal() : std::string{};
}

}  // namespace beadswim
