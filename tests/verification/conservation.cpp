#include <fmt/core.h>

#include "../coupling/scenes.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "cases.hpp"
#include "records.hpp"

// Measures the conservation of momentum and mass over many steps of a strongly driven swimmer in a small
// periodic box, and with levels of cells that follow it in a larger one.

namespace beadswim::verification {
namespace {

constexpr int box_edge = 24, box_edge_with_levels = 64;
constexpr int looks = 20;

double largest_speed(const CoupledSystem& system) {
  double largest = 0;
  for (const BeadMotion& motion : system.owned_swimmers()[0].motion)
    largest = std::max(largest, motion.velocity.norm());
  return largest;
}

CoupledScene scene_with(int levels, BeadScheme scheme) {
  const int edge = levels == 1 ? box_edge : box_edge_with_levels;
  const Vec3 axis = Vec3(1, 0.6180, 0.3820).normalized();
  CoupledScene scene =
      test::small_swimmer(Index3::Constant(edge), Vec3(-0.7, 0.2, 0.6) + Vec3::Constant(edge / 2), axis);
  scene.bead_boundary = scheme;
  if (levels > 1) scene.levels = levels_around(scene, bead_extent(scene), levels).value();
  return scene;
}

void measure(int levels, int steps, BeadScheme scheme, const Emit& emit) {
  const Communicator self(MPI_COMM_SELF);
  const CoupledScene scene = scene_with(levels, scheme);
  auto system = std::make_unique<CoupledSystem>(scene, self);
  int moves = 0;
  const double bead = mass(scene.types[0].beads[0]);
  double momentum = 0, mean_flow = 0, excess = 0, fastest = 0;
  for (int look = 1; look <= looks; ++look) {
    for (int n = 0; n < steps / looks; ++n) {
      system->step();
      fastest = std::max(fastest, largest_speed(*system));
      if (auto moved = with_levels_around_beads(*system, self)) {
        system = std::move(moved);
        ++moves;
      }
    }
    const SceneTotals totals = system->totals();
    momentum = std::max(momentum, totals.momentum.norm());
    mean_flow = std::max(mean_flow, totals.mean_flow.norm());
    excess = std::max(excess, std::abs(totals.mass_excess));
  }
  const Vec3 way = system->owned_swimmers()[0].motion[1].position - scene.swimmers[0].position;
  emit({{"case", "conservation"},
        {"scheme", to_text(scheme)},
        {"tau", scene.relaxation_time},
        {"levels", levels},
        {"moves", moves},
        {"steps", steps},
        {"fastest_bead", fastest},
        {"way", way.norm()},
        {"reference", 0},
        {"measured", momentum},
        {"error", momentum / (bead * fastest)},
        {"mean_flow", mean_flow},
        {"mass_excess", excess}});
}

template <const char* key>
std::string print_value(const Json& record) {
  return fmt::format("{:.0e}", record[key].get<double>());
}
constexpr char relative_momentum[] = "error", mean_flow[] = "mean_flow", relative_mass[] = "mass_excess";

}  // namespace

void measure_conservation(BeadScheme scheme, Extent extent, const Emit& emit) {
  for (const int levels : {1, 2}) measure(levels, extent == Extent::brief ? 1000 : 100000, scheme, emit);
}

Law conservation_law() {
  return {
      .title = "Momentum and mass",
      .claim =
          "A strongly driven swimmer and its fluid (24³ cells; with [levels of cells](refinement.md) that "
          "follow it, 64³ of the smaller cells) keep their momentum and mass for 100,000 steps",
      .reference = "0 to roundoff; the mean flow is not conserved exactly",
      .test = "1000 steps, momentum",
      .quantity = "Largest value",
      .rows = {{"momentum / (bead mass × largest bead speed)",
                {{"levels", 1}},
                print_value<relative_momentum>},
               {"mass change / mass of the box", {{"levels", 1}}, print_value<relative_mass>},
               {"mean flow [cell/step]", {{"levels", 1}}, print_value<mean_flow>},
               {"momentum, two levels", {{"levels", 2}}, print_value<relative_momentum>},
               {"mass change, two levels", {{"levels", 2}}, print_value<relative_mass>}},
  };
}

}  // namespace beadswim::verification
