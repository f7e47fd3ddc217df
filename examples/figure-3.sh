#!/bin/bash
# Draws figure 3 of the paper (Pickl et al. 2017): velocity and stroke of the single swimmer by theory and by runs.
#   examples/figure-3.sh [FOLDER [RUN.jsonl...]]     writes four figures to FOLDER (default: out/figure-3):
#     figure-3a.svg  velocity against the driving period
#     figure-3b.svg  relative difference of these velocities from the velocity by one theory, in percent
#     figure-3c.svg  stroke against the ratio A/B of the driving amplitudes
#     figure-3d.svg  stroke against the driving phase α
# Runs are drawn as points, which are means over the last two cycles. The files RUN.jsonl of run records are made by
# examples/figure-3-runs.sh. Theory methods that include a box use the box of the first run record; other methods are for
# unbounded fluid.
set -euo pipefail

velocity_methods=oseen-force-closed,rpy-force-repaired,rpy-equal-weight,rpy-perturbation,multipole-perturbation,inertia-corrected
stroke_methods=oseen-force-closed,rpy-perturbation,multipole-perturbation,inertia-corrected
relative_to=multipole-perturbation
period=4800       # in figures 3c and 3d; all numbers are in lattice units
amplitude=0.2     # A = B; in figure 3c this is B, and A follows from A/B
steps=40          # number of intervals of the period (1000 to 10000), of A/B (0.1 to 2) and of α (-π to π)

out=${1:-out/figure-3}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH

cat "$@" </dev/null | jq -c . >"$out/runs.jsonl"
box=$(jq -rs '.[0].domain | if . then "--box \(.lengths | join(",")) --boundary \(.boundary | join(","))"
                            else "--unbounded" end' "$out/runs.jsonl")

swimmer() { beadswim-layout swimmer --preset paper-single $box --jsonl "$@"; }
evenly() { awk -v a="$1" -v b="$2" -v n="$steps" 'BEGIN { for (i = 0; i <= n; i++) print a + (b - a) * i / n }'; }
# Selects the runs that satisfy CONDITION and writes them to the file NAME. Sets `runs` to the arguments that draw this file; sets
# it to no arguments if there are no such runs.
choose_runs() { # NAME CONDITION
  jq -c "select(.driving | (.phase - 1.5707963 | fabs < 1e-6) as \$usual_phase
    | (.amplitude[0] == .amplitude[1]) as \$equal | (.period == $period) as \$usual_period | $2)" "$out/runs.jsonl" >"$out/$1"
  runs=()
  [ ! -s "$out/$1" ] || runs=("$out/$1" --cycle mean:2)
}

# Theory also needs the periods of the runs, because figure 3b compares each run with a prediction at its period.
choose_runs runs-by-period.jsonl '$equal and $usual_phase'
{ evenly 1000 10000; jq .driving.period "$out/runs-by-period.jsonl"; } | sort -gu |
  while read -r T; do swimmer --period "$T" --amplitude "$amplitude"; done |
  beadswim-theory --jsonl --method "$velocity_methods" - >"$out/by-period.jsonl"
velocity() { beadswim-plot velocity-against-period "$out/by-period.jsonl" "${runs[@]}" --method "$velocity_methods" "$@"; }
velocity -o "$out/figure-3a.svg"
velocity --relative-to "$relative_to" -o "$out/figure-3b.svg"

choose_runs runs-by-amplitude-ratio.jsonl '$usual_period and $usual_phase'
evenly 0.1 2 | awk -v B="$amplitude" '{ print $1 * B }' |
  while read -r A; do swimmer --period "$period" --amplitude "$A,$amplitude"; done |
  beadswim-theory --jsonl --method "$stroke_methods" - >"$out/by-amplitude-ratio.jsonl"
stroke() { beadswim-plot stroke "${runs[@]}" --method "$stroke_methods" "$@"; }
stroke --against amplitude-ratio "$out/by-amplitude-ratio.jsonl" -o "$out/figure-3c.svg"

choose_runs runs-by-phase.jsonl '$usual_period and $equal'
evenly -3.14159265 3.14159265 |
  while read -r alpha; do swimmer --period "$period" --amplitude "$amplitude" --phase="$alpha"; done |
  beadswim-theory --jsonl --method "$stroke_methods" - >"$out/by-phase.jsonl"
stroke --against phase "$out/by-phase.jsonl" -o "$out/figure-3d.svg"

for part in a b c d; do echo "$out/figure-3$part.svg" >&2; done
