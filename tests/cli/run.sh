#!/bin/bash
# Tests beadswim-run with the lattice model: a small scene on several ranks, its output files, its exit statuses, and refused
# input.
source "$(dirname "$0")/harness.sh"

small() {
  beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic "$@"
}
# Checks in two run records the ratio of each arm amplitude in the last cycle, RUN divided by OTHER. CONDITION is the jq text
# after the ratio, such as "> 1".
stroke_over() { # OTHER RUN CONDITION
  jq -se "map(.swimmers[0].cycles[-1].arm_amplitudes) | [.[1], .[0]] | transpose | map(.[0] / .[1] $3) | all" \
    "$1" "$2" >/dev/null
}
quiet=(--cycles 2 --progress none --no-provenance)
small --period 100 --amplitude 0.02 >layout.json

# --- what it says of itself
accepts beadswim-run --help
for flag in output model cycles frames-per-cycle cells-per-radius relaxation-time bead-boundary delay-correction radius-correction lubrication friction precision time-limit flow-every progress; do
  out_has "--$flag"
done
accepts beadswim-run --version
out_has '^beadswim-run [0-9]+\.[0-9]+\.[0-9]+ \(.+\)$'

# --- the same files on 1 and 2 ranks, from a file and from a pipe: record, trajectory, flow. seams_test compares the states of all
# schemes and precisions on 1 to 4 ranks, beads that collide too
run beadswim-run layout.json -o 1.h5md "${quiet[@]}" --flow-every 1
has_status 0
err_empty
cp out 1.json
run mpirun -n 2 beadswim-run - -o 2.h5md "${quiet[@]}" --flow-every 1 <layout.json
has_status 0
check "2 ranks end in another record" cmp -s out 1.json
check "2 ranks write another trajectory" cmp -s 1.h5md 2.h5md
check "2 ranks write another flow" cmp -s 1.h5md.flow/000000200.vti 2.h5md.flow/000000200.vti
check "the pvd names its files" grep -q 'file="1.h5md.flow/000000200.vti"' 1.h5md.flow.pvd
check "the index for ParaView names the trajectory, and all 81 frames" \
  test "$(grep -c '<Grid Name="beads">' 2.h5md.xdmf2)" -eq 81 -a "$(grep -c '>2.h5md:/particles/beads/radius<' 2.h5md.xdmf2)" -eq 1
well_formed 2.h5md.xdmf2
check "no .part file is left" test -z "$(ls ./*.part 2>/dev/null)"

run bash -c 'beadswim-run layout.json -o 1.h5md --cycles 0.1 2>/dev/full'
has_status 0
run bash -c 'beadswim-run --no-such-flag 2>/dev/full'
has_status 2
run bash -c 'beadswim-run layout.json -o closed.h5md --cycles 0.1 --progress none | true; exit ${PIPESTATUS[0]}'
has_status 3
check "the trajectory is whole although nobody read the record" test -s closed.h5md

# --- names: of any characters in the indices for ParaView; those that it cannot open; those that leave no room for others
run beadswim-run layout.json -o 'a&<b"c.h5md' "${quiet[@]}" --flow-every 1
has_status 0
check "a warning of the name" test "$(grep -c ParaView err)" -eq 0
command_line="the indices of a&<b\"c.h5md"
check "they do not name the files" python3 - <<'PYTHON'
import glob, xml.etree.ElementTree as xml
pvd, xdmf = (xml.parse('a&<b"c.h5md' + ending) for ending in (".flow.pvd", ".xdmf2"))
files = sorted(data.get("file") for data in pvd.iter("DataSet"))
assert files == sorted(glob.glob('a&<b"c.h5md.flow/*.vti')) and files, files
assert 'a&<b"c.h5md:/particles/beads/radius' in [item.text for item in xdmf.iter("DataItem")]
PYTHON
for name in 'λ.h5md' 'a:b.h5md' 'a\b.h5md' ' a.h5md' '~a.h5md'; do
  run beadswim-run layout.json -o "$name" --model rpy --cycles 1 --progress none
  has_status 0
  err_has 'warning: ParaView cannot open the name .*; give another name with -o'
  check "an index that ParaView does not open" test ! -e "$name.xdmf2"
