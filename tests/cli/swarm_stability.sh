#!/bin/bash
# Tests docs/swarm-stability.md: repeats a few cycles of two swimmers side by side, and checks that the page agrees with the
# stored records.
source "$(dirname "$0")/harness.sh"
results=$BEADSWIM_SOURCE/docs/results
records=$results/stability

swarm() { beadswim-layout swarm --preset paper-uniform --block-swimmers 1,1,1 --blocks "$@"; }
moved() { beadswim-layout defect jitter --sigma "$1" --seed "$2"; }
# Displaces all swimmers by X along each axis.
shifted() { jq --argjson by "$1" '.swimmers[].position |= map(. + $by)'; }
# Runs a layout and extracts the data that are stored in the records, as docs/results/stability.sh does, to NAME.json.
simulate() { # NAME LAYOUT LATTICE CYCLES
  accepts beadswim-run "$2" -o run.h5md --cells-per-radius 3 --progress none --cycles "$4"
  jq -c --arg name "$1" --argjson exit 0 --slurpfile layouts "$2" --slurpfile lattices "$3" -f "$results/stability.jq" out >"$1.json"
}
compare() { # MESSAGE CONDITION FILE...
  local message=$1 condition=$2
  shift 2
  jq -s . "$@" >together.json
  check "$message" holds "$condition" together.json
}
# Returns the size of the mean deviation of the swimmers from the lattice, across x, after cycle 5 I.
mean_size='def mean_size($i): .modes[0].amplitudes[$i][1:] | map(. * .) | add | sqrt;'

swarm 1,2,1 >lattice.json
shifted 1 <lattice.json >between.json
shifted 2 <lattice.json >cell-on.json
simulate '2 abreast, still' lattice.json lattice.json 4
check 'a lattice left to itself departs' holds '.off | (.x, .across, .tilt | max) < 1e-9' '2 abreast, still.json'

moved 1e-3 1 <lattice.json >layout.json
simulate '2 abreast, one' layout.json lattice.json 10
moved 1e-3 2 <lattice.json >layout.json
simulate '2 abreast, two' layout.json lattice.json 10
moved 1e-3 1 <between.json >layout.json
simulate '2 abreast, between' layout.json between.json 10
moved 1e-3 1 <cell-on.json >layout.json
simulate '2 abreast, cell on' layout.json cell-on.json 4

jq -c 'select(.name == "2 abreast, k = 0.2" and .cells_per_radius == 3)' "$records/rows.jsonl" >recorded.json
near='def near($b; $share): (. - $b | fabs) <= $share * ($b | fabs);'
compare 'departures are not those on record' "$near"' [.[].off.across[:6]] | transpose | length == 6 and (map(. as [$a, $b] | $a | near($b; 0.01)) | all)' \
  '2 abreast, one.json' recorded.json
# Nothing differs a whole cell on.
compare 'a whole cell on swimmers depart otherwise' "$near"' [.[].off.across[:3]] | transpose | map(. as [$a, $b] | $b | near($a; 0.002)) | all' \
  '2 abreast, one.json' '2 abreast, cell on.json'
# The mean departure moves by the lattice's pull alone, as fast for either seed: away from faces of cells, towards their middles.
compare 'seeds disagree on the pull of the lattice' \
  "$mean_size"' map([., mean_size(2)] | .[1] / (.[0] | mean_size(0)) | log / 10) | (.[0] - .[1] | fabs) < 0.02 and .[0] > 0.01 and .[1] > 0' \
  '2 abreast, one.json' '2 abreast, two.json'
check 'the lattice does not pull beads to the middles of its cells' holds "$mean_size"' mean_size(2) < 0.9 * mean_size(0)' '2 abreast, between.json'

# A lone swimmer follows its own driving, whenever that starts; and two in step make one order.
swarm 1,1,1 >lone.json
simulate 'lone, in step' lone.json lone.json 6
jq '.swimmers[0].driving.phase_offset = 2' lone.json >layout.json
simulate 'lone, phase' layout.json lone.json 6
compare 'a lone swimmer does not follow its driving' \
  '[.[].phases[1]] | (map(.cycle) == [6, 6]) and ([map(.arms[][0])] | .[0] | (.[0] - .[2] | fabs) < 0.002 and (.[1] - .[3] | fabs) < 0.002)' \
  'lone, in step.json' 'lone, phase.json'

check "the page has not the records' tables" cmp -s <("$results/stability-tables.sh" "$records") \
  <(sed -n '/^<!-- from the records -->$/,$p' "$BEADSWIM_SOURCE/docs/swarm-stability.md" | sed 1d)

finish
