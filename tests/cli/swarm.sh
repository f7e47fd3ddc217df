#!/bin/bash
# Tests beadswim-layout swarm, defect and reduce: their use in pipes, and a run of the reduced periodic box in place of the swarm.
source "$(dirname "$0")/harness.sh"

# --- layouts
accepts beadswim-layout swarm --preset paper-defect --blocks 2,1,3
cp out defect.json
check 'blocks of nine' holds '.swimmers | length == 54' defect.json
check 'the box is of whole blocks' holds '.domain == {lengths: [240, 120, 360], boundary: ["periodic", "periodic", "periodic"]}' defect.json
check 'the preset is not the paper swimmer' holds '.types.a | .beads[0].radius == 6 and .springs[1].rest_length == 32
  and .driving.period == 2000 and .driving.amplitude == [2, 2]' defect.json
check 'no resolution hint' holds '.resolution == {cells_per_radius: 6, relaxation_time: 1.5}' defect.json
positions='jq -c ".swimmers | map(.position)"'
same_bytes "beadswim-layout swarm --preset paper-defect | $positions" \
  "beadswim-layout swarm --preset paper-uniform --core-gap 37 --block-gap 56,46,46 | $positions"
accepts beadswim-layout swarm --radius 1 --arm 5 --stiffness 1 --amplitude 1 --period 100 --viscosity 1 --core-gap 4 \
  --block-gap 5,6,7 --block-swimmers 2,2,1
check 'four swimmers' holds '(.swimmers | length) == 4 and .domain.lengths == [29, 10, 7]' out
refuses 'required flags are missing: .*--core-gap' beadswim-layout swarm --radius 1 --arm 5 --stiffness 1 --amplitude 1 --period 100 --viscosity 1
refuses 'did you mean "paper-uniform"' beadswim-layout swarm --preset paper-unform
refuses 'overlaps' beadswim-layout swarm --preset paper-uniform --core-gap 11
refuses 'whole number' beadswim-layout swarm --preset paper-uniform --blocks 1,2.5,1
refuses 'whole number' beadswim-layout swarm --preset paper-uniform --blocks a,1,1
refuses 'at most' beadswim-layout swarm --preset paper-uniform --blocks 1000,1000,1000

# --- defects, seeded, in pipes
beadswim-layout swarm --preset paper-uniform --blocks 2,2,2 --frame body >swarm.json
for defect in 'vacancy --count 3' 'interstitial --fraction 0.05' 'jitter --sigma 0.5' 'rotation --sigma 0.05' \
  'rotation --random --repair' 'domains --count 3 --repair' 'phase --random' 'phase --sigma 0.3 --fraction 0.5' \
  'amplitude --sigma 0.1' 'frequency --sigma 0.01' 'spacing --axis y --sigma 3 --whole 1' 'mixture --with one.json --count 5'; do
  beadswim-layout swimmer --preset paper-single >one.json
  accepts beadswim-layout defect $defect swarm.json
  cp out once.json
  check "$defect: no change" test "$(jq -cS 'del(.provenance)' once.json)" != "$(jq -cS 'del(.provenance)' swarm.json)"
  check "$defect: not on record" holds '.provenance | length == 2 and .[1].arguments[1] == "'"${defect%% *}"'"' once.json
  same_bytes "beadswim-layout defect $defect <swarm.json" "beadswim-layout defect $defect <swarm.json"
  accepts beadswim-layout check once.json
  run beadswim-layout defect $defect --seed 2 swarm.json
  has_status 0
  check "$defect: another seed, the same" test "$(jq -cS 'del(.provenance)' once.json)" != "$(jq -cS 'del(.provenance)' out)"
done
radians=0.08726646259971647  # 5 degrees
for defect in rotation phase; do
  same_bytes "beadswim-layout defect $defect --sigma 5deg swarm.json | jq 'del(.provenance)'" \
    "beadswim-layout defect $defect --sigma $radians swarm.json | jq 'del(.provenance)'"
