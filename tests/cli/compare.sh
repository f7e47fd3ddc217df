#!/bin/bash
# Tests beadswim-compare: the verdict as exit status, the choice of the method that determines the verdict, and refused input.
source "$(dirname "$0")/harness.sh"
stored_documents

judged() { # STATUS COMMAND...   a comparison that was made: verdict on standard output, table on standard error
  local wanted=$1
  shift
  run "$@"
  has_status "$wanted"
  out_has '"schema": "beadswim/verdict/1"'
  err_has '^verdict: '
}
holds() { # JQ-EXPRESSION   of the verdict in out
  check "not true of the verdict: $1" test "$(jq "$1" out)" = true
}
edited() { jq "$2" "$1"; } # FILE JQ-EDIT

# --- what it says of itself
accepts beadswim-compare --help
for flag in reference method quantity tolerance cycle allow-difference; do out_has "^  --$flag"; done
accepts beadswim-compare --version
refuses '--tolerance: "5": the value must be a number above 0 and below 1; 0.05 means 5 %' \
  beadswim-compare run.json prediction.json --tolerance 5
refuses '--tolerance: "5%": the value must be a number above 0 and below 1; 0.05 means 5 %; write 5 % as 0.05' \
  beadswim-compare run.json prediction.json --tolerance 5%

# --- the verdict is the exit status
judged 0 beadswim-compare run.json prediction.json
holds '.pass and .decided_by == "multipole-ode"'
holds '[.rows[].method] | unique | length == 4'
holds '.cost.core_seconds == 200 and .cost.wall_seconds == 100'
err_has '^velocity +7.25e-05 +7e-05 +multipole-ode +\+3.57 % +pass$'
judged 1 beadswim-compare run.json prediction.json --tolerance 0.03
holds '.pass == false'
err_has 'verdict: FAIL, decided by multipole-ode, tolerance 3 %'
judged 1 beadswim-compare run.json prediction.json --tolerance 1e-12
judged 0 beadswim-compare run.json run.json --tolerance 1e-12
holds '.decided_by == "run" and all(.rows[]; .relative_error == 0 and .decides)'

# --- who decides
judged 1 beadswim-compare run.json prediction.json --method oseen-force-closed
holds '.decided_by == "oseen-force-closed"'
holds 'all(.rows[]; .decides == (.method == "oseen-force-closed"))'
judged 0 beadswim-compare run.json prediction.json --tolerance 0.999
holds 'all(.rows[]; .usable or (.decides | not))'
judged 0 beadswim-compare run.json run.json --reference prediction.json
holds '.decided_by == "run" and ([.rows[].method] | unique | length == 5)'
judged 1 beadswim-compare run.json run.json --reference prediction.json --method rpy-perturbation --tolerance 0.04
edited prediction.json '.predictions |= map(.usable = false)' >unusable.json
refuses 'unusable.json: the prediction contains no usable method' beadswim-compare run.json unusable.json
refuses '--method: the method "rpy-force-printed" is marked unusable' \
  beadswim-compare run.json prediction.json --method rpy-force-printed
refuses '--method: no reference contains the method "multipole-od"; did you mean "multipole-ode"' \
  beadswim-compare run.json prediction.json --method multipole-od

# --- a long table has what decides and the best three; --all has all rows
jq '.predictions |= (. + [.[] | .method += "-b"] + [.[] | .method += "-c"])' prediction.json >many.json
run beadswim-compare run.json many.json --method multipole-ode
check "the short table has $(grep -c '^velocity' err) rows of the velocity" test "$(grep -c '^velocity' err)" -eq 4
err_has '^[0-9]+ rows, of methods with larger errors, are not shown; --all shows them$'
err_has '^error: run minus reference, relative to the reference, ± the uncertainty of both; verdicts in parentheses do not count$'
rows=$(jq '.rows | length' out)
run beadswim-compare run.json many.json --method multipole-ode --all
check "all rows" test "$(grep -cE '^(velocity|arm|sin)' err)" -eq "$rows"

