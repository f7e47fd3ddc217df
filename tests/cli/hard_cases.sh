#!/bin/bash
# Tests the hard cases of docs/hard-cases.md (scenes that are difficult to simulate): repeats some of them and compares the
# outcomes with the stored records, and checks that the page agrees with these records.
source "$(dirname "$0")/harness.sh"

results=$BEADSWIM_SOURCE/docs/results
page=$BEADSWIM_SOURCE/docs/hard-cases.md

# Prints group, case and outcome of each record, without numbers. A change of the code must not change these outcomes unnoticed.
outcomes() { jq -c '[.group, .case, .exit, .status, (.reason | gsub("[0-9.e+-]+"; "#"))]' "$1"; }
run bash "$results/hard-cases.sh" speed springs  # groups
has_status 0
cp out new.jsonl
jq -c 'select(.group == ("speed", "springs"))' "$results/hard-cases.jsonl" >known.jsonl
check "the records have these groups" test -s known.jsonl
check "outcomes are those on record" diff <(outcomes known.jsonl | sort) <(outcomes new.jsonl | sort)
# How far velocity and stroke of two records are apart, case by case, relative.
jq -s 'map([.group + .case, (.cycle | if . then [.speed_along_axis] + .arm_amplitudes else [] end)]) | group_by(.[0])' \
  known.jsonl new.jsonl >pairs.json
check "velocities and strokes are those on record" holds 'map(length == 2 and
  ([.[0][1], .[1][1]] | transpose | map((.[0] - .[1] | fabs) <= 1e-6 * (.[1] | fabs)) | all)) | all' pairs.json

# No case ends without a word: it runs, or says why not; what runs has conserved momentum.
jq -s . "$results/hard-cases.jsonl" >records.json
check "every stop has its reason" \
  holds 'map(select(.status != "finished")) | length > 3 and (map(.reason | length > 40) | all)' records.json
check "every run conserves momentum" holds 'map(select(.status == "finished") | .momentum < 1e-9) | all' records.json
check "no beads are deep in each other" holds 'map(.gap // 0 | . > -0.8) | all' records.json

# The plan knows them beforehand: it refuses whatever stops or is refused, and what it lets run is as wrong as it says,
# or by twice that, in nine of ten.
check "the plan refuses what stops" holds 'map(select(.status | IN("stopped-speed", "refused", "failed")) | .plan.refused) | length > 8 and all(. != null)' records.json
jq '[.[] | select(.status == "finished" and .plan.refused == null and .plan.error and .cycle and .reference.cycle)
  | {case: "\(.group), \(.case)", ratios: ([[([.plan.error.velocity] + .plan.error.arm_amplitudes),
      ([.cycle.speed_along_axis] + .cycle.arm_amplitudes), ([.reference.cycle.speed_along_axis] + .reference.cycle.arm_amplitudes)]
      | transpose[] | ((.[1] / .[2] - 1 | fabs) / .[0])])}]' records.json >foretold.json
check "errors are as foretold, or less" holds 'length > 50 and ([.[].ratios | max] | map(select(. > 2)) | length) <= 0.1 * length' foretold.json

# --- mobility models, shapes, walls and flow
run bash "$results/hard-shapes.sh" springs close_beads collisions walls flow  # groups
has_status 0
cp out new.jsonl
jq -c 'select(.group == ("springs", "close beads", "collisions", "walls", "flow"))' "$results/hard-shapes.jsonl" >known.jsonl
check "the records have these groups" test "$(wc -l <known.jsonl)" -gt 30
check "outcomes are those on record" diff <(outcomes known.jsonl | sort) <(outcomes new.jsonl | sort)
jq -s 'map([.group + .case + .flags, (.cycle.velocity // [] | map(. * . * 1e20) | add)]) | group_by(.[0])' known.jsonl new.jsonl >pairs.json
check "velocities are those on record, unless they are roundoff" holds 'map(length == 2 and
  ([.[][1]] | .[0] == .[1] or (.[0] - .[1] | fabs) <= 1e-3 * .[1] or .[1] < 1e-12)) | all' pairs.json
check "every stop has its reason" holds -s 'map(select(.status != "finished")) | length > 10 and (map(.reason | length > 40) | all)' new.jsonl
check "a result that is wrong by more than a tenth is warned of" holds -s 'map(select(.status == "finished" and .cycle and .reference.cycle)
  | ([.cycle.velocity, .reference.cycle.velocity] | transpose | map(.[0] - .[1] | . * .) | add) as $change
  | select($change > 0.01 * (.reference.cycle.velocity | map(. * .) | add)) | .warned) | length > 4 and all' new.jsonl
check "the page has their table" cmp -s <(jq -rs -f "$results/hard-shapes.jq" "$results/hard-shapes.jsonl") \
  <(sed -n '/^<!-- from hard-shapes.jsonl -->$/,/^<!-- end -->$/p' "$page" | sed '1d;$d')

check "the page has the records' table" cmp -s <(jq -rs -f "$results/hard-cases.jq" "$results/hard-cases.jsonl") \
  <(sed -n '/^<!-- from hard-cases.jsonl -->$/,$p' "$page" | sed 1d)

finish
