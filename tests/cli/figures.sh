#!/bin/bash
# Tests examples/figure-2.sh and examples/figure-3.sh, which draw the theory curves of the paper, from layouts to figures.
source "$(dirname "$0")/harness.sh"
examples=$BEADSWIM_SOURCE/examples

run "$examples/figure-2.sh" two
has_status 0
out_empty
err_has '^two/figure-2.svg$'
well_formed two/figure-2.svg
check 'there are not 41 separations' test "$(wc -l <two/predictions.jsonl)" -eq 41

# Runs of another period, and of another phase, go where they belong.
record=$BEADSWIM_SOURCE/docs/results/swimmer-staircase-T4800-A0.2.json
jq -c '.driving.phase = 1' "$record" >phase.json
jq -c '.driving.amplitude[0] = 0.1' "$record" >ratio.json
run "$examples/figure-3.sh" three "$record" phase.json ratio.json "$BEADSWIM_SOURCE/docs/results/swimmer-mr-T2000-A0.2.json"
has_status 0
out_empty
for part in a b c d; do well_formed three/figure-3$part.svg; done
for part in a b; do
  for scheme in staircase mr; do check "$scheme is not in ($part)" grep -q ">lbm $scheme<" three/figure-3$part.svg; done
done
for part in c d; do
  check "the runs are not in ($part)" grep -q '>d₁, lbm<' three/figure-3$part.svg
  check "($part) has not its two runs, and keys" test "$(grep -c '<circle ' three/figure-3$part.svg)" -eq 9
done
check 'theory is not of the box of the runs' \
  test "$(jq -r '.predictions[] | select(.method == "inertia-corrected").settings.fluid' three/by-period.jsonl | sort -u)" = "the layout's box"

# The stroke of (c) at A/B = 1 is that of (d) at alpha = pi/2, and of (a) at T = 4800: one swimmer.
at_paper() { # FILE KEY VALUE   the arm amplitudes by (4.5)
  jq -c --argjson x "$3" '.predictions[] | select(.method == "oseen-force-closed")
    | select((.settings.'"$2"' / $x - 1 | fabs) < 1e-5) | .arm_amplitudes | map(. * 1e4 | round)' "$1"
}
same_bytes "$(declare -f at_paper); at_paper three/by-phase.jsonl phase 1.570796" \
  "$(declare -f at_paper); at_paper three/by-period.jsonl period 4800"

same_bytes "$examples/figure-2.sh again 2>/dev/null && cat again/figure-2.svg" 'cat two/figure-2.svg'

finish
