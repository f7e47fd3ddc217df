#!/bin/bash
# Tests beadswim-theory: predictions for a swimmer of a layout, from a file, from a pipe and from a stream of layouts.
source "$(dirname "$0")/harness.sh"

paper() { beadswim-layout swimmer --preset paper-single --unbounded "$@"; }

# --- what it says of itself
accepts beadswim-theory --help
for flag in method swimmer stroke-from tolerance jsonl; do out_has "^  --$flag"; done
out_has 'oseen-force-closed'
accepts beadswim-theory --version
out_has '^beadswim-theory [0-9]+\.[0-9]+\.[0-9]+ \(.+\)$'

# --- predictions: file and pipe alike, every method in the table's order
paper >paper.json
accepts beadswim-theory paper.json
valid prediction out
out_has '"schema": "beadswim/prediction/1"'
check "the prediction has not the layout's scene" cmp -s <(jq .scene out) <(jq '{fluid, domain, types, swimmers}' paper.json)
beadswim-layout swarm --preset paper-uniform --blocks 1,5,13 --block-swimmers 1,1,1 | beadswim-theory - --method rpy-ode >many.json
check "the prediction for 65 swimmers has a scene" holds 'has("scene") | not' many.json
# A^2 times 1.9731e-3 of (4.3) and 1.9035e-3 of Rotne-Prager at A = 0.2
out_has '"velocity": 7.892[0-9]+e-05'
out_has '"velocity": 7.614[0-9]+e-05'
check "methods are not those of the table" test "$(grep -oE '"method": "[^"]+"' out | cut -d'"' -f4 | xargs)" = \
  "oseen-force-closed oseen-stroke-closed oseen-ratio-printed oseen-ratio-repaired rpy-force-printed rpy-force-repaired \
rpy-stroke-printed rpy-equal-weight oseen-perturbation rpy-perturbation multipole-perturbation oseen-ode rpy-ode multipole-ode \
unsteady-response unsteady-multipole inertia-corrected"
same_bytes 'beadswim-theory paper.json' 'beadswim-theory <paper.json'
same_bytes 'beadswim-theory paper.json' 'beadswim-layout swimmer --preset paper-single --unbounded | beadswim-theory -'
same_bytes 'beadswim-theory paper.json' 'cd / && LC_ALL=C TZ=UTC beadswim-theory "$OLDPWD/paper.json"'

accepts beadswim-theory --method rpy-perturbation,oseen-force-closed paper.json
check "methods are not those named" test "$(grep -oE '"method": "[^"]+"' out | cut -d'"' -f4 | xargs)" = \
  "rpy-perturbation oseen-force-closed"
refuses '--method: unknown value "rpy-pertubation"; did you mean "rpy-perturbation"' beadswim-theory --method rpy-pertubation paper.json
refuses '"all" stands for all methods and cannot be combined with names' beadswim-theory --method all,rpy-perturbation paper.json

# --- units: lengths in um, so velocities in um/s
beadswim-layout swimmer --radius 4 --arm 20 --stiffness 0.0347 --amplitude 0.2 --period 4800 --viscosity 0.3333333333333333 \
  --density 1 --units um,s,pg --unbounded >units.json
accepts beadswim-theory units.json
valid prediction out
out_has '"velocity": 7.614[0-9]+e-05'
out_has '"length": \{ "name": "um", "si_factor": 1e-06 \}'

# --- what a method cannot treat is left out of all, and an error by name
paper --radius 4,4,5 --damping 0,3 >unequal.json
run beadswim-theory unequal.json
has_status 0
valid prediction out
err_has 'methods left out: oseen-force-closed, .*rpy-equal-weight; reason: the bead radii 4, 4, 5 differ'
check "a closed form treats unequal radii" test "$(jq '[.predictions[].method | select(test("closed|printed|weight"))] | length' out)" -eq 0
check "what was left out is not in the document" test "$(jq '.left_out | length' out)" -eq 8
refuses 'oseen-force-closed: this method cannot treat .* radii 4, 4, 5 differ' beadswim-theory --method oseen-force-closed unequal.json

# --- no motion, no NaN
paper --amplitude 0 >rest.json
accepts beadswim-theory rest.json
valid prediction out
out_has '"velocity": 0.0'
out_has '"uncertainty": null'
paper --amplitude 0,0.2 >one_force.json
run beadswim-theory one_force.json
has_status 0
valid prediction out
err_has 'methods left out: rpy-force-printed; reason: the driving amplitudes 0, 0.2 differ, but the closed form requires equal driving amplitudes' 

# --- orientation: the lab field drives a swimmer along -x backwards, and none across it
accepts beadswim-theory --method rpy-perturbation paper.json
grep -E '"velocity"' out >velocity
paper --axis=-1,0,0 >minus.json
accepts beadswim-theory --method rpy-perturbation minus.json
check "the velocity along the axis differs for -x" cmp -s velocity <(grep -E '"velocity"' out)
paper --axis 1,1,0 >oblique.json
run beadswim-theory oblique.json --method oseen-perturbation
has_status 0
check "across the field the swimmer is a shape with a velocity vector" holds '.predictions[0].velocity_vector | length == 3' out
paper --axis 1,1,0 --frame body >oblique_body.json
accepts beadswim-theory oblique_body.json

# --- several swimmers
second() { # OVERRIDES: paper.json with a second swimmer, id 7
  sed -E 's|("swimmers": \[)(\{ "id": 0, )(.*\})(\],?)$|\1\2\3, { "id": 7, '"$1"'"type": "a", "position": [0, 100, 0], "axis": [1, 0, 0] }\4|'
}
second '' <paper.json >alike.json
accepts beadswim-theory alike.json
out_has '"swimmer": 0'
second '"driving": { "phase": 0.3 }, ' <paper.json >different.json
refuses 'swimmers 0 and 7 differ.*--swimmer ID$' beadswim-theory different.json
accepts beadswim-theory --swimmer 7 different.json
valid prediction out
out_has '"swimmer": 7'
refuses '--swimmer: the layout different.json has no swimmer with the id 3; the ids range from 0 to 7' beadswim-theory --swimmer 3 different.json

# --- a stroke from a run
stored_documents
jq '.domain = null | .swimmers[0].cycles[-1] += {arm_amplitudes: [3, 4], arm_phases: [1.5707963267948966, 0]}' run.json >stroke.json
mv stroke.json run.json
# (4.2): 7 lambda / (24 l^2) d1 d2 omega = 7 x 4 / 9600 x 12 x 2 pi / 4800, of the last cycle
accepts beadswim-theory --method oseen-stroke-closed --stroke-from run.json paper.json
valid prediction out
out_has '"velocity": 4.5814[0-9]+e-05'
out_has '"arm_amplitudes": \[3.0, 4.0\]'
check "the measured stroke is not that of the exact geometry factor too" test "$(beadswim-theory --stroke-from run.json paper.json |
  jq -c '[.predictions[] | select(.arm_amplitudes == [3, 4]) | .method]')" = \
  '["oseen-stroke-closed","oseen-ratio-repaired","rpy-stroke-printed","rpy-equal-weight","multipole-stroke"]'
refuses 'multipole-stroke: .* needs a measured stroke' beadswim-theory --method multipole-stroke paper.json
paper --period 5000 >slower.json
refuses 'the driving period is 4800 in the run but 5000 in the layout' beadswim-theory --stroke-from run.json slower.json
refuses 'none of the named methods uses a measured stroke; add one of oseen-stroke-closed' beadswim-theory --method rpy-perturbation --stroke-from run.json paper.json
refuses 'oseen-stroke-closed: this method cannot treat .* radii' beadswim-theory --method oseen-stroke-closed --stroke-from run.json unequal.json
refuses 'units of length and time differ' beadswim-theory --stroke-from run.json units.json
jq 'del(.swimmers) | .swarm = []' run.json >swarm_run.json
refuses 'swarm_run.json: the run record contains only statistics of the swarm, .*; run a smaller cell of the scene \(beadswim-layout reduce\)' \
  beadswim-theory --stroke-from swarm_run.json paper.json
cat paper.json paper.json >two.json
refuses 'two.json: line [0-9]+, column 1: a second JSON document begins.*write one document per line' beadswim-theory two.json
refuses 'run.json: the run record contains no swimmer with the id 7; the ids in the record are 0$' beadswim-theory --swimmer 7 --stroke-from run.json alike.json
refuses 'paper.json.*the document is a layout \(beadswim-layout\); give a run record' beadswim-theory --stroke-from paper.json paper.json
jq '.swimmers[0].cycles = []' run.json >no_cycle.json
refuses 'has not finished a cycle' beadswim-theory --stroke-from no_cycle.json paper.json

# --- a stream: one layout a line, one document a line
tr -d '\n' <paper.json >lines
echo >>lines
tr -d '\n' <unequal.json >>lines
run beadswim-theory --jsonl lines
has_status 0
err_has 'methods were left out for 1 of 2 layouts'
check "not one document a line" test "$(grep -c '^{"schema":"beadswim/prediction/1".*}$' out)" -eq 2
same_bytes 'beadswim-theory --jsonl lines 2>/dev/null' 'beadswim-theory --jsonl <lines 2>/dev/null'
beadswim-theory --jsonl lines 2>/dev/null | head -1 >first.json
cp first.json out
valid prediction out
echo '{' >>lines
run beadswim-theory --jsonl lines
has_status 2
err_has 'lines line 2'

# --- boxes: periodic, free-slip and along another axis; what theory has no method for
boxed() { beadswim-layout swimmer --preset paper-single --box 120,80,80 "$@"; }
velocity_by() { jq ".predictions[] | select(.method == \"$1\") | .velocity"; }
boxed --boundary periodic >boxed.json
accepts beadswim-theory boxed.json
valid prediction out
check "no box methods for a box" test "$(jq '[.predictions[].method | select(test("box"))] | length' out)" -eq 2
# 0.998 of unbounded, quasi-static, in this box (1.9035e-3 A^2)
check "the box's factor is not 0.998" test "$(velocity_by rpy-box-perturbation <out | jq '. / (1.9035e-3 * 0.04) * 1000 | round')" -eq 998
check "inertia-corrected has no stroke uncertainty" test \
  "$(jq '.predictions[] | select(.method == "inertia-corrected") | .stroke_uncertainty.arm_amplitudes | length' out)" -eq 2
accepts beadswim-theory --method rpy-box-perturbation boxed.json
jq '.predictions[0].velocity' out >velocity
beadswim-layout swimmer --preset paper-single --box 80,120,80 --boundary periodic --axis 0,-1,0 --frame initial-axis >turned.json
accepts beadswim-theory --method rpy-box-perturbation turned.json
check "the swimmer along -y has another velocity" cmp -s velocity <(jq '.predictions[0].velocity' out)
refuses 'rpy-box-ode: .* the fluid of the layout is unbounded' beadswim-theory --method rpy-box-ode paper.json
boxed --boundary no-slip >walls.json
refuses 'inertia-corrected: .* no-slip walls' beadswim-theory --method inertia-corrected walls.json
boxed --boundary periodic --axis 1,1,0 --frame body >aslant.json
refuses 'unsteady-response: .* not parallel to a box axis' beadswim-theory --method unsteady-response aslant.json
second '' <boxed.json | sed 's/\[0, 100, 0\]/[60, 70, 70]/' >shared_box.json
refuses 'rpy-box-perturbation: .* box holds 2 swimmers' beadswim-theory --method rpy-box-perturbation shared_box.json

# --- warnings with numbers: contact within the stroke, driving beyond small amplitude
paper --amplitude 0.6 >collide.json
run beadswim-theory collide.json
has_status 0
valid prediction out
err_has 'warning: beads would touch during the stroke: .* are 10\.[0-9]+ and 15\.[0-9]+, but the gaps .* are 12 and 12'
err_has '12 and 12; lower --amplitude or raise --stiffness, --damping or --arm$'
err_has 'methods left out: .*rpy-ode.*; reason: stroke: no periodic motion without contact .* exceeds about 0\.[0-9]+ times the given amplitude'
check "contact within the stroke is usable" test "$(jq '[.predictions[] | select(.usable)] | length' out)" -eq 0
paper --amplitude 0.4 >large.json
run beadswim-theory --method rpy-perturbation large.json
err_has 'warning: the driving amplitude is not small: .* neglect about \+[0-9.]+ %'
accepts beadswim-theory --method rpy-perturbation --tolerance 0.2 large.json
refuses '--tolerance' beadswim-theory --tolerance 0 paper.json

# --- values beyond the range of arithmetic are refused, never written
for absurd in "--stiffness 1e300" "--viscosity 1e-300" "--arm 1e200" "--amplitude 1e200" "--period 1e-300"; do
  # shellcheck disable=SC2086
  paper $absurd >absurd.json 2>/dev/null || continue
  run beadswim-theory absurd.json
  check "status of $absurd is not 0 or 2" test "$status" -eq 0 -o "$status" -eq 2
  [ "$status" -ne 0 ] || valid prediction out
done

# --- wrong command lines and files
refuses '--no-such-flag: unknown flag' beadswim-theory --no-such-flag
refuses 'swimmer' beadswim-theory --swimmer x paper.json
run bash -c 'beadswim-theory paper.json >/dev/full'
has_status 3

finish
