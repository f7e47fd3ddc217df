#include "kinds.hpp"

#include <array>

namespace beadswim {
namespace {

constexpr const char* records_and_predictions =
    "Run records (drawn as points) and predictions (drawn as lines), one document per file or one per line; "
    "- is standard input.";
constexpr const char* trajectories =
    "Trajectory files of beadswim-run (.h5md), or the files of unfinished runs (.h5md.part).";

constexpr std::array kinds{
    PlotKind{"stroke",
             "Draws arm amplitudes and phase shift against the cycle, or against a driving parameter.",
             records_and_predictions,
             add_stroke_flags,
             {"beadswim-plot stroke run.json theory.json -o stroke.svg",
              "beadswim-plot stroke run.json lbm.json -o strokes.svg"}},
    PlotKind{"velocity-against-period",
             "Draws the velocity along the swimmer's axis, minus mean flow, against the driving period.",
             records_and_predictions,
             add_period_flags,
             {"beadswim-plot velocity-against-period study.jsonl -o velocity.svg",
              "beadswim-plot velocity-against-period study.jsonl --method all --axes linear -o methods.svg"}},
    PlotKind{
        "against",
        "Draws a result of a study against a quantity that beadswim-layout vary has varied.",
        records_and_predictions,
        add_against_flags,
        {"beadswim-layout swimmer --preset paper-single --unbounded | \\\n"
         "beadswim-layout vary --over stiffness=0.01:0.1:9:log --over phase=45deg,90deg | \\\n"
         "beadswim-theory --method rpy-ode >stiffness.jsonl",
         "beadswim-plot against stiffness.jsonl --x stiffness --group-by phase --log x -o stiffness.svg"}},
    PlotKind{"separation",
             "Draws the velocity along the axis, minus mean flow, against arm length over bead radius.",
             records_and_predictions,
             add_separation_flags,
             {"for L in 15 20 30; do \\\n"
              "beadswim-layout swimmer --preset paper-single --unbounded --arm $L --jsonl; done | \\\n"
              "beadswim-theory --jsonl >arms.jsonl",
              "beadswim-plot separation arms.jsonl -o separation.svg"}},
    PlotKind{"speed-against-error",
             "Draws the errors of velocity and arm amplitudes against the cost of runs in core-seconds.",
             "Run records (with --reference) or verdicts of beadswim-compare, one document per file or one "
             "per line; - is standard input.",
             add_speed_flags,
             {"beadswim-plot speed-against-error run.json lbm.json --reference theory.json -o speed.svg",
              "beadswim-plot speed-against-error verdict.json -o verdict.svg"}},
    PlotKind{"trajectories",
             "Draws one coordinate of beads against time, or against the angle of the swimmer's axis.",
             trajectories,
             add_trajectory_flags,
             {"beadswim-plot trajectories run.h5md -o trajectory.svg",
              "beadswim-plot trajectories run.h5md --along z --against angle -o heights.svg"}},
    PlotKind{"swarm",
             "Draws all beads and bonds of a layout, or of one frame of a trajectory.",
             "Layout file (- is standard input), trajectory file (.h5md), or file of an unfinished run "
             "(.h5md.part).",
             add_swarm_flags,
             {"beadswim-plot swarm swarm.json --block-swimmers 1,2,2 -o swarm.svg",
              "beadswim-plot swarm run.h5md --frame 0 --repeat 1,2,2 -o frame.svg"}},
    PlotKind{"swimmer",
             "Draws a labelled sketch of one three-bead swimmer of a layout.",
             "Layout file (JSON); - is standard input.",
             add_swimmer_flags,
             {"beadswim-plot swimmer layout.json -o swimmer.svg",
              "beadswim-plot swimmer swarm.json --swimmers 3 -o third.svg"}},
    PlotKind{"mobility-products",
             "Draws the time of mobility products (velocities from forces) against the number of beads.",
             "Results of beadswim-bench --beads --json; - is standard input.",
             add_product_flags,
             {"beadswim-plot mobility-products products.json -o products.svg",
              "beadswim-bench --beads 99,999 --json | beadswim-plot mobility-products - -o products.svg"}}};

}  // namespace

std::span<const PlotKind> plot_kinds() {
  return kinds;
}

}  // namespace beadswim
