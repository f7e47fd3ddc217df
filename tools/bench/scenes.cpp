#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/lattice/fluid_step.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/levels.hpp"
#include "beadswim/scene/presets.hpp"
#include "yardstick.hpp"

namespace beadswim {
namespace {

constexpr std::array periodic{Boundary::periodic, Boundary::periodic, Boundary::periodic};
constexpr std::array walls{Boundary::free_slip, Boundary::no_slip, Boundary::free_slip};
constexpr double relaxation_time = 1.5;
constexpr int cells_around_level = 4;  ///< in the coarse level of the case levels-step

/// Returns the places of the two levels of the case levels-step: a level of `edge` cells per axis and rank,
/// in a coarser level.
std::vector<LevelPlace> two_levels(int edge, int ranks) {
  const Index3 refined(edge / 2, edge / 2, edge / 2 * ranks);
  const Block coarse{.size = refined + 2 * cells_around_level};
  const Block fine = Block{.offset = Index3::Constant(cells_around_level), .size = refined}.doubled();
  return places_in_box(2 * coarse.size, periodic, std::array{coarse, fine});
}

/// Sets a slow uniform flow in every cell, so that no population is a subnormal number, with which arithmetic
/// is slow.
void set_uniform_flow(Populations& populations) {
  in_precision(populations.precision(), [&]<class Real>() {
    const Index3& n = populations.size();
    for (int i = 0; i < d3q19::directions; ++i) {
      const auto value = static_cast<Real>(equilibrium(i, 1e-3, 0.01, 0.003, -0.002));
      for (int z = 0; z < n[2]; ++z) {
        for (int y = 0; y < n[1]; ++y) {
          Real* row = populations.outgoing_row<Real>(i, populations.cell(0, y, z));
          std::fill(row, row + n[0], value);
        }
      }
    }
  });
}

/// Returns a uniform swarm as in the paper (Pickl et al. 2017) in a periodic box of edge x edge x (edge x
/// ranks) cells. Bead radius: 6 cells; arms: 32 cells; distance of neighbouring rows: 32 cells. The box
/// contains as many swimmers as fit. A swimmer needs 96 cells along x. For a shorter edge, all lengths are
/// multiplied by edge/96, so that the beads occupy the same volume fraction.
CoupledScene swarm_scene(int edge, int ranks, Precision precision, BeadScheme bead_boundary) {
  ThreeBeadSwimmer type = three_beads(paper_swarm().types.at("a"));
  const double spacing = type.springs[0].rest_length, length = 3 * spacing;
  const double scale = std::min(1.0, edge / length);
  for (Bead& bead : type.beads) bead.radius *= scale;
  for (Spring& spring : type.springs) spring.rest_length *= scale;
  for (double& amplitude : type.driving.amplitude) amplitude *= scale * scale;
  CoupledScene scene;
  scene.cells = {edge, edge, edge * ranks};
  scene.relaxation_time = relaxation_time;
  scene.precision = precision;
  scene.bead_boundary = bead_boundary;
  scene.types = {swimmer_type(type)};
  const Index3 swimmers =
      (scene.cells.cast<double>() / (scale * Vec3(length, spacing, spacing).array()) + 1e-9)
          .floor()
          .cast<int>();
  const Vec3 distance = scene.cells.cast<double>() / swimmers.cast<double>();
  for (int z = 0; z < swimmers[2]; ++z) {
    for (int y = 0; y < swimmers[1]; ++y) {
      for (int x = 0; x < swimmers[0]; ++x) {
        const Vec3 middle = distance.array() * (Vec3(x, y, z).array() + 0.5);
        scene.swimmers.push_back(
            {.id = static_cast<int>(scene.swimmers.size()), .type = 0, .position = middle});
      }
    }
  }
  return scene;
}

/// Memory and solvers for all cases of the benchmark at one floating-point precision.
struct Scene {
  Scene(int edge, Precision precision, BeadScheme bead_boundary, const Communicator& communicator)
      : precision(precision),
        decomposition(Index3(edge, edge, edge * communicator.size()), communicator.size()),
        yardstick(edge, precision),
        populations(decomposition.block(communicator.rank()).size, precision),
        periodic_halo(communicator, decomposition, periodic),
        walled_halo(communicator, decomposition, walls),
        swarm(swarm_scene(edge, communicator.size(), precision, bead_boundary), communicator),
        levels(two_levels(edge, communicator.size()), relaxation_time, precision, HaloContent::entering,
               communicator) {
    yardstick.choose_layout(9, communicator);
    set_uniform_flow(populations);
    for (int n = 0; n < levels.count(); ++n) set_uniform_flow(levels[n].populations);
  }

  void step(Halo* halo) {
    const RelaxationRates rates = relaxation_rates(relaxation_time);
    if (halo == nullptr) return stream_and_collide(populations, rates);
    step_fluid(populations, *halo, rates);
  }
  /// Makes one step of the coarse level and two of the fine one.
  void step_levels() {
    for (int n = 0; n < 2; ++n) levels.step(Vec3::Zero(), [](int, int) {});
  }
  /// Returns the cell updates of step_levels() on all ranks.
  double updates_of_levels() const {
    const double coarse = levels[0].place.lattice.size.cast<double>().prod(),
                 fine = levels[1].place.lattice.size.cast<double>().prod();
    return 2 * fine + coarse - fine / 8;
  }

  Precision precision;
  Decomposition decomposition;
  StreamYardstick yardstick;
  Populations populations;
  Halo periodic_halo, walled_halo;
  CoupledSystem swarm;
  Levels levels;
};

}  // namespace

double bytes_per_update(Precision precision) {
  return 2.0 * d3q19::directions * static_cast<double>(bytes_per_population(precision));
}

std::vector<BenchCase> lattice_cases(int edge, const std::vector<Precision>& precisions,
                                     BeadScheme bead_boundary, const Communicator& communicator) {
  const double cells = std::pow(edge, 3) * communicator.size();
  std::vector<BenchCase> cases;
  for (const Precision precision : precisions) {
    const auto scene = std::make_shared<Scene>(edge, precision, bead_boundary, communicator);
    const auto add = [&](const std::string& name, double updates, const std::function<void()>& step) {
      cases.push_back({.name = name, .precision = precision, .step = step, .updates = updates});
    };
    add("stream-yardstick", cells, [scene] { scene->yardstick.sweep(); });
    cases.back().layout = scene->yardstick.layout().name;
    add("bare-sweep", cells, [scene] { scene->step(nullptr); });
    add("periodic-step", cells, [scene] { scene->step(&scene->periodic_halo); });
    add("wall-step", cells, [scene] { scene->step(&scene->walled_halo); });
    add("levels-step", scene->updates_of_levels(), [scene] { scene->step_levels(); });
    add("coupled-swarm", cells, [scene] { scene->swarm.step(); });
  }
  return cases;
}

double lattice_bytes(int edge, const std::vector<Precision>& precisions) {
  // One lattice each for the yardstick, the fluid, the swarm and the fine level; the coarse level is smaller.
  constexpr double lattices = 4, bandwidth_arrays = 2;
  const double coarse_level = std::pow(edge / 2 + 2 * cells_around_level + 2, 3) / std::pow(edge + 2, 3);
  double bytes = bandwidth_arrays * sizeof(double) * Bandwidth::num_elements;
  for (const Precision precision : precisions) {
    const double bytes_per_number = static_cast<double>(bytes_per_population(precision));
    bytes += ((lattices + coarse_level) * d3q19::directions * bytes_per_number + 1) * std::pow(edge + 2, 3);
  }
  return bytes;
}

}  // namespace beadswim