done
long() { printf 'x%.0s' $(seq $(($1 - 5))); echo .h5md; }
for length in 220 256; do
  for model in "--model rpy" "--flow-every 0.5"; do
    refuses '--output: .*cannot be created: File name too long' beadswim-run layout.json -o "$(long $length)" $model --cycles 1
  done
done
run bash -c 'jq -c "., ." layout.json | beadswim-run - --model rpy -o "'"$(long 245)"'{}.h5md"'
has_status 2
err_has '--output: .*cannot be created: File name too long'
run beadswim-run layout.json -o "$(long 210)" --flow-every 0.5 --checkpoint-every 0.5 --cycles 1 --progress none
has_status 0
check "no index" test -s "$(long 210).xdmf2" -a -s "$(long 210).flow.pvd"
mkdir elsewhere
ln -s elsewhere/target.h5md link.h5md
for again in 1 2; do
  run beadswim-run layout.json -o link.h5md --model rpy --cycles 1 --progress none
  check "the link is followed" test -L link.h5md -a -s elsewhere/target.h5md -a ! -L elsewhere/target.h5md
done
run beadswim-run layout.json -o short.h5md --model rpy --cycles 0.001 --progress none
has_status 0
err_has 'warning: the run is too short for a complete cycle of 1 of 1 swimmers, .*; run 1 cycles or more'
check "the record says it, too" holds '.warnings | any(.code == "no-cycle")' out
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 | beadswim-layout defect frequency --sigma 0.2 --seed 2 >slow.json
run beadswim-run slow.json -o slow.h5md --model rpy --cycles 1 --progress none
needed=$(sed -n 's/.* of [1-3] of 4 swimmers, .*; run \([0-9.]*\) cycles or more/\1/p' err)
run beadswim-run slow.json -o slow.h5md --model rpy --cycles "$needed" --progress none
check "the cycles that it asks for are too few" holds '.swimmers | all(.cycles | length > 0)' out
check "there is a warning" test "$(grep -c 'too short' err)" -eq 0

# --- the record
check "status" test "$(jq -r .status 1.json)" = finished
check "two cycles" test "$(jq '.swimmers[0].cycles | length' 1.json)" = 2
check "no cost or provenance" test "$(jq 'has("cost") or has("provenance")' 1.json)" = false
check "momentum is conserved" holds '.momentum.total | map(fabs < 1e-14) | all' 1.json
check "mass is conserved" holds '.mass_relative_change | fabs < 1e-14' 1.json
run beadswim-run layout.json -o 1.h5md --cycles 1 --progress none
check "cost" holds '.cost.cell_updates == 32*16*16*100 and .cost.ranks == 1 and .cost.mlups > 0' out
check "provenance names the programs in order" \
  test "$(jq -r '[.provenance[].program] | join(" ")' out)" = "beadswim-layout beadswim-run"
valid run out

# --- resolution: another number of cells answers in the same units
run beadswim-run layout.json -o fine.h5md --cycles 1 --cells-per-radius 3 --progress none
has_status 0
check "cell size" holds '.resolution.cell_size * 3 - 2 | fabs < 1e-12' out
check "whole steps" holds '.resolution.time_step * .resolution.steps_per_cycle - 100 | fabs < 1e-9' out

# --- single precision: the same physics, and a word before it where that ends
small --period 200 --amplitude 0.2 >strong.json
for precision in double single; do
  run mpirun -n 2 beadswim-run strong.json -o $precision.h5md --cycles 2 --precision $precision --progress none
  has_status 0
  err_empty
  cp out $precision.json
