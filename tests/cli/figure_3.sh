#!/bin/bash
# Tests docs/figure-3.md: repeats its coarsest runs for several driving periods and compares them with theory, and checks that the
# page agrees with the stored records.
source "$(dirname "$0")/harness.sh"
results=$BEADSWIM_SOURCE/docs/results
records=$results/figure-3

run "$BEADSWIM_SOURCE/examples/figure-3-runs.sh" new by-period --cells-per-radius 2 --precision single
has_status 0
out_empty

# Arms to 2 %, sines to 0.5 %, velocities to 3 % of theory from T = 3000 on: what two cells a radius are good for where
# strokes are longer than a cell, and what this theory says that it does not know.
while read -r record; do
  echo "$record" >run.json
  beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic --amplitude 0.2 \
    --period "$(jq .driving.period run.json)" | beadswim-theory - --method inertia-corrected >theory.json
  for limit in arm_amplitudes:0.02 sin_phase_shift:0.005 velocity:0.03; do
    run beadswim-compare run.json theory.json --cycle mean:2 --quantity "${limit%:*}" --tolerance "${limit#*:}"
    has_status 0
  done
done < <(jq -c 'select(.driving.period >= 3000)' new/by-period.jsonl)
check 'there are not 4 periods from 3000 on' test "$(jq -s 'map(select(.driving.period >= 3000)) | length' new/by-period.jsonl)" -eq 4

# The records' velocities and strokes, but for the last digits of single precision.
jq -s 'group_by(.driving.period) | map(map(.swimmers[0].cycles[-1] | [.speed_along_axis] + .arm_amplitudes))' \
  new/by-period.jsonl "$records/coarse/by-period.jsonl" >pairs.json
check 'runs are not those on record' holds 'length == 6 and
  (map(length == 2 and ([.[0], .[1]] | transpose | map((.[0] - .[1] | fabs) <= 1e-4 * (.[1] | fabs)) | all)) | all)' pairs.json

check "the page has not the records' tables" cmp -s <("$results/figure-3-tables.sh" "$records") \
  <(sed -n '/^<!-- from the records -->$/,$p' "$BEADSWIM_SOURCE/docs/figure-3.md" | sed 1d)

finish
