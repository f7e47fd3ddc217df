#!/bin/bash
# Draws figure 2 of the paper (Pickl et al. 2017): the velocity against l/λ, the arm length l divided by the bead radius λ, by the
# paper's four formulas and by theories that are not expansions in λ/l.
#   examples/figure-2.sh [FOLDER [RUN.json...]]     writes figure-2.svg to FOLDER (default: out/figure-2)
# Run records are drawn as points. Their swimmers must have the period and amplitude that this script sets below.
set -euo pipefail

# Methods by which the velocity is drawn, each below its equation in the paper:
#        (4.3)              (4.2)               (4.23)            (4.24)             not truncated
methods=oseen-force-closed,oseen-stroke-closed,rpy-force-printed,rpy-stroke-printed,rpy-perturbation,multipole-perturbation
radius=4          # bead radius λ; all numbers here are in lattice units
period=4800
amplitude=0.1     # A = B; so small that beads do not touch at the smallest separation
smallest=3        # smallest l/λ
largest=30        # largest l/λ
separations=41    # number of values of l/λ, at equal ratios

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