done
jq -s 'map(.swimmers[0].cycles[-1])' double.json single.json >both.json
check "the velocity is that of double precision" \
  holds '(.[1].velocity[0] / .[0].velocity[0] - 1 | fabs) as $e | $e < 0.002 and $e > 0' both.json
check "the stroke is that of double precision" \
  holds '[.[1].arm_amplitudes, .[0].arm_amplitudes] | transpose | map(.[0] / .[1] - 1 | fabs < 0.002) | all' both.json
check "the precision is on record" test "$(jq -r .resolution.precision single.json)" = single
small --period 200 --amplitude 1e-4 >slow.json
run beadswim-run slow.json -o slow.h5md --cycles 0.1 --precision single --progress none
has_status 0
err_has 'warning: in single precision the relative error of a swimmer.s velocity may be .*: .* --precision double'
small --period 200 --amplitude 0.2 --phase 0 >scallop.json
run beadswim-run scallop.json -o scallop.h5md --cycles 0.1 --precision single --progress none
err_has 'more than 1, because the velocity is zero to second order'
run beadswim-run slow.json -o slow.h5md --cycles 0.1 --progress none
err_empty
small --period 200 --amplitude 1e-6 >slower.json
run beadswim-run slower.json -o slow.h5md --cycles 0.1 --progress none
err_has 'so little per cycle that roundoff may cause a relative error of its velocity of '

# --- interpolated links: another law at the bead, nearly the same swimmer, on record
run mpirun -n 2 beadswim-run strong.json -o cli.h5md --cycles 2 --bead-boundary cli --progress none
has_status 0
err_empty
cp out cli.json
check "multireflection is the default" test "$(jq -r .resolution.bead_boundary double.json)" = mr
check "the scheme is on record" test "$(jq -r .resolution.bead_boundary cli.json)" = cli
check "the stroke is another one, and near" stroke_over double.json cli.json '- 1 | fabs | . > 0.001 and . < 0.05'
small --period 150 >even.json
refuses 'relaxation-time: the relaxation time 0.875 makes the correction of multireflection .* undefined' beadswim-run even.json -o x.h5md --bead-boundary mr \
  --relaxation-time 0.875
run beadswim-run strong.json -o psm.h5md --cycles 2 --bead-boundary psm --progress none
has_status 0
check "saturated cells give another stroke, and near" stroke_over cli.json out '- 1 | fabs | . > 1e-5 and . < 0.1'

# --- corrections: on record; without them a cli bead is smaller, and so swings more, and lighter
check "the bead is larger for cli, which makes it seem too small" \
  holds '.resolution | .radius_on_lattice > 1.01 * .cells_per_radius' cli.json
run beadswim-run strong.json -o smaller.h5md --cycles 2 --bead-boundary cli --radius-correction off --progress none
has_status 0
check "the radius on the lattice is the layout's" holds '.resolution | .radius_on_lattice == .cells_per_radius' out
check "the stroke is larger" stroke_over cli.json out '| . > 1.005 and . < 1.1'
check "the bead is denser by 9 nu t_d/(2 R^2)" \
  holds '.resolution | .kinematic_viscosity_lattice as $nu
    | .density_on_lattice - 1 - 4.5 * $nu * (1 + 4.5 * $nu) / (.cells_per_radius * .cells_per_radius) | fabs | . < 1e-9' cli.json
