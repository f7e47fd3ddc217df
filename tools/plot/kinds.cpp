#include "kinds.hpp"

#include <array>

namespace beadswim {
namespace {

constexpr const char* records_and_predictions =
    "Run records (drawn as points) and predictions (as lines): one document a file, or one a line. "
    "One may be - for standard input.";

constexpr std::array kinds{
    PlotKind{"stroke", "Arm amplitudes and phase shift, against the cycle or the driving.",
             records_and_predictions, add_stroke_flags},
    PlotKind{"velocity-against-period",
             "Velocity along the swimmer's axis, against the mean flow along periodic axes.",
             records_and_predictions, add_period_flags},
    PlotKind{"separation",
             "Velocity along the swimmer's axis against l/λ, the beads' separation over their radius.",
             records_and_predictions, add_separation_flags},
    PlotKind{
        "speed-against-error",
        "Errors of velocity and stroke against core-seconds, with the front that none beats.",
        "Run records, with --reference, or verdicts of beadswim-compare: one document a file, or one a line. "
        "One may be - for standard input.",
        add_speed_flags},
    PlotKind{
        "trajectories", "A coordinate of beads against time.",
        "Trajectories that beadswim-run wrote: .h5md or, of a run that goes on or was killed, .h5md.part.",
        add_trajectory_flags},
    PlotKind{
        "swarm", "A picture of all beads at one frame, or as laid out.",
        "A layout, - for standard input; or a trajectory that beadswim-run wrote: .h5md or, of a run that "
        "goes on or was killed, .h5md.part.",
        add_swarm_flags},
    PlotKind{"swimmer", "A labelled sketch of one swimmer of a layout.", "A layout, - for standard input.",
             add_swimmer_flags},
    PlotKind{"mobility-products", "Time of a product of mobility and forces against the number of beads.",
             "Measurements by beadswim-bench --beads --json. One may be - for standard input.",
             add_product_flags}};

}  // namespace

std::span<const PlotKind> plot_kinds() {
  return kinds;
}

}  // namespace beadswim
