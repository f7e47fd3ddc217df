#!/bin/bash
# Compares errors and costs that `beadswim-run --plan` expects with measured errors and costs, in swarms.
#   docs/results/plan-check.sh [SCENE...] > plan-check.jsonl     (a quarter of an hour on one core; the programs on PATH)
# Prints one line per scene: its dimensionless numbers, the runs that were made with expected and measured error and cost, and
# the plan's choices for tolerances of 10, 3 and 1 %. Measured errors of velocity and arm amplitudes are relative to the run with
# the smallest expected error below 50 core-seconds; with several swimmers they are root mean squares.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
wanted=("$@")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

simulate() { # FLAGS...   prints the record, or nothing if the run stops
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles "$cycles" --progress none "$@" </dev/null 2>/dev/null || true
}

# Velocity and arm amplitudes of each swimmer in the last cycle. In periodic boxes the velocity is relative to the mean flow.
numbers='def numbers: [.swimmers[] | .cycles[-1] as $c
    | [$c.speed_along_axis - (if $periodic then ($c.mean_flow // [0])[0] else 0 end)] + $c.arm_amplitudes];
  def rms: (map(. * .) | add / length | sqrt);
  def errors($r): [numbers, $r] | transpose | map([transpose[] | .[0] / .[1] - 1]) | transpose | map(rms);'

scene() { # NAME CYCLES   standard input: layout
  [[ ${#wanted[@]} == 0 || " ${wanted[*]} " == *" $1 "* ]] || { cat >"$work/unused"; return; }
  local periodic
  cycles=$2
  cat >"$work/layout.json"
  periodic=$(jq '.domain.boundary[0] == "periodic"' "$work/layout.json")
  beadswim-layout check --json "$work/layout.json" >"$work/check.json"
  beadswim-run "$work/layout.json" --plan --cycles "$cycles" >"$work/plan.json" 2>/dev/null || true
  local best
  best=$(jq -r '[.runs[] | select(.refused == null and .model == "lbm" and .cost.core_seconds < 50)]
    | min_by(.error.velocity).flags' "$work/plan.json")
  # shellcheck disable=SC2086  # flags
  simulate $best >"$work/reference.json"
  jq -c '.runs[] | select(.refused == null and .cost.core_seconds < 10 and .resolution.precision != "single")' \
    "$work/plan.json" >"$work/expected.jsonl"
  : >"$work/made.jsonl"
  while read -r run; do
    # shellcheck disable=SC2046  # flags
    simulate $(jq -r .flags <<<"$run") >"$work/run.json"
    [[ -s $work/run.json ]] || echo null >"$work/run.json"
    jq -c --argjson expected "$run" --argjson periodic "$periodic" --slurpfile reference "$work/reference.json" "$numbers"'
      ($reference[0] | numbers) as $r
      | {flags: $expected.flags, expected: {error: $expected.error, core_seconds: $expected.cost.core_seconds},
         measured: (if . then {error: (errors($r) | {velocity: .[0], arm_amplitudes: .[1:]}),
                               core_seconds: .cost.core_seconds} else null end)}' "$work/run.json" >>"$work/made.jsonl"
  done <"$work/expected.jsonl"
  for tolerance in 0.1 0.03 0.01; do
    beadswim-run "$work/layout.json" --plan --cycles "$cycles" --tolerance $tolerance 2>/dev/null | jq -c '{tolerance, choice}' || true
  done >"$work/choices.jsonl"
  jq -nc --arg name "$1" --argjson cycles "$cycles" --slurpfile check "$work/check.json" --slurpfile made "$work/made.jsonl" \
    --slurpfile choices "$work/choices.jsonl" --slurpfile plan "$work/plan.json" --slurpfile reference "$work/reference.json" \
    '($check[0].types | to_entries[0].value) as $t
     | {scene: $name, cycles: $cycles, swimmers: $check[0].swimmers, arm_over_radius: $t.arm_over_radius,
        gap: $check[0].smallest_gap, reynolds: $t.reynolds_bead, depth_over_radius: (1 / $t.radius_over_penetration_depth),
        box_over_length: $t.box_over_swimmer_length, hard: $plan[0].hard, reference: ($reference[0].resolution | {cells_per_radius, relaxation_time, precision}), runs: $made, choices: $choices}'
}

swarm() { # NX,NY,NZ FLAGS...
  local swimmers=$1
  shift
  beadswim-layout swarm --preset paper-uniform --block-swimmers "$swimmers" "$@"
}

swarm 1,1,1 | scene "the paper's uniform swarm" 4
swarm 1,1,1 --core-gap 48 --block-gap 48 | scene "wide swarm" 3
swarm 1,1,1 --core-gap 24 --block-gap 24 | scene "tight swarm" 3
swarm 1,2,1 | beadswim-layout defect phase --sigma 1 --seed 1 | scene "two out of phase" 3
swarm 1,2,1 | beadswim-layout defect rotation --sigma 0.2 --seed 1 | scene "two turned" 3
