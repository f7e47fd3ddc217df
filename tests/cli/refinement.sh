#!/bin/bash
# Tests beadswim-run --refine: levels of cells around the beads.
source "$(dirname "$0")/harness.sh"

small() { # RANKS ARGUMENT...
  mpirun -n "$1" beadswim-run "${@:2}" --progress none --no-provenance
}
beadswim-layout swimmer --preset paper-single --box 256,192,192 --boundary periodic --position 120,96,96 --period 1600 \
  --amplitude 0.2 >wide.json
settings="--cells-per-radius 2 --relaxation-time 1.5"

# --- levels change neither velocity nor strokes, and cost less
run small 2 wide.json -o one.h5md $settings --cycles 1
has_status 0
mv out one.json
run small 2 wide.json -o three.h5md $settings --cycles 1 --refine 2
has_status 0
mv out three.json
jq -s . one.json three.json >both.json
check 'the velocity differs by more than 0.3 %' \
  holds '[.[].swimmers[0].cycles[-1].speed_along_axis] | .[1] / .[0] - 1 | fabs < 0.003' both.json
check 'the strokes differ by more than 0.1 %' \
  holds '[.[].swimmers[0].cycles[-1].arm_amplitudes] | [.[1][0] / .[0][0], .[1][1] / .[0][1]] | map(. - 1 | fabs < 0.001) | all' both.json
check 'it does not save nine tenths of the updates' \
  holds '.resolution.levels | (.[2].cells + .[1].cells / 2 + .[0].cells / 4) < 0.1 * 128 * 96 * 96' three.json
check 'there is not one level without --refine' \
  holds '.resolution.levels == [{cell: 2, boxes: [{lower: [0, 0, 0], upper: [256, 192, 192]}], cells: (128 * 96 * 96)}]' one.json
check 'levels are not nested, or wrong' holds '.resolution as $r | $r.levels | length == 3
  and (map(.cell) == [8, 4, 2]) and .[0].boxes[0] == {lower: [0, 0, 0], upper: [256, 192, 192]} and $r.cell_size == 2
  and ([.[:-1], .[1:]] | transpose | map(.[0].boxes[0].lower[1] < .[1].boxes[0].lower[1]) | all)
  and (map((.boxes[0] | [.upper, .lower] | transpose | map(.[0] - .[1])) as $edges
    | .cells == ($edges[0] * $edges[1] * $edges[2] / pow(.cell; 3))) | all)' three.json
check 'momentum is not conserved' holds '.momentum.total | map(fabs < 1e-10) | all' three.json
check 'mass is not conserved' holds '.mass_relative_change | fabs < 1e-13' three.json

# --- auto is one of the numbers; on other ranks the same bits
run small 3 wide.json -o auto.h5md $settings --cycles 0.5 --refine auto
has_status 0
mv out auto.json
levels=$(jq '.resolution.levels | length' auto.json)
check 'auto chooses no levels' test "$levels" -ge 3
run small 1 wide.json -o auto.h5md $settings --cycles 0.5 --refine $((levels - 1))
has_status 0
check 'auto is not that number, or ranks change the bits' \
  test "$(jq '[.swimmers, .state_sha256, .momentum]' auto.json)" = "$(jq '[.swimmers, .state_sha256, .momentum]' out)"
beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce 2>/dev/null >narrow.json
run beadswim-run narrow.json -o narrow.h5md --cells-per-radius 3 --cycles 0.1 --refine auto --progress none
has_status 0
check 'levels where they do not pay' holds '.resolution.levels | length == 1' out

# --- levels follow a sphere across the seam of the box; a run goes on from a checkpoint between two of their moves, on other
# ranks, with the same bits, and ParaView's files with it
beadswim-layout shape sphere --radius 3 --force 2 --amplitude 0 --direction 3,2,1 --period 400 --viscosity 0.16666667 --density 1 \
  --units lattice --box 72,64,64 --boundary periodic --position 50,32,32 >sphere.json
towed="--cells-per-radius 3 --relaxation-time 1 --refine 1 --flow-every 0.5"
run small 2 sphere.json -o whole.h5md $towed --cycles 2
has_status 0
mv out whole.json
check 'the level has not moved across the seam' holds '.resolution.levels[1].boxes[0].upper[0] > 100' whole.json
run small 3 sphere.json -o part.h5md $towed --cycles 0.83 --checkpoint-every 0.83
has_status 0
run small 1 --restart part.h5md --cycles 2
has_status 0
mv out part.json
check 'the record is that of an unbroken run' \
  test "$(jq 'del(.cost)' whole.json)" = "$(jq 'del(.cost)' part.json)"
check 'all datasets are those of an unbroken run' h5diff whole.h5md part.h5md
check 'flow fields too' diff -rq whole.h5md.flow part.h5md.flow
check 'there are not two levels at four times' test "$(ls whole.h5md.flow/*-[01].vti | wc -l)" -eq 8
check 'the finest level is not drawn in the box' \
  grep -qE 'Origin="(-1?[0-9]|[0-6]?[0-9]) [-0-9]+ [-0-9]+" Spacing="1 ' whole.h5md.flow/*800-1.vti
check 'the coarsest level is not drawn in the box' grep -q 'Origin="0 0 0" Spacing="2 ' whole.h5md.flow/*800-0.vti
check 'and their list' test "$(grep -c 'part="1"' whole.h5md.flow.pvd)" -eq 4

# --- refused before work begins, with what would work
beadswim-layout swimmer --preset paper-single --box 264,192,192 --boundary periodic --position 120,96,96 --period 4800 >odd.json
refuses 'refine: .*do not fit.*use at most 2' beadswim-run odd.json -o x.h5md $settings --refine 3
refuses 'refine: .*coarsest would have only 25 steps per period; use at most 3' beadswim-run wide.json -o x.h5md $settings --refine 4
refuses 'use off, auto, or a whole number' beadswim-run wide.json -o x.h5md --refine few
refuses 'use off, auto, or a whole number from 1 to 5' beadswim-run wide.json -o x.h5md --refine 6
refuses 'refine: the setting applies to the lattice only' beadswim-run wide.json -o x.h5md --model rpy --refine 1
beadswim-layout swimmer --preset paper-single --box 160,96,96 --boundary no-slip --position 80,12,48 --period 400 >walled.json
refuses 'refine: .*walls; use --refine off' beadswim-run walled.json -o x.h5md $settings --refine 1
beadswim-layout shape sphere --radius 3 --force 2 --amplitude 0 --direction 1,0,0 --period 400 --viscosity 0.16666667 --density 1 \
  --units lattice --box 90,60,60 --boundary free-slip --position 30,30,30 >towards.json
run beadswim-run towards.json -o x.h5md --cells-per-radius 3 --relaxation-time 1 --refine 1 --cycles 9 --progress none
has_status 3
err_has 'too close to a coarser level of cells'

# --- the page about levels

results=$BEADSWIM_SOURCE/docs/results
check "the page has the records' table" cmp -s <(jq -rs -f "$results/refinement.jq" "$results/refinement.jsonl") \
  <(sed -n '/^<!-- from refinement.jsonl -->$/,/^$/p' "$BEADSWIM_SOURCE/docs/refinement.md" | sed '1d;$d')

finish