done
run bash -c 'beadswim-layout defect vacancy --fraction 0.25 <swarm.json | beadswim-layout defect jitter --sigma 0.5 --seed 2 |
  beadswim-layout defect phase --random --seed 3'
has_status 0
check 'the pipe has not three defects' holds '(.swimmers | length) == 54 and (.provenance | length) == 4
  and (.swimmers | map(has("driving")) | all)' out
refuses 'the flag --fraction or --count is missing' beadswim-layout defect vacancy swarm.json
refuses 'would remove all swimmers' beadswim-layout defect vacancy --fraction 1 swarm.json
refuses '73 is greater than the number of swimmers, 72' beadswim-layout defect vacancy --count 73 swarm.json
refuses 'the flag --fraction or --count is missing' beadswim-layout defect mixture --with one.json swarm.json
refuses 'with: the layout to mix in cannot be read from standard input' beadswim-layout defect mixture --with - --count 1 swarm.json
refuses 'the flag --sigma or --random is missing' beadswim-layout defect rotation swarm.json
refuses 'overlap.*--repair moves swimmers apart' beadswim-layout defect jitter --sigma 20 swarm.json
refuses 'command is needed: .*vacancy' beadswim-layout defect
beadswim-layout swimmer --preset paper-single --unbounded >unbounded.json
refuses 'unbounded' beadswim-layout defect interstitial --count 1 unbounded.json

# --- forces along x do not turn with swimmers: programs count the swimmers and name the remedy
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,4,4 >parallel.json
for defect in 'rotation --random --count 5 --repair' 'rotation --sigma 0.05 --count 5' 'domains --count 2 --repair' 'interstitial --count 2'; do
  run beadswim-layout defect $defect parallel.json
  has_status 0
  cp out turned.json
  turned=$(jq '[.swimmers[] | select(.axis != [1, 0, 0])] | length' turned.json)
  all=$(jq '.swimmers | length' turned.json)
  for command in "beadswim-layout defect $defect parallel.json" 'beadswim-layout check turned.json' \
    'beadswim-layout defect jitter turned.json --sigma 0' 'beadswim-run turned.json --model rpy --cycles 0.1 -o turned.h5md --progress none'; do
    run $command
    has_status 0
    if [ "$turned" = 0 ]; then
      check 'a warning of no swimmer' test -z "$(grep 'driving forces of' err)"
    else
      err_has "^beadswim-[a-z]+: warning: the driving forces of $turned of $all swimmers keep their directions .*; use --frame body"
    fi
  done
  check 'the record warns' holds --argjson any $((turned > 0)) '[.warnings[].code] | (index("forces-fixed-in-box") != null) == ($any == 1)' out
done
# One is warned of just if the swimmer is turned so that it swims at another speed.
speed() { jq '.swimmers[0].cycles[-1].speed_along_axis' out; }
for swimmer in 'swimmer --preset paper-single --unbounded' 'shape flagellum --unbounded'; do
  for way in '--frame lab --axis=-1,0,0' '--frame lab --axis 1,1,0' '--frame lab --axis 0,1,0' \
    '--frame lab --axis 1,0.01,0' '--axis 0,0,1 --frame body' '--axis 1,2,3 --frame initial-axis'; do
    run beadswim-run <(beadswim-layout $swimmer $(grep -o -- '--frame [a-z-]*' <<<"$way")) --model rpy --cycles 4 -o speed.h5md --progress none
    reference=$(speed)
    beadswim-layout $swimmer $way >turned.json
    run beadswim-run turned.json --model rpy --cycles 4 -o speed.h5md --progress none
    has_status 0
    check "$swimmer $way: the warning does not agree with the speed, $(speed) instead of $reference" \
      test "$(grep -c 'driving forces of 1 of 1 swimmers keep' err)" = "$(jq -n "($(speed) / $reference - 1 | fabs) > 1e-6 | if . then 1 else 0 end")"
  done
done

