#include "models/lattice_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

/// Returns the image of the levels in which the centre of the finest level lies in the box: the first cell of
/// a level.
Index3 first_cell(const Level& level, const LevelPlace& finest) {
  Index3 offset = level.place.lattice.offset;
  for (int a = 0; a < 3; ++a) {
    if (level.place.boundary[a] != Boundary::periodic || level.place.spans(a)) continue;
    const double centre = finest.lattice.offset[a] + 0.5 * finest.lattice.size[a];
    offset[a] -= level.place.box[a] * static_cast<int>(std::floor(centre / finest.box[a]));
  }
  return offset;
}

}  // namespace

LatticeFlow::LatticeFlow(const CoupledSystem& system, const UnitScales& scales,
                         const Communicator& communicator)
    : system_(system), levels_(system.levels()), scales_(scales), communicator_(communicator) {
  system.coverage().for_each_own_covered_cell([&](std::ptrdiff_t cell, int bead, const Vec3& from_centre) {
    covered_.emplace(cell, CoveredCell{&system.beads_here()[bead], from_centre});
  });
  for (const SaturatedForce& cell : system.saturated_forces()) forces_.emplace(cell.cell, cell.force);
}

/// Returns the flow in a cell of this rank. `offset`: of the point whose rigid velocity counts within a bead,
/// from the centre of the cell [cell].
PointFlow LatticeFlow::in_cell(int level, std::ptrdiff_t cell, const Vec3& offset) const {
  const bool is_finest = level == levels_.count() - 1;
  if (const auto found = covered_.find(cell); is_finest && found != covered_.end()) {
    const auto& [bead, from_centre] = found->second;
    return {.velocity = bead->velocity_at(from_centre + offset) * scales_.velocity(),
            .pressure = 0.0,
            .bead = 1.0 + bead->name.bead};
  }
  Vec3 velocity = levels_.velocity(level, cell);
  if (const auto force = forces_.find(cell); is_finest && force != forces_.end())
    velocity -= 0.5 * force->second;
  const double pressure = scales_.density * scales_.velocity() * scales_.velocity() / 3;
  return {.velocity = velocity * scales_.velocity(),
          .pressure = cell_moments(levels_[level].populations, cell).density_deviation * pressure};
}

void LatticeFlow::write(const std::vector<std::string>& files) const {
  for (std::size_t n = 0; n < files.size(); ++n) write_level(static_cast<int>(n), files[n]);
}

void LatticeFlow::write_level(int number, const std::string& file) const {
  const Level& level = levels_[number];
  const auto field = [&](const std::string& name, int components, auto value) {
    return VtiField{
        .name = name, .components = components, .plane = [this, &level, number, components, value](int z) {
          const auto of_cell = [&](int k, std::ptrdiff_t cell) {
            return value(in_cell(number, cell, Vec3::Zero()), k);
          };
          return interleaved(gather_plane(level, communicator_, z, components, of_cell), components);
        }};
  };
  std::vector<VtiField> fields{
      field("velocity", 3, [](const PointFlow& flow, int k) { return flow.velocity[k]; }),
      field("pressure", 1, [](const PointFlow& flow, int) { return *flow.pressure; }),
      field("bead", 1, [](const PointFlow& flow, int) { return flow.bead; })};
  if (levels_.count() > 1) {
    fields.push_back({.name = vti_hiding_field, .is_small_integer = true, .plane = [&](int z) {
                        std::vector<float> hidden;
                        for (const double is_used : gather_plane(level, communicator_, z, 1,
                                                                 [](int, std::ptrdiff_t) { return 1.0; }))
                          hidden.push_back(is_used == 0 ? vti_hidden : 0);
                        return hidden;
                      }});
  }
  const Block& lattice = level.place.lattice;
  if (!communicator_.is_root()) {  // sends its part of each plane, in the order of rank 0
    for (const VtiField& f : fields) {
      for (int z = 0; z < lattice.size[2]; ++z) f.plane(z);
    }
    return;
  }
  const double edge = std::ldexp(scales_.length, levels_.count() - 1 - number);
  const Index3 first = first_cell(level, levels_.finest().place);
  write_vti(file, {.cells = lattice.size, .spacing = edge, .origin = edge * first.cast<double>().matrix()},
            fields);
}

/// A cell around a point, with its weight in the interpolation.
struct LatticeFlow::Corner {
  Index3 cell;
  double weight;
  Vec3 offset;  ///< of the point from the centre of the cell [cell]
};

