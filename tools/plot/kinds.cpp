#include "kinds.hpp"

#include <array>

namespace beadswim {
namespace {

constexpr const char* records_and_predictions =
    "Run records (drawn as points) and predictions (as lines), one per file or per line; - is standard "
    "input.";
constexpr const char* trajectories =
    "Trajectories of beadswim-run: .h5md, or .h5md.part of an unfinished run.";

constexpr std::array kinds{
    PlotKind{"stroke",
             "Arm amplitudes and phase shift against the cycle, or against a driving parameter.",
             records_and_predictions,
             add_stroke_flags,
             {"beadswim-plot stroke run.json theory.json -o stroke.svg",
              "beadswim-plot stroke run.json lbm.json -o strokes.svg"}},
    PlotKind{"velocity-against-period",
             "Velocity along the swimmer's axis, relative to the mean flow, against the driving period.",
             records_and_predictions,
             add_period_flags,
             {"beadswim-plot velocity-against-period sweep.jsonl -o velocity.svg",
              "beadswim-plot velocity-against-period sweep.jsonl --method all --axes linear -o methods.svg"}},
    PlotKind{"separation",
             "Velocity along the swimmer's axis, relative to the mean flow, against l/λ, arm over radius.",
             records_and_predictions,
             add_separation_flags,
             {"for L in 15 20 30; do \\\n"
              "beadswim-layout swimmer --preset paper-single --unbounded --arm $L --jsonl; done | \\\n"
              "beadswim-theory --jsonl >arms.jsonl",
              "beadswim-plot separation arms.jsonl -o separation.svg"}},
    PlotKind{"speed-against-error",
             "Errors of velocity and stroke against core-seconds, with the front of the best.",
             "Run records, with --reference, or verdicts of beadswim-compare, one per file or per line; - is "
             "standard input.",
             add_speed_flags,
             {"beadswim-plot speed-against-error run.json lbm.json --reference theory.json -o speed.svg",
              "beadswim-plot speed-against-error verdict.json -o verdict.svg"}},
    PlotKind{"trajectories",
             "A coordinate of beads against time.",
             trajectories,
             add_trajectory_flags,
             {"beadswim-plot trajectories run.h5md -o trajectory.svg",
              "beadswim-plot trajectories run.h5md lbm.h5md --beads 1,2,3 -o trajectories.svg"}},
    PlotKind{"swarm",
             "A picture of all beads of a layout, or of one frame of a trajectory.",
             "Layout, - is standard input; or trajectory: .h5md, or .h5md.part of an unfinished run.",
             add_swarm_flags,
             {"beadswim-plot swarm swarm.json --block-swimmers 1,2,2 -o swarm.svg",
              "beadswim-plot swarm run.h5md --frame 0 --repeat 1,2,2 -o frame.svg"}},
    PlotKind{"swimmer",
             "A labelled sketch of one swimmer of a layout.",
             "Layout; - is standard input.",
             add_swimmer_flags,
             {"beadswim-plot swimmer layout.json -o swimmer.svg",
              "beadswim-plot swimmer swarm.json --swimmers 3 -o third.svg"}},
    PlotKind{"mobility-products",
             "Time of a product of mobility and forces against the number of beads.",
             "Measurements by beadswim-bench --beads --json; - is standard input.",
             add_product_flags,
             {"beadswim-plot mobility-products products.json -o products.svg",
              "beadswim-bench --beads 99,999 --json | beadswim-plot mobility-products - -o products.svg"}}};

}  // namespace

std::span<const PlotKind> plot_kinds() {
  return kinds;
}

}  // namespace beadswim
