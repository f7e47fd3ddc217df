#!/bin/bash
# Figure 3 of the paper: velocity and stroke of its single swimmer by theory.
#   examples/figure-3.sh [FOLDER [RUN.json...]]     writes four figures to FOLDER (default out/figure-3):
#     figure-3a.svg  velocity against the driving period
#     figure-3b.svg  the same, as difference from one theory in percent
#     figure-3c.svg  stroke against the ratio A/B of the driving amplitudes
#     figure-3d.svg  stroke against the phase α of the driving
# Run records of the same swimmer, given after the folder, are drawn as points in (a) and (b).
set -euo pipefail

velocity_methods=oseen-force-closed,rpy-force-repaired,rpy-equal-weight,rpy-perturbation,multipole-perturbation,inertia-corrected
stroke_methods=oseen-force-closed,rpy-perturbation,multipole-perturbation,inertia-corrected
relative_to=multipole-perturbation
period=4800       # of (c) and (d); lattice units here and below
amplitude=0.2     # A = B; in (c) B, and A follows from the ratio
steps=40          # of T from 1000 to 10000, of A/B from 0.1 to 2, and of α from -π to π

out=${1:-out/figure-3}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH

swimmer() { beadswim-layout swimmer --preset paper-single --unbounded --jsonl "$@"; }
evenly() { awk -v a="$1" -v b="$2" -v n="$steps" 'BEGIN { for (i = 0; i <= n; i++) print a + (b - a) * i / n }'; }

# With the periods of the runs, so that (b) has a prediction to hold each against.
{ evenly 1000 10000; [ $# -eq 0 ] || jq .driving.period "$@"; } | sort -gu |
  while read -r T; do swimmer --period "$T" --amplitude "$amplitude"; done |
  beadswim-theory --jsonl --method "$velocity_methods" - >"$out/by-period.jsonl"
beadswim-plot velocity-against-period "$out/by-period.jsonl" "$@" --method "$velocity_methods" -o "$out/figure-3a.svg"
beadswim-plot velocity-against-period "$out/by-period.jsonl" "$@" --method "$velocity_methods" \
  --relative-to "$relative_to" -o "$out/figure-3b.svg"

evenly 0.1 2 | awk -v B="$amplitude" '{ print $1 * B }' |
  while read -r A; do swimmer --period "$period" --amplitude "$A,$amplitude"; done |
  beadswim-theory --jsonl --method "$stroke_methods" - |
  tee "$out/by-amplitude-ratio.jsonl" |
  beadswim-plot stroke --against amplitude-ratio - --method "$stroke_methods" -o "$out/figure-3c.svg"

evenly -3.14159265 3.14159265 |
  while read -r alpha; do swimmer --period "$period" --amplitude "$amplitude" --phase="$alpha"; done |
  beadswim-theory --jsonl --method "$stroke_methods" - |
  tee "$out/by-phase.jsonl" |
  beadswim-plot stroke --against phase - --method "$stroke_methods" -o "$out/figure-3d.svg"

for part in a b c d; do echo "$out/figure-3$part.svg" >&2; done