run beadswim-run strong.json -o lighter.h5md --cycles 2 --bead-boundary cli --delay-correction off --progress none
has_status 0
check "the density on the lattice is the layout's" holds '.resolution.density_on_lattice == 1' out
check "the stroke is another one" stroke_over cli.json out '- 1 | fabs | . > 1e-5 and . < 0.2'
# In coarse steps, a hundred a cycle, the delay is 5 of them: strokes are right with its correction alone.
beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 >coarse.json
beadswim-theory coarse.json --method inertia-corrected >coarse-theory.json
stroke_is_right() { # off|on   within 3 %: such steps leave an error of 2.2 % with the correction, of 5 to 7 % without it
  run beadswim-run coarse.json -o coarse.h5md --bead-boundary psm --cells-per-radius 2 --relaxation-time 3 --cycles 3 \
    --delay-correction "$1" --progress none
  has_status 0
  cp out coarse-run.json
  run beadswim-compare coarse-run.json coarse-theory.json --quantity arm_amplitudes --tolerance 0.03
}
stroke_is_right on
has_status 0
stroke_is_right off
has_status 1
# Whether beads are too light for the coupling goes by their density on the lattice.
small --period 100 --amplitude 0.02 --bead-density 0.2 >light.json
run beadswim-run light.json -o light.h5md --cycles 0.1 --progress none
has_status 0
err_empty
run beadswim-run light.json -o light.h5md --cycles 0.1 --progress none --delay-correction off
err_has 'warning: the beads. density on the lattice is 0.2 times the fluid'

# --- stopped early on purpose: results are there, and exit status 4
small --period 100 --amplitude 0,1e4 --stiffness 1e-6 >wild.json
run mpirun -n 2 beadswim-run wild.json -o wild.h5md --progress none
has_status 4
check "status" test "$(jq -r .status out)" = stopped-speed
err_has 'bead [123] of swimmer 0 .* above the limit of 0.5'
check "the trajectory is whole" test -s wild.h5md
run beadswim-run layout.json -o long.h5md --cycles 1e5 --time-limit 1 --progress json
has_status 4
check "status" test "$(jq -r .status out)" = stopped-time
err_has 'time limit of 1 s is reached'
err_has '^\{"step":[0-9]+,.*"seconds_left":'

beadswim-run layout.json -o long.h5md --cycles 1e5 --progress none >out 2>err &
for _ in $(seq 100); do [ -s long.h5md.part ] && break; sleep 0.1; done
sleep 1  # well into the run
command_line="kill -TERM (a running beadswim-run)"
kill -TERM $!
wait $!
status=$?
has_status 4
check "status" test "$(jq -r .status out)" = stopped-signal
check "the trajectory is whole" test ! -e long.h5md.part

# A fault in the last steps, between two looks of the guards, still stops the run.
run mpirun -n 2 beadswim-run wild.json -o wild.h5md --cycles 0.09 --progress none
has_status 4

# --- failed: all ranks stop with the reason, exit status 3, and what there is up to the fault is kept
small --period 4000 --amplitude 1,0 --phase 0 --stiffness 1e-3 >torn.json
for ranks in 1 2; do
  run timeout 120 mpirun -n $ranks beadswim-run torn.json -o torn$ranks.h5md --progress none --no-provenance
  has_status 3
  err_has 'step [0-9]+ \(cycle [0-9.]+, largest Mach number of a bead [0-9.e-]+\): the arm from bead [12] of swimmer 0 at \(.*\) to bead [23] is torn: its length is .* the rest length, above .* stiffer springs'
  cp out torn$ranks.json
done
check "1 and 2 ranks fail alike" cmp -s torn1.json torn2.json
check "with the same frames" cmp -s torn1.h5md torn2.h5md
check "status, reason, no final state" \
  holds '.status == "failed" and (.reason | test("torn")) and .state_sha256 == null' torn1.json
# Instability shows first in a bead's speed, and is called by its name.
small --bead-density 0.3 --period 400 --amplitude 0.1 >unstable.json
run timeout 120 mpirun -n 2 beadswim-run unstable.json -o unstable.h5md --progress none --delay-correction off \
  --relaxation-time 0.6
has_status 4
err_has 'bead [123] of swimmer 0 at .* limit of 0.5 cells per step; .* too low for the explicit coupling of beads and fluid; use --delay-correction on'

