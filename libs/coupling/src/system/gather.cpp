#include <array>

#include "beadswim/core/message.hpp"
#include "beadswim/core/sha256.hpp"
#include "beadswim/coupling/coupled_system.hpp"

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

}  // namespace

std::vector<double> gather_plane(const Level& level, const Communicator& communicator, int z, int components,
                                 const std::function<double(int component, std::ptrdiff_t cell)>& value) {
  const Decomposition& decomposition = level.decomposition;
  const Block block = block_of(communicator.rank(), decomposition);
  const int local_z = z - block.offset[2], rows = cells_in_plane(block, z) / block.size[0];
  std::vector<double> own(static_cast<std::size_t>(components) * cells_in_plane(block, z));
  auto row = own.begin();
  for (int k = 0; k < components; ++k) {
    for (int y = 0; y < rows; ++y, row += block.size[0]) {
      for_each_run_outside(level.refined, block.size[0], y, local_z, [&](int x, int end) {
        for (; x < end; ++x) row[x] = value(k, level.populations.cell(x, y, local_z));
      });
    }
  }
  constexpr int tag = 31;  // Halo, BeadExchange and NumberExchange use other tags
  std::vector<double> plane;
  std::vector<MPI_Request> requests;
  if (communicator.is_root()) {
    const Index3& cells = decomposition.cells();
    plane.resize(static_cast<std::size_t>(components) * cells[0] * cells[1]);
    for (int r = 0; r < communicator.size(); ++r) {
      const Block part = block_of(r, decomposition);
      if (cells_in_plane(part, z) == 0) continue;
      const std::array sizes{components, cells[1], cells[0]}, first{0, part.offset[1], part.offset[0]},
          part_sizes{components, part.size[1], part.size[0]};
      MPI_Datatype place;
      MPI_Type_create_subarray(3, sizes.data(), part_sizes.data(), first.data(), MPI_ORDER_C, MPI_DOUBLE,
                               &place);
      MPI_Type_commit(&place);
      MPI_Irecv(plane.data(), 1, place, r, tag, communicator.get(), &requests.emplace_back());
      MPI_Type_free(&place);
    }
  }
  if (!own.empty())
    MPI_Isend(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, tag, communicator.get(),
              &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return plane;
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