# --- which numbers
judged 0 beadswim-compare run.json prediction.json --quantity arm_amplitudes,sin_phase_shift --tolerance 0.03
holds '[.rows[] | select(.decides) | [.quantity, .arm]] == [["arm_amplitudes", 1], ["arm_amplitudes", 2], ["sin_phase_shift", null]]'
judged 0 beadswim-compare run.json run.json --quantity velocity_y,arm_phases
holds '[.rows[] | [.quantity, .arm]] == [["velocity_y", null], ["arm_phases", 1], ["arm_phases", 2]]'
valid verdict out
err_has '^arm phase delta2 '
edited run.json '.swimmers[0].cycles[].velocity[1] += 1e-3' >aside.json
judged 1 beadswim-compare aside.json run.json --quantity velocity,speed_along_axis,speed_across_axis
holds '[.rows[] | [.quantity, .pass]] == [["velocity", false], ["speed_along_axis", true], ["speed_across_axis", false]]'
holds '(.rows[2].run / 1e-3 - 1 | fabs) < 1e-9'
valid verdict out
judged 0 beadswim-compare run.json prediction.json --cycle 1 --quantity velocity
holds '.rows[0].run == 6.9e-5'
judged 0 beadswim-compare run.json prediction.json --cycle mean:2 --quantity velocity
holds '(.rows[0].run / 7.225e-5 - 1 | fabs) < 1e-12'
edited run.json '.swimmers[0].cycles[].velocity[0] += 1e-3 | .swimmers[0].cycles[].mean_flow[0] += 1e-3' >carried.json
judged 0 beadswim-compare carried.json run.json --tolerance 1e-10
edited carried.json '.domain.boundary[0] = "no-slip"' >walled.json
judged 1 beadswim-compare walled.json run.json --quantity velocity --allow-difference domain
edited run.json '.swimmers += [.swimmers[0] | .id = 1 | .cycles[].velocity[0] *= 2]' >two.json
judged 0 beadswim-compare two.json prediction.json
holds '[.rows[].swimmer] | unique == [0]'
judged 0 beadswim-compare two.json two.json
holds '[.rows[].swimmer] | unique == [0, 1]'
refuses 'run.json: the run record contains no swimmer with the id 1; the ids in the record are 0$' \
  beadswim-compare run.json two.json --allow-difference swimmers

# --- one swimmer
judged 0 beadswim-compare two.json two.json --swimmer 1
holds '[.rows[].swimmer] | unique == [1]'
judged 0 beadswim-compare two.json prediction.json --swimmer 0
refuses 'two.json: the run record contains no swimmer with the id 7; the ids in the record are 0, 1$' \
  beadswim-compare two.json two.json --swimmer 7
refuses 'the ids in the record are 0, 1$' beadswim-compare two.json prediction.json --swimmer 7
refuses '--swimmer: "-1"' beadswim-compare two.json two.json --swimmer -1
refuses '^beadswim-compare: prediction.json: the predictions are for swimmer 0, and not valid for swimmer 1; predict with beadswim-theory --swimmer 1$' \
  beadswim-compare two.json prediction.json --swimmer 1

# --- the table of swimmers and cycles
table() { # FILE COLUMNS...   these columns of a table, by the names in its first line
  python3 -c 'import csv, sys
for row in csv.DictReader(open(sys.argv[1])): print(*[row[name] for name in sys.argv[2:]])' "$@"
}
accepts beadswim-compare two.json --table table.csv
out_empty
check 'a row per swimmer and cycle, with the numbers of the record' cmp <(table table.csv swimmer cycle 'arm_amplitudes_2 (lattice units)') \
  <(jq -r '.swimmers[] | .id as $id | .cycles[] | "\($id) \(.index) \(.arm_amplitudes[1])"' two.json)
