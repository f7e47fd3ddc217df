#!/bin/bash
# Runs the swimmers of docs/shapes.md in open space without inertia, and predicts their motion.
#   examples/shapes.sh [FOLDER [KIND...]]   writes for each kind (default: all) to FOLDER/KIND (default: out/shapes/KIND):
#     layout.json            the swimmer, in the plane of x and z
#     run.json, run.h5md     six cycles with Rotne-Prager mobility
#     theory.json            predictions
#     verdict.json           comparison of the velocities along the axis with rpy-ode. Dumbbell, triangle and chain have no
#                            verdict: this velocity is zero, so it has no relative error. The dumbbell does not move, the
#                            triangle rotates, and the chain settles across its axis.
#     picture.svg            the swimmer after 5.75 cycles
# Then prints for each kind its motion in the sixth cycle, by the run and by rpy-ode. All kinds take ten seconds.
set -euo pipefail

cycles=6
frame=230   # of 240: at the end of a cycle the flagellum is nearly straight

out=${1:-out/shapes}
shift "$(($# > 0))"
[ "$#" -gt 0 ] || set -- dumbbell triangle prescribed-three-bead purcell-chain flagellum sphere chain
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH

flags_of() { # KIND   of beadswim-layout shape
  case $1 in
    triangle | purcell-chain | flagellum) echo --orientation 1,1,0,0 ;;   # turns the y axis of the type onto z
    chain) echo --direction 0,0,-1 ;;
  esac
}

tolerance_of() { # KIND   largest relative error of the velocity; empty: no verdict
  case $1 in
    prescribed-three-bead | purcell-chain | sphere) echo 0.001 ;;
    flagellum) echo 0.01 ;;   # after six cycles, it still turns slowly into its final orientation
  esac
}

# The motion in a cycle, from an object with the keys along (velocity along the axis), velocity, angular_velocity and period.
motion_of() { # KIND   jq expression
  case $1 in
    triangle) echo '"rotates by", -.angular_velocity[1] * .period * 180 / 3.14159265, "degrees about -y"' ;;
    chain) echo '"settles by", -.velocity[2] * .period, "along -z"' ;;
    *) echo '"moves by", .along * .period, "along its axis"' ;;
  esac
}

for kind; do
  folder=$out/$kind
  mkdir -p "$folder"
  # shellcheck disable=SC2046  # flags
  beadswim-layout shape "$kind" $(flags_of "$kind") >"$folder/layout.json"
  beadswim-run "$folder/layout.json" --model rpy --cycles "$cycles" --progress none -o "$folder/run.h5md" >"$folder/run.json"
  beadswim-theory "$folder/layout.json" >"$folder/theory.json"
  tolerance=$(tolerance_of "$kind")
  if [ -n "$tolerance" ]; then
    beadswim-compare "$folder/run.json" "$folder/theory.json" --method rpy-ode --quantity velocity --tolerance "$tolerance" \
      >"$folder/verdict.json"
  fi
  beadswim-plot swarm "$folder/run.h5md" --frame "$frame" --colours types -o "$folder/picture.svg"
done

for kind; do
  jq -r --arg kind "$kind" --slurpfile theory "$out/$kind/theory.json" '
    def digits: if fabs < 1e-9 then 0 else . as $x | pow(10; 3 - ($x | fabs | log10 | floor)) as $s | ($x * $s | round) / $s end;
    .driving.period as $period
    | [(.swimmers[0].cycles[-1] | {along: .speed_along_axis, velocity, angular_velocity, $period}),
       ($theory[0].predictions[] | select(.method == "rpy-ode") | {along: .velocity, velocity: .velocity_vector, angular_velocity, $period})]
    | map(['"$(motion_of "$kind")"']) as [[$verb, $run, $how], [$_, $predicted]]
    | "\($kind) \($verb) \($run | digits) \($how) in a cycle (theory: \($predicted | digits))"' "$out/$kind/run.json"
done