# --- beads that collide: they touch, are not pressed into each other, and nothing is lost
small --period 400 --amplitude 1.3 --stiffness 0.12 >collide.json
run beadswim-run collide.json -o collide.h5md --cycles 2 --progress none --no-provenance
has_status 0
check "beads come as near as beads do in a film" holds '.near_contact.smallest_gap | . < 0.02 and . > -0.05' out
run beadswim-run collide.json -o dry.h5md --cycles 2 --lubrication off --friction 0 --progress none
has_status 0
check "without the film they touch" holds '.near_contact | .smallest_gap < 0 and .smallest_gap > -0.2 and .normal_cut_off == 0' out
check "the record says so" holds '.near_contact | .lubrication == false and .friction == 0' out
check "beads that stay apart have no gap on record" holds '.near_contact.smallest_gap == null' 1.json

# --- refusals leave nothing behind
refuses 'relaxation-time: the relaxation time 0.5 is not above 0.5' beadswim-run layout.json -o x.h5md --relaxation-time 0.5
refuses 'cannot be created' beadswim-run layout.json -o no/such/folder/x.h5md
refuses 'cannot be read' beadswim-run missing.json -o x.h5md
refuses '--model: unknown value "lbn"; did you mean "lbm"\? Valid values: lbm, rpy, rpy\+near, multipole, unsteady, oseen, auto' \
  beadswim-run layout.json -o x.h5md --model lbn
refuses '--frames-per-cycle: "3": the value must be a whole number from 4 to 1000000' \
  beadswim-run layout.json -o x.h5md --frames-per-cycle 3
refuses 'did you mean --cycles' beadswim-run layout.json -o x.h5md --cycels 3
refuses 'output' beadswim-run layout.json
refuses 'may cover no cell' beadswim-run layout.json -o x.h5md --cells-per-radius 0.5
refuses 'not a whole number; the nearest' beadswim-run layout.json -o x.h5md --cells-per-radius 2.3
refuses 'a period has 1 steps' beadswim-run layout.json -o x.h5md --relaxation-time 300
refuses "the force of the fluid is late by a phase of" beadswim-run layout.json -o x.h5md --relaxation-time 12
for scheme in mr cli staircase; do
  refuses 'use 0.52 or more, or --bead-boundary psm' \
    beadswim-run layout.json -o x.h5md --relaxation-time 0.515 --bead-boundary $scheme
done
refuses 'not the name of a file' beadswim-run layout.json -o ./
mkfifo pipe
refuses 'exists and is not a regular file' beadswim-run layout.json -o pipe
refuses 'not the name of a file' beadswim-run layout.json -o -
refuses 'the output would replace the input file' beadswim-run layout.json -o layout.json
exec 9>x.h5md.part
flock 9
refuses 'being written by another run' beadswim-run layout.json -o x.h5md
exec 9>&-
rm x.h5md.part
refuses 'cycles: ' beadswim-run layout.json -o x.h5md --cycles 1e300
touch x.h5md.flow
refuses 'flow-every: the folder' beadswim-run layout.json -o x.h5md --flow-every 1 --progress none
rm x.h5md.flow
beadswim-layout swimmer --preset paper-single --box 6000,4000,4000 >huge.json
refuses 'GB more than this machine has; use --precision single, .*beadswim-layout reduce.*, --model rpy \(without cells\) or more machines' beadswim-run huge.json -o x.h5md
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary no-slip \
  --position 16,2.2,8 >wall.json
refuses '/swimmers/0/position: bead 1 has a gap of 0.2 to a wall perpendicular to y' beadswim-run wall.json -o x.h5md
beadswim-layout swimmer --preset paper-single --unbounded >open.json
refuses '/domain: the domain is null' beadswim-run open.json -o x.h5md
head -c 100 layout.json >cut.json
refuses 'cut.json' beadswim-run cut.json -o x.h5md
check "a refused run leaves nothing behind" test -z "$(ls x.h5md* 2>/dev/null)"
run mpirun -n 2 beadswim-run cut.json -o x.h5md
has_status 2
check "the ranks speak with one voice" test "$(grep -c '^beadswim-run: ' err)" = 1

finish
