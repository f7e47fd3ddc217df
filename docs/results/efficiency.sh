#!/bin/bash
# Measures the efficiency of the paper's swimmer as a function of the driving phase, by lattice runs and by theory.
#   docs/results/efficiency.sh > efficiency.jsonl     (two minutes on one core; the programs on PATH)
# Prints per phase: phase [radian]; power and efficiency of the last of four cycles at 3 cells per radius, and of the prediction
# inertia-corrected in the same box; and of unsteady-multipole in open space.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for phase in 0.6 0.9 1.2 1.5 1.8 2.1 2.4; do
  beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 --phase $phase \
    >"$work/layout.json"
  beadswim-theory "$work/layout.json" --method inertia-corrected,unsteady-multipole >"$work/theory.json"
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --cells-per-radius 3 --relaxation-time 1 --cycles 4 --progress none 2>/dev/null |
    jq -c --argjson phase $phase --slurpfile theory "$work/theory.json" '
      ($theory[0].predictions | map({(.method): {power, efficiency}}) | add) + {phase: $phase, run: (.swimmers[0].cycles[-1] | {power, efficiency})}'
done
