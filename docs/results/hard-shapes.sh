#!/bin/bash
# Runs difficult scenes of mobility models, shapes, walls and flow, and prints their outcomes as JSON lines, of which hard-shapes.jq
# makes the table of docs/hard-cases.md.
#   docs/results/hard-shapes.sh [GROUP...] > hard-shapes.jsonl     (the programs on PATH)
# A line contains group, case, flags, exit status, reason, warnings and last cycle of the run, and the reference: a prediction, or a
# run with finer steps, another model or another orientation.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

layout() { # LAYOUT-COMMAND FLAGS...   a refused layout leaves its reason
  : >"$work/layout.json"
  beadswim-layout "$@" >"$work/layout.json" 2>"$work/refused" || true
}
swimmer() {
  local usual=()
  [[ " $* " == *" --period "* ]] || usual+=(--period 2000)
  [[ " $* " == *" --amplitude "* ]] || usual+=(--amplitude 0.2)
  layout swimmer --preset paper-single "${usual[@]}" "$@"
}
free() { swimmer --unbounded "$@"; }

simulate() { # FLAGS...   prints the outcome as a JSON object
  local status=0
  : >"$work/out"
  if [ -s "$work/layout.json" ]; then
    timeout 600 beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
  else
    cp "$work/refused" "$work/err"
    status=2
  fi
  jq -n --argjson exit "$status" --arg flags "$*" --arg folder "$work/" --rawfile err "$work/err" --slurpfile run "$work/out" \
    '{flags: $flags, exit: $exit, status: ($run[0].status // if $exit == 2 then "refused" else "failed" end),
      reason: ($run[0].reason // if $exit == 0 then "" else ($err | split("\n") | map(select(startswith("beadswim-"))) | last // "no message of its own: \($err[-300:])") end | split($folder) | join("")),
      warned: ($err | test("warning")),
      cycle: ($run[0].swimmers[0].cycles[-1] // null | if . then {velocity: ([.velocity, .mean_flow // [0, 0, 0]] | transpose | map(.[0] - .[1])),
        arm_amplitudes, angular_velocity} else null end),
      seconds: $run[0].cost.core_seconds}'
}
run_as_reference() { # DESCRIPTION FLAGS...
  local description=$1
  shift
  simulate "$@" | jq --arg description "$description" '{description: $description, cycle, reason}' >"$work/reference"
}
predict() { # METHOD
  beadswim-theory "$work/layout.json" --method "$1" 2>/dev/null | jq --arg method "$1" '.predictions[0] |
    {description: $method, cycle: {velocity: (.velocity_vector // [.velocity, 0, 0]), arm_amplitudes, angular_velocity}}' \
    >"$work/reference" || echo null >"$work/reference"
}
no_reference() { echo null >"$work/reference"; }

row() { # GROUP CASE FLAGS...
  local group=$1 name=$2
  shift 2
  simulate "$@" | jq -c --arg group "$group" --arg case "$name" --slurpfile reference "$work/reference" \
    '{group: $group, case: $case} + . + {reference: $reference[0]}'
}
# Compares a run with the same run with eight times as many steps.
row_by_steps() { # GROUP CASE FLAGS...
  run_as_reference "8 times as many steps" "${@:3}" --steps-per-cycle 960
  row "$@"
}

springs() {
  for factor in 1e4 1e8; do
    free --stiffness "$(jq -nr "0.0347 * $factor")"
    for pair in "oseen oseen-ode" "rpy rpy-ode" "rpy+near multipole-ode"; do
      predict "${pair#* }"
      row springs "$factor times the preset's stiffness" --model "${pair% *}" --cycles 2
    done
  done
  free --stiffness 1e-6
  row_by_steps springs "stiffness 1e-6" --model rpy --cycles 3
  free --damping 1e4
  row_by_steps springs "dashpots of 1e4" --model rpy --cycles 3
}

close_beads() {
  free --arm 8.4 --amplitude 0.002
  predict multipole-ode
  row "close beads" "gaps of 0.1 radii" --model rpy+near --cycles 40
  for order in 1 2; do row "close beads" "gaps of 0.1 radii" --model multipole --multipole-order $order --cycles 40; done
  for arm in 8.04 8.004; do
    free --arm $arm --amplitude 0.002
    row_by_steps "close beads" "gaps of $(jq -nr "($arm - 8) / 4 * 1e4 | round / 1e4") radii" --model rpy+near --cycles 80
  done
  free --arm 8 --amplitude 0.002
  no_reference
  row "close beads" "touching beads" --model rpy+near --cycles 2
  free --arm 7.9
  row "close beads" "overlapping beads" --model rpy --cycles 2
  free --radius 1,4,1 --arm 10
  predict multipole-ode
  for order in 0 1 2; do row "close beads" "radii 1, 4, 1" --model multipole --multipole-order $order --cycles 3; done
  row "close beads" "radii 1, 4, 1" --model rpy+near --cycles 3
}

collisions() {
  free --amplitude 1.5
  row_by_steps collisions "amplitude 1.5" --model rpy --cycles 3
  row_by_steps collisions "amplitude 1.5" --model multipole --cycles 3
  swimmer --amplitude 1.5 --box 64,40,40 --boundary periodic
  row_by_steps collisions "amplitude 1.5, box" --model unsteady --cycles 3
  free --stiffness 0.5 --amplitude 10
  row_by_steps collisions "stiffness 0.5, A = 10" --model rpy --cycles 3
  layout shape purcell-chain --amplitude 2.8
  row_by_steps collisions "Purcell's chain folds onto itself" --model rpy --cycles 2
}

flexible() {
  layout shape flagellum --sperm-number 10 --unbounded
  predict rpy-ode
  row flexible "flagellum, sperm number 10" --model rpy --cycles 16
  for sperm in 0.1 1 30; do
    layout shape flagellum --sperm-number $sperm --unbounded
    row_by_steps flexible "flagellum, sperm number $sperm" --model rpy --cycles 2
  done
  layout shape flagellum --beads 64 --unbounded
  row_by_steps flexible "flagellum of 64 beads" --model rpy --cycles 1
  layout shape flagellum --unbounded
  jq '(.types[].driving.forces[].harmonics[].amplitude) *= 10' "$work/layout.json" >"$work/stronger" && mv "$work/stronger" "$work/layout.json"
  row_by_steps flexible "flagellum, 10 times the default force" --model rpy --cycles 2
  layout shape chain --unbounded --angular-stiffness 1
  row_by_steps flexible "soft chain bends into a hairpin" --model rpy --cycles 5
  layout shape chain --unbounded --beads 64 --force 100
  row_by_steps flexible "chain of 64 beads, force 100" --model rpy --cycles 1
}

inertia() {
  for density in 0.1 100; do
    swimmer --bead-density $density --box 64,40,40 --boundary periodic
    predict inertia-corrected
    row inertia "bead density $density" --model unsteady --multipole-order 2 --cycles 6
  done
  for period in 30 300 3e4; do
    swimmer --period $period --box 64,40,40 --boundary periodic
    predict inertia-corrected
    row inertia "period $period" --model unsteady --multipole-order 2 --cycles 6
  done
  swimmer --period 1e6 --box 64,40,40 --boundary periodic
  no_reference
  row inertia "compressed for half of a period of 1e6" --model unsteady --cycles 1
  swimmer --box 56,16,16 --boundary periodic
  row inertia "box of 4 radii across" --model unsteady --cycles 2
}

walls() {
  for height in 4.4 4.004; do
    layout shape sphere --force 0.01 --amplitude 0 --direction 1,0,0 --half-space z --position 0,0,$height
    run_as_reference "order 2" --model multipole --multipole-order 2 --cycles 1
    for model in rpy "multipole --multipole-order 1"; do
      # shellcheck disable=SC2086  # flags
      row walls "sphere, gap of $(jq -nr "$height / 4 - 1 | . * 1e4 | round / 1e4") radii, along the wall" --model $model --cycles 1
    done
  done
  layout shape sphere --force 1 --amplitude 0 --direction=0,0,-1 --half-space z --position 0,0,12
  row_by_steps walls "sphere is pushed into the wall" --model rpy --cycles 3
  layout shape sphere --half-space z --position 0,0,3.9
  no_reference
  row walls "bead in the wall" --model rpy --cycles 1
  swimmer --half-space z --position 0,0,30 --axis=1,0,-1 --amplitude 1
  row_by_steps walls "swimmer dives at the wall" --model rpy --cycles 40
  swimmer --half-space z --position 0,0,12
  no_reference
  row walls "half-space" --model lbm --cycles 1
  row walls "half-space" --model unsteady --cycles 1
}

flow() {
  flowing() { # RATE   adds the velocity RATE z along x
    jq --argjson rate "$1" '.flow = {velocity_gradient: [[0, 0, $rate], [0, 0, 0], [0, 0, 0]]}' "$work/layout.json" >"$work/sheared" &&
      mv "$work/sheared" "$work/layout.json"
  }
  layout shape dumbbell --unbounded --amplitude 0
  flowing 0.01
  row_by_steps flow "dumbbell turns four times a cycle" --model rpy --cycles 1
  layout shape flagellum --unbounded
  flowing 0.01
  row_by_steps flow "flagellum tumbles in strong shear" --model rpy --cycles 1
  free
  jq '.flow = {velocity_gradient: [[1, 0, 0], [0, 0, 0], [0, 0, 0]]}' "$work/layout.json" >"$work/sheared" && mv "$work/sheared" "$work/layout.json"
  no_reference
  row flow "gradient with trace" --model rpy --cycles 1
  swimmer --box 64,40,40 --boundary periodic,periodic,no-slip
  jq '.domain.boundary[2] = {"no-slip": {"lower_velocity": [0, 0, 0], "upper_velocity": [0.5, 0, 0]}}' "$work/layout.json" >"$work/sheared" && mv "$work/sheared" "$work/layout.json"
  row flow "wall moves half a cell per step" --model lbm --cells-per-radius 4 --cycles 0.5
  row flow "moving walls" --model rpy --cycles 1
}

lattice() { # compared with the model unsteady
  shape() { # CASE LAYOUT-FLAGS...
    local name=$1
    shift
    layout shape "$@" --boundary periodic
    run_as_reference "\`unsteady\`, order 2" --model unsteady --multipole-order 2 --cycles 3
    row lattice "$name" --model lbm --cells-per-radius 3 --relaxation-time 1 --cycles 3
  }
  shape "flagellum across the corner of the box" flagellum --beads 6 --box 72,48,48 --position 71,47,1 --axis 1,1,1
  shape "triangle" triangle --box 64,64,48 --position 1,63,47
  shape "Purcell's chain" purcell-chain --box 96,80,48
  shape "soft chain" chain --beads 4 --box 48,64,48 --angular-stiffness 1
}

groups=("$@")
[ ${#groups[@]} -gt 0 ] || groups=(springs close_beads collisions flexible inertia walls flow lattice)
for group in "${groups[@]}"; do $group; done