/// Finds the eight cells of a level around a point [cell of the finest level]. At walls the flow is
/// extrapolated. Returns false if the level does not contain all of them.
bool LatticeFlow::find_corners(int level, const Vec3& point, std::span<Corner> corners) const {
  const LevelPlace& place = levels_[level].place;
  const Vec3 at = std::ldexp(1, level + 1 - levels_.count()) * point;
  Index3 low;
  for (int a = 0; a < 3; ++a) {
    low[a] = static_cast<int>(std::floor(at[a] - 0.5));
    if (place.boundary[a] != Boundary::periodic) low[a] = std::clamp(low[a], 0, place.box[a] - 2);
  }
  for (int n = 0; n < 8; ++n) {
    const Index3 step(n & 1, n >> 1 & 1, n >> 2);
    const Vec3 offset = at - (low + step).cast<double>().matrix() - Vec3::Constant(0.5);
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= step[a] == 0 ? 1 - (offset[a]) : 1 + offset[a];
    corners[n] = {.cell = place.in_lattice(low + step), .weight = weight, .offset = offset};
    if (!place.lattice.contains(corners[n].cell)) return false;
  }
  return true;
}

std::vector<PointFlow> LatticeFlow::at(std::span<const Vec3> points) const {
  std::vector<PointFlow> result(communicator_.is_root() ? points.size() : 0);
  // Each rank sets the numbers of its cells and the others add zeros, so that the sum has the same bits on
  // any number of ranks: velocity, pressure, bead + 1 (0: a cell that is not in use).
  constexpr int numbers = 5, corner_count = 8;
  constexpr std::size_t points_at_once = 1 << 14;
  for (std::size_t first = 0; first < points.size(); first += points_at_once) {
    const auto chunk = points.subspan(first, std::min(points_at_once, points.size() - first));
    std::vector<std::array<Corner, corner_count>> corners(chunk.size());
    std::vector<double> values(numbers * corner_count * chunk.size(), 0.0);
    for (std::size_t p = 0; p < chunk.size(); ++p) {
      int n = levels_.count() - 1;
      while (!find_corners(n, chunk[p] / scales_.length, corners[p]) && n > 0) --n;
      const Level& level = levels_[n];
      for (int c = 0; c < corner_count; ++c) {
        const Index3 local = corners[p][c].cell - level.block.offset;
        const auto has_local = [&](const Block& part) { return part.contains(local); };
        if (!level.block.contains(corners[p][c].cell) || std::ranges::any_of(level.refined, has_local))
          continue;
        const std::ptrdiff_t cell = level.populations.cell(local);
        PointFlow flow = in_cell(n, cell, corners[p][c].offset);
        if (flow.bead > 0) {  // the point may lie outside of a bead that covers the centre of the cell
          const CoveredCell& covered = covered_.at(cell);
          if ((covered.from_centre + corners[p][c].offset).norm() > covered.bead->radius) {
            flow = in_cell(n, cell, Vec3::Zero());
            flow.bead = 0;
          }
        }
        double* const value = &values[numbers * (corner_count * p + c)];
        for (int a = 0; a < 3; ++a) value[a] = flow.velocity[a];
        value[3] = *flow.pressure;
        value[4] = flow.bead + 1;
      }
    }
    const bool is_root = communicator_.is_root();
    MPI_Reduce(is_root ? MPI_IN_PLACE : values.data(), values.data(), static_cast<int>(values.size()),
               MPI_DOUBLE, MPI_SUM, 0, communicator_.get());
    for (std::size_t p = 0; p < chunk.size() && is_root; ++p) {
      PointFlow& flow = result[first + p];
      flow.pressure = 0;
      double weights = 0;
      for (int c = 0; c < corner_count; ++c) {
        const double* const value = &values[numbers * (corner_count * p + c)];
        if (value[4] > 1) {  // inside of a bead
          flow = {.velocity = Vec3::Map(value), .pressure = 0.0, .bead = value[4] - 1};
          weights = 1;
          break;
        }
        if (value[4] == 0) continue;
        weights += corners[p][c].weight;
        flow.velocity += corners[p][c].weight * Vec3::Map(value);
        *flow.pressure += corners[p][c].weight * value[3];
      }
      flow.velocity /= weights;
      *flow.pressure /= weights;
    }
  }
  return result;
}

}  // namespace beadswim