# --- reduce: the uniform swarm is one swimmer, the defect swarm nine
run beadswim-layout reduce swarm.json
has_status 0
cp out cell.json
check 'not one swimmer in 96 x 32 x 32' holds '(.swimmers | length) == 1 and .domain.lengths == [96, 32, 32]' cell.json
err_has '2 x 6 x 6 copies of one cell; the new layout is this cell, with 72 swimmers reduced to 1, in a box of 96 x 32 x 32; the copies differ'
run beadswim-layout reduce defect.json
check 'not nine in 120 x 120 x 120' holds '(.swimmers | length) == 9 and .domain.lengths == [120, 120, 120]' out
run bash -c 'beadswim-layout defect vacancy --count 1 swarm.json | beadswim-layout reduce'
check 'a vacancy is reduced away' holds '(.swimmers | length) == 71' out
refuses 'unbounded' beadswim-layout reduce unbounded.json
without_provenance="jq 'del(.provenance, .made_by)'"
same_bytes "beadswim-layout reduce unbounded.json --box 80,60,70 | $without_provenance" \
  "beadswim-layout swimmer --preset paper-single --box 80,60,70 --boundary periodic | $without_provenance"
refuses '^beadswim-layout: --box: the layout has 72 swimmers, but only a single swimmer can be put in another box; leave the flag out$' \
  beadswim-layout reduce swarm.json --box 80,60,60
refuses 'the layout made by the flags is invalid: ' beadswim-layout reduce unbounded.json --box 20,20,20
refuses '--box' beadswim-layout reduce unbounded.json --box 80,60,60 --tolerance 0.1

# The cell's run is that of each of 2 x 2 x 2 cells, swimmer by swimmer, to roundoff.
beadswim-layout swarm --preset paper-uniform --blocks 2,1,1 --block-swimmers 1,2,2 >eight.json
beadswim-layout reduce eight.json >one.json 2>err
run beadswim-run one.json -o one.h5md --cycles 1 --cells-per-radius 3 --progress none
has_status 0
cp out one.record
run mpirun -n 2 beadswim-run eight.json -o eight.h5md --cycles 1 --cells-per-radius 3 --progress none
has_status 0
cp out eight.record
jq -s '.[0].swimmers[0].cycles[0] as $one | .[1].swimmers | map(.cycles[0] |
  [(.velocity[0] - $one.velocity[0]), (.arm_amplitudes[0] - $one.arm_amplitudes[0]), (.arm_amplitudes[1] - $one.arm_amplitudes[1])]
  | map(fabs) | max) | {number: length, worst: max, velocity: $one.velocity[0]}' one.record eight.record >apart.json
check 'the swarm moves otherwise than its cell' holds '.number == 8 and .worst < 1e-10 and (.velocity | fabs) > 1e-5' apart.json

# A swimmer with a period of its own, beside one that only lets itself be carried, swims as where its period is the base, by
# which steps and frames are set.
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,32,16 --boundary periodic --position 16,16,8 --period 200 \
  --amplitude 0.05 | jq '.swimmers += [.swimmers[0] | .id = 1 | .position[1] = 0 | .driving = {amplitude: [0, 0]}]' >layout.json
jq '.swimmers[0].driving = {period: 163.7}' layout.json >own.json
jq '.types[].driving.period = 163.7' layout.json >base.json
for name in own base; do
  run beadswim-run $name.json -o $name.h5md --cells-per-radius 2 --cycles 5 --progress none
  has_status 0
  mv out $name.record
done
jq -s 'map(.swimmers[0].cycles[3]) | {apart: ([.[0], .[1]] | map([.speed_along_axis] + .arm_amplitudes + .arm_means) |
  transpose | map((.[0] / .[1] - 1) | fabs) | max), phases: ([.[0].arm_phases, .[1].arm_phases] | transpose | map(.[0] - .[1] | fabs) | max)}' \
  own.record base.record >apart.json
check 'the base period changes how it swims' holds '.apart < 2e-4 and .phases < 5e-4' apart.json
check 'its cycles are not its own' holds \
  '(.swimmers | map(.cycles | length)) == [6, 5] and .driving.period == 200 and .swimmers[0].period == 163.7' own.record

finish
