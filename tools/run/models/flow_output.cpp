#include "models/flow_output.hpp"

#include <fmt/core.h>

#include <cstring>
#include <filesystem>
#include <unordered_map>

#include "beadswim/core/error.hpp"

#include "beadswim/coupling/gather.hpp"

namespace beadswim {
namespace {

/// Converts the values of one plane of cells to the order of VTK, in which all components of a cell are
/// adjacent. In `plane`, which gather_plane() returns, all values of one component are adjacent.
std::vector<float> interleaved(const std::vector<double>& plane, int components) {
  const std::size_t cells = plane.size() / components;
  std::vector<float> result;
  result.reserve(plane.size());
  for (std::size_t cell = 0; cell < cells; ++cell) {
    for (int k = 0; k < components; ++k) result.push_back(static_cast<float>(plane[k * cells + cell]));
  }
  return result;
}

}  // namespace

FlowOutput::FlowOutput(const std::string& trajectory, const LatticeScales& scales, long interval, long done,
                       const Communicator& communicator)
    : stem_(trajectory + ".flow"), scales_(scales), communicator_(communicator) {
  std::error_code failure;
  if (communicator_.is_root()) std::filesystem::create_directories(stem_, failure);
  int reason = failure.value();
  MPI_Bcast(&reason, 1, MPI_INT, 0, communicator_.get());
  if (reason != 0) {
    throw InputError(
        "--flow-every",
        fmt::format("the folder {} cannot be created: {}; remove or rename any file of that name", stem_,
                    std::strerror(reason)));
  }
  if (done > 0 && communicator_.is_root()) remove_after(done);
  for (long step = interval; step <= done; step += interval) {
    const PvdEntry entry = entry_of(step);
    if (std::filesystem::exists(std::filesystem::path(stem_).parent_path() / entry.file))
      entries_.push_back(entry);
  }
}

void FlowOutput::remove_after(long done) const {
  std::error_code ignored;
  std::vector<std::filesystem::path> later;
  for (const auto& file : std::filesystem::directory_iterator(stem_, ignored)) {
    const std::filesystem::path& path = file.path();
    const std::string number = path.stem().string();
    const bool is_step = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
    if (path.extension() == ".vti" && is_step && number.size() < 19 && std::stol(number) > done)
      later.push_back(path);
  }
  for (const auto& path : later) std::filesystem::remove(path, ignored);
}

PvdEntry FlowOutput::entry_of(long step) const {
  return {static_cast<double>(step) * scales_.step,
          fmt::format("{}/{:09}.vti", std::filesystem::path(stem_).filename().string(), step)};
}

void FlowOutput::write(const CoupledSystem& system) {
  const auto field = [&](const std::string& name, int components, auto value) {
    return VtiField{
        .name = name, .components = components, .plane = [&system, this, components, value](int z) {
          return interleaved(gather_plane(system, communicator_, z, components, value), components);
        }};
  };
  const double pressure = scales_.density * scales_.velocity() * scales_.velocity() / 3;
  struct CoveredCell {
    Vec3 velocity;
    double number;
  };
  std::unordered_map<std::ptrdiff_t, CoveredCell> covered_cells;  // cells within beads contain no fluid
  system.coverage().for_each_own_covered_cell([&](std::ptrdiff_t cell, int bead, const Vec3& from_centre) {
    const BeadOnLattice& covering = system.beads_here()[bead];
    covered_cells.emplace(cell, CoveredCell{covering.velocity_at(from_centre), 1.0 + covering.name.bead});
  });
  const std::vector<VtiField> fields{
      field("velocity", 3,
            [&](int k, std::ptrdiff_t cell) {
              const auto covered_cell = covered_cells.find(cell);
              const Vec3 velocity = covered_cell != covered_cells.end()
                                        ? covered_cell->second.velocity
                                        : cell_moments(system.populations(), cell).momentum;
              return velocity[k] * scales_.velocity();
            }),
      field("pressure", 1,
            [&](int, std::ptrdiff_t cell) {
              return covered_cells.contains(cell)
                         ? 0.0
                         : cell_moments(system.populations(), cell).density_deviation * pressure;
            }),
      field("bead", 1, [&](int, std::ptrdiff_t cell) {
        const auto covered_cell = covered_cells.find(cell);
        return covered_cell != covered_cells.end() ? covered_cell->second.number : 0.0;
      })};
  const Index3& cells = system.decomposition().cells();
  if (!communicator_.is_root()) {  // sends its part of each plane, in the order of rank 0
    for (const VtiField& f : fields) {
      for (int z = 0; z < cells[2]; ++z) f.plane(z);
    }
    return;
  }
  const PvdEntry entry = entry_of(system.steps_done());
  write_vti(std::filesystem::path(stem_).parent_path() / entry.file, cells, scales_.cell, fields);
  entries_.push_back(entry);
  write_pvd(stem_ + ".pvd", entries_);
}

}  // namespace beadswim
