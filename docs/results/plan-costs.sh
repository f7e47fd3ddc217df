#!/bin/bash
# Measures what plans need to estimate the cost of mobility runs: products of mobility and forces, memory, and how near costs are.
#   docs/results/plan-costs.sh > plan-costs.jsonl     (some minutes on an otherwise idle core; the programs on PATH)
#   jq -rs -f docs/results/plan-costs.jq plan-costs.jsonl     prints the numbers of libs/plan/src/planned_mobility.cpp
# Prints a line per run: scene, flags, beads, time steps, products, iterations for moments, points of the mesh of a fluid with memory,
# peak memory [byte], core-seconds as expected by a plan and as measured, and seconds of computing by the whole program.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
TIMEFORMAT=%U
trap 'rm -rf "$work"' EXIT

measure() { # SCENE CYCLES FLAGS...   standard input: layout
  cat >"$work/layout.json"
  { beadswim-run "$work/layout.json" --plan --cycles "${@:2}" </dev/null 2>/dev/null || true; } >"$work/plan.json"
  expected=$(jq '.runs[0].cost.core_seconds' "$work/plan.json")
  { time beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none --cycles "${@:2}" </dev/null >"$work/run.json" 2>/dev/null; } 2>"$work/seconds"
  jq -c --arg scene "$1" --arg flags "${*:3}" --slurpfile layout "$work/layout.json" --argjson cycles "$2" --argjson expected "$expected" --argjson user "$(cat "$work/seconds")" \
    '{scene: $scene, flags: $flags, beads: (3 * ($layout[0].swimmers | length)), steps: ($cycles * .mobility.steps_per_cycle | round), products: .mobility.products, iterations: .mobility.iterations,
      mesh_points: (if .mobility.mesh_spacing then .mobility.mesh_spacing as $h | $layout[0].domain.lengths | map(. / $h) | .[0] * .[1] * .[2] | round else null end),
      peak_memory_bytes: .cost.peak_memory_bytes, expected_seconds: $expected, core_seconds: .cost.core_seconds, user_seconds: $user}' "$work/run.json"
}
swarm() { # NX,NY,NZ FLAGS...
  beadswim-layout swarm --preset paper-uniform --block-swimmers "$@"
}

for cycles in 0.02 1; do  # 0.02: the first two time steps
  beadswim-layout swimmer --preset paper-single --unbounded | measure alone $cycles --model rpy
  swarm 1,1,1 | measure "one in a box" $cycles --model rpy
  swarm 2,2,2 | measure swarm $cycles --model rpy+near
  swarm 2,2,2 --damping 1 | measure "swarm with dashpots" $cycles --model rpy
  swarm 2,2,2 | beadswim-layout defect phase --random --seed 1 | measure "swarm with random phases" $cycles --model rpy
  for order in 0 1 2; do swarm 2,2,2 | measure "swarm with memory" $cycles --model unsteady --multipole-order $order; done
done
for flags in "--model rpy" "--model multipole --multipole-order 1" "--model multipole --multipole-order 2"; do
  # shellcheck disable=SC2086  # flags
  swarm 8,8,8 | measure "large swarm" 0.02 $flags
done
for blocks in 8,8,8 16,16,8; do
  for flags in "--multipole-order 0 --reynolds-stress off" "--multipole-order 0" "--multipole-order 1" "--multipole-order 2"; do
    # shellcheck disable=SC2086  # flags
    swarm $blocks | measure "large swarm" 0.02 --model unsteady $flags
  done
done
# Whole cycles of a large swarm; many steps of one swimmer with few frames, whose work beside products is the rest of a step.
for model in oseen rpy+near; do swarm 8,8,8 | measure "large swarm" 1 --model $model; done
for cycles in 10 200; do
  beadswim-layout swimmer --preset paper-single --unbounded | measure alone $cycles --model rpy --frames-per-cycle 10
done
