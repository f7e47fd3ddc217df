#include "models/flow_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <unordered_map>

#include "beadswim/core/error.hpp"
#include "beadswim/core/setting.hpp"

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

FlowOutput::FlowOutput(const std::string& path, const UnitScales& scales, long done, int levels,
                       const Communicator& communicator)
    : stem_(path + ".flow"), scales_(scales), done_(done), levels_(levels), communicator_(communicator) {
  std::error_code failure;
  if (communicator_.is_root()) std::filesystem::create_directories(stem_, failure);
  int reason = failure.value();
  MPI_Bcast(&reason, 1, MPI_INT, 0, communicator_.get());
  if (reason != 0) {
    throw InputError(
        Setting::flow_every,
        fmt::format("the folder {} cannot be created: {}; remove or rename any file of that name", stem_,
                    std::strerror(reason)));
  }
  if (done > 0 && communicator_.is_root()) remove_after(done);
}

void FlowOutput::restore(const std::vector<long>& steps) {
  const std::filesystem::path folder = std::filesystem::path(stem_).parent_path();
  const auto exists = [&](const PvdEntry& entry) { return std::filesystem::exists(folder / entry.file); };
  if (done_ == 0) return;
  std::ranges::copy_if(steps, std::back_inserter(steps_),
                       [&](long step) { return std::ranges::all_of(entries_of(step), exists); });
  write_index();
}

void FlowOutput::write_index() const {
  if (!communicator_.is_root()) return;
  std::vector<PvdEntry> entries;
  for (const long step : steps_) std::ranges::copy(entries_of(step), std::back_inserter(entries));
  write_pvd(stem_ + ".pvd", entries);
}

void FlowOutput::remove_after(long done) const {
  std::error_code ignored;
  std::vector<std::filesystem::path> later;
  for (const auto& file : std::filesystem::directory_iterator(stem_, ignored)) {
    const std::filesystem::path& path = file.path();
    const std::string name = path.stem().string(), number = name.substr(0, name.find('-'));
    const bool is_step = !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
    if (path.extension() == ".vti" && is_step && number.size() < 19 && std::stol(number) > done)
      later.push_back(path);
  }
  for (const auto& path : later) std::filesystem::remove(path, ignored);
}

std::vector<PvdEntry> FlowOutput::entries_of(long step) const {
  std::vector<PvdEntry> entries;
  for (int n = 0; n < levels_; ++n) {
    const std::string level = levels_ == 1 ? "" : fmt::format("-{}", n);
    entries.push_back(
        {.time = static_cast<double>(step) * scales_.time,
         .file = fmt::format("{}/{:09}{}.vti", std::filesystem::path(stem_).filename().string(), step, level),
         .part = n});
  }
  return entries;
}

void FlowOutput::write(const CoupledSystem& system) {
  const std::filesystem::path folder = std::filesystem::path(stem_).parent_path();
  steps_.push_back(system.steps_done());
  for (const PvdEntry& entry : entries_of(steps_.back()))
    write_level(system, entry.part, folder / entry.file);
  write_index();
}

void FlowOutput::write_level(const CoupledSystem& system, int number, const std::string& file) {
  const Level& level = system.levels()[number];
  const Populations& populations = level.populations;
  const auto field = [&](const std::string& name, int components, auto value) {
    return VtiField{
        .name = name, .components = components, .plane = [this, &level, components, value](int z) {
          return interleaved(gather_plane(level, communicator_, z, components, value), components);
        }};
  };
  const double pressure = scales_.density * scales_.velocity() * scales_.velocity() / 3;
  struct CoveredCell {
    Vec3 velocity;
    double number;
  };
  std::unordered_map<std::ptrdiff_t, CoveredCell> covered_cells;  // cells within beads contain no fluid
  if (number == levels_ - 1) {
    system.coverage().for_each_own_covered_cell([&](std::ptrdiff_t cell, int bead, const Vec3& from_centre) {
      const BeadOnLattice& covering = system.beads_here()[bead];
      covered_cells.emplace(cell, CoveredCell{covering.velocity_at(from_centre), 1.0 + covering.name.bead});
    });
  }
  std::unordered_map<std::ptrdiff_t, Vec3> forces;  // half of a force of a bead belongs to the velocity
  if (number == levels_ - 1) {
    for (const SaturatedForce& cell : system.saturated_forces()) forces.emplace(cell.cell, cell.force);
  }
  const auto velocity_of_fluid = [&](std::ptrdiff_t cell) -> Vec3 {
    const auto force = forces.find(cell);
    const Vec3 velocity = system.levels().velocity(number, cell);
    return force == forces.end() ? velocity : Vec3(velocity - 0.5 * force->second);
  };
  std::vector<VtiField> fields{
      field("velocity", 3,
            [&](int k, std::ptrdiff_t cell) {
              const auto covered_cell = covered_cells.find(cell);
              const Vec3 velocity = covered_cell != covered_cells.end() ? covered_cell->second.velocity
                                                                        : velocity_of_fluid(cell);
              return velocity[k] * scales_.velocity();
            }),
      field("pressure", 1,
            [&](int, std::ptrdiff_t cell) {
              return covered_cells.contains(cell)
                         ? 0.0
                         : cell_moments(populations, cell).density_deviation * pressure;
            }),
      field("bead", 1, [&](int, std::ptrdiff_t cell) {
        const auto covered_cell = covered_cells.find(cell);
        return covered_cell != covered_cells.end() ? covered_cell->second.number : 0.0;
      })};
  if (levels_ > 1) {
    VtiField hiding{.name = vti_hiding_field, .is_small_integer = true, .plane = [&](int z) {
                      std::vector<double> used =
                          gather_plane(level, communicator_, z, 1, [](int, std::ptrdiff_t) { return 1.0; });
                      std::vector<float> hidden;
                      for (const double is_used : used) hidden.push_back(is_used == 0 ? vti_hidden : 0);
                      return hidden;
                    }};
    fields.push_back(std::move(hiding));
  }
  const Block& lattice = level.place.lattice;
  if (!communicator_.is_root()) {  // sends its part of each plane, in the order of rank 0
    for (const VtiField& f : fields) {
      for (int z = 0; z < lattice.size[2]; ++z) f.plane(z);
    }
    return;
  }
  const double edge = std::ldexp(scales_.length, levels_ - 1 - number);
  // The image of the levels in which the centre of the finest level lies in the box.
  const LevelPlace& finest = system.levels().finest().place;
  Index3 offset = lattice.offset;
  for (int a = 0; a < 3; ++a) {
    if (level.place.boundary[a] != Boundary::periodic || level.place.spans(a)) continue;
    const double centre = finest.lattice.offset[a] + 0.5 * finest.lattice.size[a];
    offset[a] -= level.place.box[a] * static_cast<int>(std::floor(centre / finest.box[a]));
  }
  write_vti(file, {.cells = lattice.size, .spacing = edge, .origin = edge * offset.cast<double>().matrix()},
            fields);
}

}  // namespace beadswim
