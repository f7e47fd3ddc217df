#include "beadswim/coupling/gather.hpp"

#include <numeric>

#include "beadswim/core/message.hpp"
#include "beadswim/core/sha256.hpp"

namespace beadswim {
namespace {

/// Returns the number of cells of a block in plane z of the lattice.
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
    const Block block = decomposition.block(r);
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

std::vector<double> gather_plane(const CoupledSystem& system, const Communicator& communicator, int z,
                                 int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value) {
  const Decomposition& decomposition = system.decomposition();
  const Block block = decomposition.block(communicator.rank());
  std::vector<double> own;
  for (int k = 0; k < components && cells_in_plane(block, z) > 0; ++k) {
    for (int y = 0; y < block.size[1]; ++y) {
      for (int x = 0; x < block.size[0]; ++x) {
        own.push_back(value(k, system.populations().cell(x, y, z - block.offset[2])));
      }
    }
  }
  std::vector<int> sizes(communicator.size()), starts(communicator.size());
  for (int r = 0; r < communicator.size(); ++r)
    sizes[r] = components * cells_in_plane(decomposition.block(r), z);
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<double> packed(communicator.is_root() ? starts.back() + sizes.back() : 0);
  MPI_Gatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, packed.data(), sizes.data(),
              starts.data(), MPI_DOUBLE, 0, communicator.get());
  return communicator.is_root() ? in_global_order(decomposition, z, components, packed)
                                : std::vector<double>{};
}

std::string state_sha256(const CoupledSystem& system, const Communicator& communicator) {
  Sha256 hash;
  const Populations& populations = system.populations();
  for (int z = 0; z < system.decomposition().cells()[2]; ++z) {
    const std::vector<double> plane =
        gather_plane(system, communicator, z, d3q19::directions,
                     [&](int i, std::ptrdiff_t cell) { return populations.outgoing(i, cell); });
    hash.update(std::as_bytes(std::span(plane)));
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
