#include "scene_on_lattice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// What a run uses if neither the command line nor the layout says otherwise: the paper's.
constexpr Resolution default_resolution{.cells_per_radius = 4, .relaxation_time = 1.5};

double smallest_radius(const Layout& layout) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& [name, type] : layout.types) {
    for (const Bead& bead : type.beads) smallest = std::min(smallest, bead.radius);
  }
  return smallest;
}

const Domain& require_box(const Layout& layout) {
  if (layout.domain) return *layout.domain;
  throw InputError("/domain",
                   "is null (unbounded fluid), which a lattice cannot hold; make the layout with --box "
                   "X,Y,Z and --boundary, or ask beadswim-theory");
}

double common_period(const Layout& layout) {
  const double period = layout.resolved_type(layout.swimmers.front()).driving.period;
  for (const Swimmer& swimmer : layout.swimmers) {
    const double own = layout.resolved_type(swimmer).driving.period;
    if (own == period) continue;
    throw InputError(
        fmt::format("/swimmers (id {})", swimmer.id),
        fmt::format("its period {} differs from {}, that of the first swimmer; a run needs one period", own,
                    period));
  }
  return period;
}

Index3 whole_cells(const Vec3& lengths, double cell) {
  Index3 cells;
  for (int a = 0; a < 3; ++a) {
    const double exact = lengths[a] / cell;
    const double whole = std::round(exact);
    constexpr double roundoff = 1e-9;
    if (whole < 1 || std::abs(exact - whole) > roundoff * whole) {
      throw InputError(
          fmt::format("/domain/lengths/{}", a),
          fmt::format("{} is {:.6g} cells of {:.6g}, not a whole number; the nearest are {:.10g} and "
                      "{:.10g}, or choose another --cells-per-radius",
                      lengths[a], exact, cell, std::max(1.0, std::floor(exact)) * cell,
                      (std::floor(exact) + 1) * cell));
    }
    cells[a] = static_cast<int>(whole);
  }
  return cells;
}

Wall wall_of(Boundary boundary) {
  switch (boundary) {
    case Boundary::periodic:
      return Wall::periodic;
    case Boundary::free_slip:
      return Wall::free_slip;
    case Boundary::no_slip:
      return Wall::no_slip;
  }
  throw SolverError("unknown boundary");
}

}  // namespace

SceneOnLattice put_on_lattice(const Layout& layout, const RunOptions& options) {
  const Domain& domain = require_box(layout);
  const Resolution hint = layout.resolution.value_or(default_resolution);
  SceneOnLattice result;
  result.period = common_period(layout);
  result.cells_per_radius = options.cells_per_radius.value_or(hint.cells_per_radius);
  result.lattice = choose_lattice(smallest_radius(layout), result.cells_per_radius,
                                  options.relaxation_time.value_or(hint.relaxation_time),
                                  layout.fluid.density, layout.fluid.kinematic_viscosity, result.period);
  const LatticeScales& scales = result.lattice.scales;

  CoupledScene& scene = result.scene;
  scene.relaxation_time = result.lattice.relaxation_time;
  scene.cells = whole_cells(domain.lengths, scales.cell);
  for (int a = 0; a < 3; ++a) scene.walls[a] = wall_of(domain.boundary[a]);
  for (const Swimmer& swimmer : layout.swimmers) {
    scene.swimmers.push_back({.id = swimmer.id,
                              .type = static_cast<int>(scene.types.size()),
                              .position = swimmer.position / scales.cell,
                              .axis = swimmer.axis});
    scene.types.push_back(in_lattice_units(layout.resolved_type(swimmer), scales));
  }
  std::ranges::sort(scene.swimmers, {}, &CoupledScene::Swimmer::id);  // the order of every list of beads
  return result;
}

}  // namespace beadswim