check 'velocity' test "$(table table.csv 'velocity (lattice units)' 'speed_along_axis (lattice units)' | sed -n 3p)" = '7.25e-05 7.25e-05'
check 'nothing where nothing is known' test -z "$(table table.csv type dipole | tr -d ' \n')"
accepts beadswim-compare two.json --swimmer 1 --table -
check 'the rows of one swimmer' cmp out <(grep -E '^(swimmer|1),' table.csv)
{ jq -c '.study = {kind: "a, b"}' two.json; echo '{"schema": "beadswim/failure/1", "program": "beadswim-run", "reason": "why", "exit": 3}'
  jq -c '.study = {kind: "c", period: 2}' run.json; } >runs.jsonl
run beadswim-compare runs.jsonl --table -
has_status 0
err_has '^beadswim-compare: 1 of 3 documents have no result, and are left out$'
check 'runs and their studies' test "$(table out run kind period swimmer cycle | sed -n '6,7p' | tr '\n' ';')" = 'runs.jsonl line 1 a, b  1 3;runs.jsonl line 3 c 2 0 1;'
refuses '--table: the file name "table.txt" does not end in .csv' beadswim-compare two.json --table table.txt
refuses '--cycle: the flag cannot be combined with --table; remove one of the two flags' \
  beadswim-compare two.json --table table.csv --cycle 2
refuses 'prediction.json:/schema: the document is a prediction' beadswim-compare prediction.json --table -
refuses 'the ids in the record are 0, 1$' beadswim-compare two.json --table - --swimmer 2
cp two.json two.csv
refuses 'two.csv: the output would replace the input file' beadswim-compare two.csv --table two.csv

edited run.json 'del(.cost)' >free.json
judged 0 beadswim-compare free.json prediction.json
holds '.cost == null'
judged 0 beadswim-compare run.json free.json prediction.json
holds '[.rows[].run_file] | unique == ["free.json", "run.json"]'
err_has '^free.json, swimmer 0:$'

# --- the scenes of run and reference
cat >scene.json <<'END'
{"fluid": {"density": 1, "kinematic_viscosity": 0.25},
 "domain": {"lengths": [120, 80, 80], "boundary": ["periodic", "periodic", "periodic"]},
 "types": {"a": {"beads": [{"radius": 4, "density": 1}, {"radius": 4, "density": 1}, {"radius": 4, "density": 1}],
   "springs": [{"stiffness": 0.1, "rest_length": 20, "damping": 0}, {"stiffness": 0.1, "rest_length": 20, "damping": 0}],
   "angular_stiffness": 100, "driving": {"amplitude": [0.3, 0.3], "phase": 1.5, "period": 4800}}},
 "swimmers": [{"id": 0, "type": "a", "position": [60, 40, 40], "axis": [1, 0, 0]}]}
END
with_scene() { jq --slurpfile scene scene.json '.scene = $scene[0]' "$1"; }
with_scene run.json >scene-run.json
with_scene prediction.json >theory.json
for pair in 'scene-run theory' 'scene-run prediction' 'run theory'; do # with and without scenes
  judged 0 beadswim-compare "${pair% *}.json" "${pair#* }.json"
  holds '.scene_differences == []'
done
edited theory.json '.scene.swimmers[0].position = [100, 1, 2]' >moved.json
judged 0 beadswim-compare scene-run.json moved.json
edited theory.json '.scene.domain = null | .scene.types.a.driving.amplitude = [0.2, 0.3]' >other.json
made_otherwise() { # RUN DIFFERENCES NAMES   the complete message
  echo "the reference was not made from the layout of the run $1: $2; compare files made from the same layout, or allow differences with --allow-difference $3\$"
}
amplitude='amplitude 0.2, 0.3 instead of 0.3'
domain='domain open space instead of 120 x 80 x 80, periodic, periodic, periodic'
refuses "^beadswim-compare: other.json: $(made_otherwise scene-run.json "$amplitude; $domain" amplitude,domain)" \
  beadswim-compare scene-run.json other.json
refuses "^beadswim-compare: other.json: $(made_otherwise scene-run.json "$amplitude" amplitude,domain)" \
  beadswim-compare scene-run.json theory.json --reference other.json --allow-difference domain
