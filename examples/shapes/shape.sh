# The steps that the examples of docs/shapes.md share. Each example reads this file, with FOLDER as its only argument; it writes to
# FOLDER (default: out/shapes/KIND):
#   layout.json          the swimmer, in the plane of x and z
#   run.json, run.h5md   six cycles with Rotne-Prager mobility, in open space without inertia
#   theory.json          predictions
#   picture.svg          the swimmer after 5.75 cycles
#   verdict.json         comparison of the velocities along the axis with rpy-ode, where this velocity is not zero
set -euo pipefail

cycles=6
frame=230   # of 240: at the end of a cycle the flagellum is nearly straight
kind=$(basename "$0" .sh)
folder=${1:-out/shapes/$kind}
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/../.." && pwd)/build/release/bin:$PATH

run_and_predict() { # FLAG...   of beadswim-layout shape
  mkdir -p "$folder"
  beadswim-layout shape "$kind" "$@" >"$folder/layout.json"
  beadswim-run "$folder/layout.json" --model rpy --cycles "$cycles" --progress none -o "$folder/run.h5md" >"$folder/run.json"
  beadswim-theory "$folder/layout.json" >"$folder/theory.json"
  beadswim-plot swarm "$folder/run.h5md" --frame "$frame" --colours types -o "$folder/picture.svg"
}

compare_velocities() { # TOLERANCE   relative
  beadswim-compare "$folder/run.json" "$folder/theory.json" --method rpy-ode --quantity velocity --tolerance "$1" >"$folder/verdict.json"
}

# Prints a number of the sixth cycle, by the run and by rpy-ode. QUANTITY: a jq expression of an object with the keys along (velocity
# along the axis), velocity, angular_velocity and period.
print_motion() { # VERB QUANTITY UNIT
  jq -r --arg kind "$kind" --arg verb "$1" --arg unit "$3" --slurpfile theory "$folder/theory.json" '
    def digits: if fabs < 1e-9 then 0 else . as $x | pow(10; 3 - ($x | fabs | log10 | floor)) as $s | ($x * $s | round) / $s end;
    .driving.period as $period
    | [(.swimmers[0].cycles[-1] | {along: .speed_along_axis, velocity, angular_velocity, $period}),
       ($theory[0].predictions[] | select(.method == "rpy-ode") | {along: .velocity, velocity: .velocity_vector, angular_velocity, $period})]
    | map('"$2"' | digits) as [$run, $predicted]
    | "\($kind) \($verb) \($run) \($unit) in a cycle (theory: \($predicted))"' "$folder/run.json"
}
