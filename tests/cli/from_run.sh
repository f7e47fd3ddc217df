#!/bin/bash
# Tests beadswim-layout from-run: layouts that start where a run was.
source "$(dirname "$0")/harness.sh"

settings=(--model rpy --progress none --no-provenance --frames-per-cycle 4)
beadswim-layout swimmer --preset paper-single --amplitude 0.4 --unbounded --axis 1,2,0 --frame body >swimmer.json
beadswim-layout swimmer --preset paper-single --amplitude 0.4 --box 60,40,40 --boundary periodic --position 59,1,20 >box.json
beadswim-layout swimmer --preset paper-single --half-space z --position 0,0,30 --axis 1,0,0.2 --frame initial-axis >wall.json
beadswim-layout shape triangle --unbounded >triangle.json

# --- two cycles are one cycle, and one more from its end. The first time steps after the start are of lower order:
# their error changes places by up to 2e-4 of the distance of one cycle, or of the amplitudes if it does not swim far.
for scene in swimmer box wall triangle; do
  beadswim-run $scene.json -o two.h5md --cycles 2 "${settings[@]}" >two.json 2>err
  beadswim-run $scene.json -o one.h5md --cycles 1 "${settings[@]}" >one.json 2>err
  accepts beadswim-layout from-run one.h5md
  cp out continued.json
  check "$scene: not of version 2" holds '.schema == "beadswim/layout/2" and (.swimmers[0].start.positions | length) == 3' out
  beadswim-layout from-run two.h5md --cycle 1 >same.json
  check "$scene: the end of cycle 1 differs" cmp -s <(jq 'del(.provenance)' continued.json) <(jq 'del(.provenance)' same.json)
  run beadswim-run continued.json -o next.h5md --cycles 1 "${settings[@]}"
  has_status 0
  check "$scene: the second cycle differs" holds '.[0].driving.period as $period | map(.swimmers[0].cycles[-1])
    | (.[0].arm_amplitudes | max) as $size | [.[0], .[1]] as [$a, $b]
    | ([$a.velocity, $b.velocity] | transpose | map(.[0] - .[1] | fabs) | max) < 1e-3 * ($a.velocity | map(fabs) | max) + 1e-4 * $size / $period
    and ([$a.arm_amplitudes, $b.arm_amplitudes] | transpose | all((.[0] - .[1] | fabs) < 1e-3 * $size))' <(jq -s . two.json out)
done

# --- a swimmer of another period is within its cycle where the base cycle ends: its phase goes on
beadswim-layout combine swimmer.json swimmer.json --at 0,0,200 |
  jq '.types.a.driving as $d | .swimmers[1].driving = ($d | .period *= 0.8)' >periods.json
beadswim-run periods.json -o two.h5md --cycles 2 "${settings[@]}" >two.json 2>err
beadswim-run periods.json -o one.h5md --cycles 1 "${settings[@]}" >one.json 2>err
beadswim-layout from-run one.h5md >continued.json
beadswim-run continued.json -o next.h5md --cycles 1 "${settings[@]}" >next.json 2>err
for run in two next; do beadswim-layout from-run $run.h5md >$run.end; done
check "beads of swimmers with several periods differ" holds 'map([.swimmers[].start.positions | flatten]) | transpose
  | all(transpose | all((.[0] - .[1] | fabs) < 1e-3))' <(jq -s . two.end next.end)

finish
