#!/bin/bash
# Measures what plans need to estimate the cost of mobility runs: products of mobility and forces, and memory.
#   docs/results/plan-costs.sh > plan-costs.jsonl     (some minutes; the programs on PATH)
#   jq -rs -f docs/results/plan-costs.jq plan-costs.jsonl     prints the numbers of libs/plan/src/planned_mobility.cpp
# Prints a line per run: scene, flags, beads, time steps, products, iterations for moments, peak memory [byte].
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

measure() { # SCENE CYCLES FLAGS...   standard input: layout
  cat >"$work/layout.json"
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none --cycles "${@:2}" </dev/null 2>/dev/null |
    jq -c --arg scene "$1" --arg flags "${*:3}" --slurpfile layout "$work/layout.json" --argjson cycles "$2" \
      '{scene: $scene, flags: $flags, beads: (3 * ($layout[0].swimmers | length)), steps: ($cycles * .mobility.steps_per_cycle | round), products: .mobility.products, iterations: .mobility.iterations,
        peak_memory_bytes: .cost.peak_memory_bytes}'
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