judged 0 beadswim-compare scene-run.json other.json --allow-difference amplitude,domain,fluid
holds '.scene_differences == [{name: "amplitude", run: "0.3", reference: "0.2, 0.3"},
  {name: "domain", run: "120 x 80 x 80, periodic, periodic, periodic", reference: "open space"}]'
err_has '^allowed difference: amplitude: run 0.3, reference 0.2, 0.3$'
err_has '^allowed difference: domain: run 120 x 80 x 80, periodic, periodic, periodic, reference open space$'
judged 0 beadswim-compare scene-run.json scene-run.json other.json --allow-difference=domain --allow-difference amplitude
holds '.scene_differences | length == 2'
judged 1 beadswim-compare --allow-difference amplitude,domain scene-run.json other.json --tolerance 0.03
refuses "^beadswim-compare: prediction_shorter_period.json: $(made_otherwise run.json 'period 2000 instead of 4800' period)" \
  beadswim-compare run.json prediction_shorter_period.json
judged 0 beadswim-compare run.json prediction_shorter_period.json --tolerance 0.99 --allow-difference period
refuses '^beadswim-compare: --allow-difference: unknown value "amplitud"; did you mean "amplitude"\? Valid values: period, amplitude, .*, swimmers, placing$' \
  beadswim-compare scene-run.json other.json --allow-difference amplitud
edited scene-run.json '.scene.swimmers[0].type = "b"' >fault.json
refuses '^beadswim-compare: the scene in fault.json:/swimmers/0/type: ' beadswim-compare fault.json theory.json

# --- pipes
same_bytes 'beadswim-compare - prediction.json <run.json | sed "s/standard input/run.json/"' 'beadswim-compare run.json prediction.json'
same_bytes 'beadswim-compare run.json - <prediction.json | sed "s/standard input/prediction.json/"' 'beadswim-compare run.json prediction.json'
refuses 'standard input can be read only once' beadswim-compare - -

# --- what it refuses
refuses 'no file is given' beadswim-compare
refuses 'one file is given' beadswim-compare run.json
refuses 'run.h5md: the file cannot be read' beadswim-compare run.json run.h5md
echo '{ "schema": "beadswim/layout/1" }' >layout.json
refuses 'layout.json:/schema: the document is a layout' beadswim-compare layout.json prediction.json
refuses 'layout.json: the document has the schema "beadswim/layout/1"; a run record .* or a prediction' beadswim-compare run.json layout.json
echo '[]' >list.json
refuses 'list.json: the document has no key "schema"' beadswim-compare run.json list.json
edited run.json '.units = {length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}' >si.json
judged 0 beadswim-compare si.json si.json
refuses 'run.json: the reference has other units of length, time or mass than si.json' beadswim-compare si.json run.json
refuses 'run.json: the units of this file differ from the units of si.json' beadswim-compare si.json run.json --table -
accepts beadswim-compare si.json --table -
out_has '"velocity \(um/s\)",.*"power \(pg um²/s³\)","efficiency",'
edited run.json '.status = "failed"' >failed.json
refuses 'failed.json: the file is the record of a failed run' beadswim-compare failed.json --table -
refuses 'failed.json: the file is the record of a failed run' beadswim-compare failed.json prediction.json
edited run.json '.status = "stopped-time"' >stopped.json
judged 0 beadswim-compare stopped.json prediction.json
edited run.json '.swimmers[0].cycles = []' >short.json
refuses 'short.json: the run record contains no complete cycle' beadswim-compare short.json --table -
refuses 'short.json: the run record contains no complete cycle' beadswim-compare short.json prediction.json
edited run.json '.swimmers[0].cycles[0].mean_flwo = 1' >typo.json
refuses 'typo.json:/swimmers/0/cycles/0/mean_flwo: unknown key; did you mean "mean_flow"' \
  beadswim-compare typo.json prediction.json
refuses 'does not contain cycle 4, only cycles 1 to 3' beadswim-compare run.json prediction.json --cycle 4

finish
