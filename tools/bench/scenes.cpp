#include "scenes.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/huge_pages.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/lattice/fluid_step.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/sweep.hpp"
#include "stream_kernels.hpp"
#include "swarm_scene.hpp"

namespace beadswim {
namespace {

constexpr std::array periodic{Boundary::periodic, Boundary::periodic, Boundary::periodic};
constexpr std::array walls{Boundary::free_slip, Boundary::no_slip, Boundary::free_slip};
constexpr double relaxation_time = 1.5;

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

}  // namespace

double bytes_per_update(Precision precision) {
  return 2.0 * d3q19::directions * static_cast<double>(bytes_per_population(precision));
}

/// Memory and solvers for all cases of the benchmark at one floating-point precision.
struct BenchScenes::Scene {
  Scene(int edge, Precision precision, BeadScheme bead_boundary, const Communicator& communicator)
      : precision(precision),
        decomposition(Index3(edge, edge, edge * communicator.size()), communicator.size()),
        yardstick(edge, precision),
        populations(decomposition.block(communicator.rank()).size, precision),
        periodic_halo(communicator, decomposition, periodic),
        walled_halo(communicator, decomposition, walls),
        swarm(swarm_scene(edge, communicator.size(), precision, bead_boundary), communicator) {
    yardstick.choose_layout(9, communicator);
    set_uniform_flow(populations);
  }

  void step(Halo* halo) {
    const RelaxationRates rates = relaxation_rates(relaxation_time);
    if (halo == nullptr) return stream_and_collide(populations, rates);
    step_fluid(populations, *halo, rates);
  }

  Precision precision;
  Decomposition decomposition;
  StreamYardstick yardstick;
  Populations populations;
  Halo periodic_halo, walled_halo;
  CoupledSystem swarm;
};

BenchScenes::BenchScenes(int edge, const std::vector<Precision>& precisions, BeadScheme bead_boundary,
                         const Communicator& communicator) {
  for (const Precision precision : precisions) {
    Scene* scene =
        scenes_.emplace_back(std::make_unique<Scene>(edge, precision, bead_boundary, communicator)).get();
    cases_.push_back({"stream-yardstick", precision, [scene] { scene->yardstick.sweep(); }});
    cases_.push_back({"bare-sweep", precision, [scene] { scene->step(nullptr); }});
    cases_.push_back({"periodic-step", precision, [scene] { scene->step(&scene->periodic_halo); }});
    cases_.push_back({"wall-step", precision, [scene] { scene->step(&scene->walled_halo); }});
    cases_.push_back({"coupled-swarm", precision, [scene] { scene->swarm.step(); }});
  }
}

BenchScenes::~BenchScenes() = default;

std::string BenchScenes::layout_name(Precision precision) const {
  const auto scene = std::ranges::find_if(scenes_, [&](const auto& s) { return s->precision == precision; });
  return (*scene)->yardstick.layout().name;
}

double BenchScenes::bytes(int edge, const std::vector<Precision>& precisions) {
  constexpr double lattices = 3, bandwidth_arrays = 2;  // one lattice each for yardstick, fluid and swarm
  double bytes = bandwidth_arrays * sizeof(double) * Bandwidth::num_elements;
  for (const Precision precision : precisions) {
    const double bytes_per_number = static_cast<double>(bytes_per_population(precision));
    bytes += (lattices * d3q19::directions * bytes_per_number + 1) * std::pow(edge + 2, 3);
  }
  return bytes;
}

Bandwidth::Bandwidth()
    : source_(static_cast<double*>(allocate_zeros_on_huge_pages(num_elements * sizeof(double)))),
      destination_(static_cast<double*>(allocate_zeros_on_huge_pages(num_elements * sizeof(double)))) {}

void Bandwidth::copy() {
  stream_kernels().copy(source_.get(), destination_.get(), num_elements);
}

void Bandwidth::scale_in_place() {
  stream_kernels().scale_in_place(source_.get(), num_elements, 0.999);
}

}  // namespace beadswim
