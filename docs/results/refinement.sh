#!/bin/bash
# Measures the gain by levels of cells for blocks of 1 to 720 of the paper's swimmers in the middle of one box, which the largest
# block fills.
#   docs/results/refinement.sh > refinement.jsonl     (3 minutes on one idle core; the programs on PATH)
# A line contains the swimmers, the share of the box in the finest level, the number of levels that --refine auto chooses, and the
# core-seconds of half a cycle with cells of one size and with levels (medians of three runs in turn).
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

simulate() { # REFINE
  beadswim-run layout.json -o run.h5md --cells-per-radius 2 --precision single --refine "$1" --cycles 0.5 --progress none 2>/dev/null |
    jq -c 'del(.provenance)'
}

for blocks in 1,1,1 1,2,2 2,4,4 3,6,6 3,9,9 4,10,10 5,12,12; do
  beadswim-layout swarm --preset paper-uniform --blocks "$blocks" --block-swimmers 1,1,1 |
    jq '[480, 384, 384] as $box | .domain.lengths as $own | .domain.lengths = $box
      | .swimmers[].position |= ([., $own, $box] | transpose | map(.[0] + (.[2] - .[1]) / 2))' >layout.json
  rm -f off auto
  for _ in 1 2 3; do for refine in off auto; do simulate $refine >>$refine; done; done
  jq -nc --argjson swimmers "$(jq '.swimmers | length' layout.json)" --slurpfile off off --slurpfile auto auto '
    def seconds: map(.cost.core_seconds) | sort | .[1];
    ($auto[0].resolution.levels | {levels: length, share: ((.[-1].cells * pow(.[-1].cell; 3)) / (480 * 384 * 384))})
    | {swimmers: $swimmers, share, levels, seconds_uniform: ($off | seconds), seconds_levels: ($auto | seconds)}'
done
