#include <fmt/format.h>

#include "../coupling/scenes.hpp"
#include "cases.hpp"
#include "records.hpp"

// Momentum and mass of a strongly driven swimmer in a small periodic box, over many steps.

namespace beadswim::verification {
namespace {

constexpr int box_edge = 24;
constexpr int looks = 20;

double bead_momentum(const CoupledSystem& system) {
  double largest = 0;
  for (const BeadMotion& motion : system.owned_swimmers()[0].motion)
    largest = std::max(largest, motion.velocity.norm());
  return largest;
}

void measure(int steps, BeadScheme scheme, const Emit& emit) {
  const Communicator self(MPI_COMM_SELF);
  const Vec3 axis = Vec3(1, 0.6180, 0.3820).normalized();
  CoupledScene scene = test::small_swimmer(Index3::Constant(box_edge), Vec3(11.3, 12.2, 12.6), axis);
  scene.bead_boundary = scheme;
  CoupledSystem system(scene, self);
  const double bead = mass(scene.types[0].beads[0]);
  double momentum = 0, mean_flow = 0, excess = 0, fastest = 0;
  for (int look = 1; look <= looks; ++look) {
    for (int n = 0; n < steps / looks; ++n) {
      system.step();
      fastest = std::max(fastest, bead_momentum(system));
    }
    const SceneTotals totals = system.totals();
    momentum = std::max(momentum, totals.momentum.norm());
    mean_flow = std::max(mean_flow, totals.mean_flow.norm());
    excess = std::max(excess, std::abs(totals.mass_excess));
  }
  const Vec3 way = system.owned_swimmers()[0].motion[1].position - scene.swimmers[0].position;
  emit({{"case", "conservation"},
        {"scheme", to_text(scheme)},
        {"tau", scene.relaxation_time},
        {"steps", steps},
        {"fastest_bead", fastest},
        {"way", way.norm()},
        {"reference", 0},
        {"measured", momentum},
        {"error", momentum / (bead * fastest)},
        {"mean_flow", mean_flow},
        {"mass_excess", excess}});
}

}  // namespace

void measure_conservation(BeadScheme scheme, Extent extent, const Emit& emit) {
  measure(extent == Extent::brief ? 1000 : 100000, scheme, emit);
}

std::string report_conservation(const std::vector<Json>& records) {
  std::string text =
      "## Momentum and mass of a swimmer and its fluid\n\n"
      "A strongly driven swimmer (beads of 4.4 cells, arms of 7) aslant in a periodic box of 24³ cells, all "
      "of "
      "it started at rest. Greatest of 20 looks over the run. Momentum: of fluid, beads, and what is under "
      "way "
      "between them, over a bead's mass times its greatest speed; mean flow [cell/step]; mass: of fluid and "
      "what "
      "beads hold of it, over the box's. Nothing but roundoff should show in momentum and mass. The mean "
      "flow is "
      "not conserved to roundoff: half of a step's impulse is under way, and beads weigh what their true "
      "volume "
      "does, not that of the cells that they cover.\n\n";
  text += table_head("scheme", {"steps", "greatest speed", "way of bead 2", "momentum", "mean flow", "mass"});
  for (const Json& r : records) {
    text += fmt::format("| {} | {} | {:.3f} | {:.2f} cells | {:.1e} | {:.1e} | {:.1e} |\n",
                        r["scheme"].get<std::string>(), r["steps"].get<int>(),
                        r["fastest_bead"].get<double>(), r["way"].get<double>(), r["error"].get<double>(),
                        r["mean_flow"].get<double>(), r["mass_excess"].get<double>());
  }
  return text;
}

}  // namespace beadswim::verification
