#!/bin/bash
# Runs scenes that are difficult to simulate and prints their outcomes as JSON lines, of which hard-cases.jq makes the table of
# docs/hard-cases.md.
#   docs/results/hard-cases.sh [GROUP...] > hard-cases.jsonl     (half an hour on one core; the programs on PATH)
# A line contains group, case, flags, exit status, status, reason and last cycle of the run, and the reference: a run of the scene
# at other settings, or a prediction.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Writes the layout of the paper's swimmer in the middle of a small box with T = 2000, A = 0.2, unless FLAGS state other values.
swimmer() { # FLAGS...
  local usual=()
  [[ " $* " == *" --box "* ]] || usual+=(--box 60,40,40)
  [[ " $* " == *" --period "* ]] || usual+=(--period 2000)
  [[ " $* " == *" --amplitude "* ]] || usual+=(--amplitude 0.2)
  beadswim-layout swimmer --preset paper-single --boundary periodic "${usual[@]}" "$@" |
    if [[ " $* " == *" --position "* ]]; then cat; else jq '.swimmers[0].position[1:] = (.domain.lengths[1:] | map(. / 2))'; fi \
      >"$work/layout.json"
}

# Runs two cycles of the layout that `swimmer` wrote last, and prints the outcome as a JSON object.
simulate() { # FLAGS...
  local status=0 cycles=(--cycles 2)
  [[ " $* " == *" --cycles "* ]] && cycles=()
  : >"$work/out"
  beadswim-run "$work/layout.json" -o "$work/run.h5md" "${cycles[@]}" --progress none "$@" >"$work/out" 2>"$work/err" \
    </dev/null || status=$?
  jq -n --argjson exit "$status" --arg flags "$*" --rawfile err "$work/err" --slurpfile run "$work/out" \
    '{flags: $flags, exit: $exit, status: ($run[0].status // "refused"),
      reason: ($run[0].reason // if $exit == 0 then "" else ($err | split("\n") | map(select(startswith("beadswim-run: "))) | last) end),
      warned: ($err | test("warning")),
      cycle: ($run[0].swimmers[0].cycles[-1] // null), mach: $run[0].dimensionless.mach,
      gap: $run[0].near_contact.smallest_gap, momentum: ($run[0].momentum.total // [] | map(fabs) | max),
      steps: $run[0].resolution.steps_per_cycle, density: $run[0].resolution.density_on_lattice,
      state: $run[0].state_sha256, seconds: $run[0].cost.core_seconds}'
}

# Prints what --plan states about the run of `simulate`: the reason for a rejection, or the expected errors.
planned() { # FLAGS...
  local time=(--relaxation-time 1.5) flags=()
  [[ " $* " == *" --relaxation-time "* ]] && time=()
  [[ " $* " == *" --cycles "* ]] || flags+=(--cycles 2)
  beadswim-run "$work/layout.json" --plan --model lbm --precision double "${time[@]}" "${flags[@]}" "$@" 2>/dev/null |
    jq -c '.runs[0] | {refused, error}'
}

# Prints a line of results. $work/reference contains the run or prediction for comparison, or null.
row() { # GROUP CASE FLAGS...
  local group=$1 name=$2
  shift 2
  (planned "$@" || true) >"$work/plan"
  simulate "$@" | jq -c --arg group "$group" --arg case "$name" --slurpfile reference "$work/reference" --slurpfile plan "$work/plan" \
    '{group: $group, case: $case} + . + {reference: $reference[0], plan: $plan[0]}'
}
no_reference() { echo null >"$work/reference"; }
reference_run() { # FLAGS...
  simulate "$@" >"$work/reference"
}
reference_theory() { # arm amplitudes and velocity by the method inertia-corrected
  beadswim-theory "$work/layout.json" --method inertia-corrected |
    jq '.predictions[0] | {cycle: {arm_amplitudes, speed_along_axis: .velocity}}' >"$work/reference"
}

relaxation_time() {
  swimmer
  reference_run --cells-per-radius 4 --relaxation-time 1
  for tau in 0.505 0.51 0.52 0.55 0.6 0.8 1 1.5 2 3 4 6 10; do
    row "relaxation time" "τ = $tau" --cells-per-radius 2 --relaxation-time $tau
  done
  for tau in 0.505 0.51; do
    row "relaxation time" "τ = $tau, psm" --cells-per-radius 2 --relaxation-time $tau --bead-boundary psm
  done
}

density() {
  for density in 0.1 0.3 1 3 10 30 100; do
    swimmer --bead-density $density
    reference_run --cells-per-radius 4 --relaxation-time 1
    row "bead density" "$density times the fluid's" --cells-per-radius 2
    row "bead density" "$density, τ = 0.6" --cells-per-radius 2 --relaxation-time 0.6
  done
}

springs() {
  for factor in 1e2 1e4 1e6 1e8; do
    swimmer --stiffness "$(jq -nr "0.0347 * $factor")"
    reference_theory
    row "springs" "stiffness times $factor" --cells-per-radius 2
  done
  no_reference
  swimmer --stiffness 1e9
  row "springs" "stiffness 1e9" --cells-per-radius 2
  swimmer --damping 1e3
  reference_theory
  row "springs" "dashpots of 1000" --cells-per-radius 2
  no_reference
  swimmer --stiffness 1e-6 --amplitude 0.5
  row "springs" "none to speak of" --cells-per-radius 2
  oblique() { swimmer --box 60,60,60 --axis 1,1,0.3 --angular-stiffness "$(jq -nr "138.8 * $1")"; } # bending matters
  oblique 1
  reference_run --cells-per-radius 4
  for factor in 1 10 30 1e2 1e3 1e4 1e6; do
    oblique $factor
    row "springs" "angular spring times $factor, oblique" --cells-per-radius 2
  done
}

collisions() {
  for amplitude in 0.4 0.6 0.8 1.2; do
    swimmer --amplitude $amplitude
    reference_run --cells-per-radius 4
    row "driving" "A = $amplitude" --cells-per-radius 2
  done
  for amplitude in 5 10; do
    swimmer --stiffness 0.5 --amplitude $amplitude
    reference_run --cells-per-radius 4
    row "driving" "stiffness 0.5, A = $amplitude" --cells-per-radius 2
  done
  no_reference
  for scheme in staircase cli psm; do
    swimmer --stiffness 0.5 --amplitude 10
    row "driving" "stiffness 0.5, A = 10, $scheme" --cells-per-radius 2 --bead-boundary $scheme
  done
  row "driving" "stiffness 0.5, A = 10, --lubrication off" --cells-per-radius 2 --lubrication off
}

speed() {
  no_reference
  for amplitude in 10 15 20 40 1e6; do
    swimmer --period 200 --amplitude $amplitude --stiffness 2
    row "speed" "A = $amplitude, T = 200" --cells-per-radius 4
  done
}

small_beads() {
  for cells in 1 1.5; do
    swimmer --box 64,40,40
    reference_run --cells-per-radius 4
    for scheme in mr cli psm staircase; do
      row "small beads" "$cells cells a radius, $scheme" --cells-per-radius $cells --bead-boundary $scheme
    done
  done
}

contact_at_start() {
  swimmer --arm 9
  reference_theory
  for cells in 2 3 4 6; do row "contact at the start" "gaps of R/4, $cells cells a radius" --cells-per-radius $cells; done
  for arm in 8.4 8.0001; do
    swimmer --arm $arm
    reference_run --cells-per-radius 6
    for cells in 2 4; do
      row "contact at the start" "gaps of $(jq -nr "($arm - 8) / 4 * 1e6 | round / 1e6") R, $cells cells a radius" \
        --cells-per-radius $cells
    done
  done
}

places() {
  local cube=(--box 60,60,60 --frame initial-axis) centre=(--position 30,30,30) corner=(--position 0.1,59.9,0.2)
  local along_x=(--axis 1,0,0) diagonal=(--axis 1,-1,1)
  place() { # CASE LAYOUT-FLAGS...
    local name=$1
    shift
    swimmer "${cube[@]}" "$@"
    reference_run --cells-per-radius 4
    row "places" "$name" --cells-per-radius 2
  }
  place "along x, in the middle" "${along_x[@]}" "${centre[@]}"
  place "along x, across the box's corner" "${along_x[@]}" "${corner[@]}"
  place "along a diagonal" "${diagonal[@]}" "${centre[@]}"
  place "along a diagonal, across the corner" "${diagonal[@]}" "${corner[@]}"
}

narrow_box() {
  swimmer --box 60,12,12
  reference_run --cells-per-radius 8
  for cells in 2 3 4; do row "narrow box" "12 wide, $cells cells a radius" --cells-per-radius $cells; done
  swimmer --box 60,10,10
  reference_run --cells-per-radius 8
  for cells in 2 4; do row "narrow box" "10 wide, $cells cells a radius" --cells-per-radius $cells; done
}

rest() {
  no_reference
  for scheme in mr cli psm staircase; do
    swimmer --radius 1.5 --arm 6 --box 24,8,8 --amplitude 0 --period 10000
    row "rest" "10^6 steps, $scheme" --cells-per-radius 1.5 --cycles 100 --frames-per-cycle 4 --bead-boundary $scheme
  done
}

turning_over() { # forces compress the swimmer for half a period, so it turns over
  no_reference
  for cells in 2 3; do
    swimmer --box 64,64,40 --amplitude 0.6 --stiffness 0.2 --phase 3.14159265358979 --period 40000 \
      --axis 0.9998000199980002,0.01999600119960014,0
    row "turning over" "$cells cells a radius" --cells-per-radius $cells --cycles 1
  done
}

levels_of_cells() { # compared with cells of one size
  refined() { # CASE FLAGS...
    local name=$1
    shift
    reference_run "$@"
    row "levels of cells" "$name" --refine 1 "$@"
  }
  swimmer --box 120,80,80
  for tau in 0.52 0.6 1 2 4; do refined "τ = $tau" --cells-per-radius 2 --relaxation-time $tau; done
  for tau in 0.505 0.51; do
    refined "τ = $tau, psm" --cells-per-radius 2 --relaxation-time $tau --bead-boundary psm
  done
  for density in 0.1 100; do
    swimmer --box 120,80,80 --bead-density $density
    refined "$density times the fluid's" --cells-per-radius 2
  done
  swimmer --box 120,80,80 --amplitude 0.8
  refined "A = 0.8" --cells-per-radius 2
  swimmer --box 120,80,80 --stiffness 0.5 --amplitude 5
  for scheme in mr staircase cli psm; do
    refined "stiffness 0.5, A = 5, $scheme" --cells-per-radius 2 --bead-boundary $scheme
  done
  for amplitude in 10 15 20; do
    swimmer --box 120,80,80 --period 200 --stiffness 2 --amplitude $amplitude
    refined "A = $amplitude, T = 200" --cells-per-radius 4
  done
}

groups=("$@")
[ ${#groups[@]} -gt 0 ] ||
  groups=(relaxation_time density springs collisions speed small_beads contact_at_start places narrow_box rest turning_over levels_of_cells)
for group in "${groups[@]}"; do $group; done
