#!/bin/bash
# Figure 2 of the paper: the swimming velocity by its four formulas, and by theories that are not truncated in λ/l,
# as the beads come closer.
#   examples/figure-2.sh [FOLDER [RUN.json...]]     writes figure-2.svg to FOLDER (default out/figure-2)
# Run records of swimmers driven with the same period and amplitude, given after the folder, are drawn as points.
set -euo pipefail

#        (4.3)              (4.2)               (4.23)            (4.24)             not truncated
methods=oseen-force-closed,oseen-stroke-closed,rpy-force-printed,rpy-stroke-printed,rpy-perturbation,multipole-perturbation
radius=4          # λ; lattice units here and below
period=4800
amplitude=0.1     # A = B, so small that beads stay apart at the smallest separation; the velocity goes as A²
smallest=3        # l/λ
largest=30
separations=41    # each the same factor above the last

out=${1:-out/figure-2}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH

awk -v a="$smallest" -v b="$largest" -v n="$separations" -v r="$radius" \
  'BEGIN { for (i = 0; i < n; i++) print r * a * (b / a) ^ (i / (n - 1)) }' |
  while read -r arm; do
    beadswim-layout swimmer --preset paper-single --unbounded --jsonl --arm "$arm" --period "$period" \
      --amplitude "$amplitude"
  done |
  beadswim-theory --jsonl --method "$methods" - |
  tee "$out/predictions.jsonl" |
  beadswim-plot separation - "$@" --method "$methods" -o "$out/figure-2.svg"
echo "$out/figure-2.svg" >&2
