#!/bin/bash
# Draws figure 2 of the paper: the velocity as a function of l/λ, by the paper's four formulas and by theories without
# truncation in λ/l.
#   examples/figure-2.sh [FOLDER [RUN.json...]]     writes figure-2.svg to FOLDER (default: out/figure-2)
# Run records are drawn as points. Their swimmers must have the period and amplitude below.
set -euo pipefail

#        (4.3)              (4.2)               (4.23)            (4.24)             not truncated
methods=oseen-force-closed,oseen-stroke-closed,rpy-force-printed,rpy-stroke-printed,rpy-perturbation,multipole-perturbation
radius=4          # λ, in lattice units like all lengths, times and forces below
period=4800
amplitude=0.1     # A = B; small enough that beads do not touch at the smallest separation; velocity ∝ A²
smallest=3        # smallest l/λ
largest=30        # largest l/λ
separations=41    # number of separations, with a constant ratio

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
