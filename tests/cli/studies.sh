#!/bin/bash
# Studies: layouts that vary, and streams of documents.
. "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --unbounded >base.json

# --- vary

accepts beadswim-layout vary base.json --over period=1000:4000:3 --over stiffness=0.02,0.05
check 'all combinations, the last quantity first' \
  test "$(jq -c '[.study.period, .study.stiffness]' out | tr '\n' ' ')" = '[1000,0.02] [1000,0.05] [2500,0.02] [2500,0.05] [4000,0.02] [4000,0.05] '
check 'the layouts have these values' holds -s \
  'all(.study.period == .types.a.driving.period and .study.stiffness == .types.a.springs[1].stiffness)' out
check 'the filter is in the provenance' holds -s '.[0].provenance[1].arguments == ["vary", "--over=period=1000:4000:3", "--over=stiffness=0.02,0.05"]' out
accepts beadswim-layout vary base.json --over period=1000:8000:4:log --over phase=0,45deg,90deg,180deg --together
check 'values in step' holds -s 'map(.study.period | round) == [1000, 2000, 4000, 8000]
  and map(.types.a.driving.phase * 180 / 3.141592653589793 | round) == [0, 45, 90, 180]' out

# A flag means what it means for beadswim-layout swimmer.
for flag in radius=5 arm=30 stiffness=0.05 damping=0.1 angular-stiffness=50 bead-density=2 amplitude=0.1 phase=1 period=900 frame=body viscosity=0.2; do
  same_bytes "beadswim-layout vary base.json --over $flag | jq 'del(.study, .provenance)'" \
    "beadswim-layout swimmer --preset paper-single --unbounded --$flag | jq 'del(.provenance)'"
done

accepts beadswim-layout vary base.json --over /types/a/beads/0/radius=3,5 --over /swimmers/0/position/1=0.5
check 'pointers set single values' holds -s 'map(.types.a.beads[0].radius) == [3, 5] and .[0].types.a.beads[1].radius == 4' out
refuses 'base.json with /domain=1, radius=3:/domain: 1: the value must be of type object or null' beadswim-layout vary base.json --over /domain=1 --over radius=3
accepts beadswim-layout vary base.json --over /swimmers/0/driving/phase_offset=0,0.7 --over /swimmers/0/driving/period=900
check 'optional keys are made' holds -s 'map(.swimmers[0].driving | [.period, .phase_offset // 0]) == [[900, 0], [900, 0.7]]' out
beadswim-layout shape purcell-chain --unbounded >chain.json
accepts beadswim-layout vary chain.json --over /types/purcell-chain/beads/0/radius=1,1.5
beadswim-layout vary base.json --over period=1000,2000 >two.jsonl

# A flag of the command that made a layout makes it again; made_by describes the result.
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,1 >made.json
same_bytes "beadswim-layout vary made.json --over core-gap=40 | jq 'del(.study, .provenance)'" \
  "beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,1 --core-gap 40 | jq 'del(.provenance)'"
beadswim-layout shape flagellum --beads 8 --frame body --box 90,90,60 >made.json
check 'made_by has typed parameters' holds '.made_by == {command: "shape flagellum", parameters: {beads: 8, frame: "body", box: [90, 90, 60]}}' made.json
same_bytes "beadswim-layout vary made.json --over beads=6 --over frame=lab | jq 'del(.study, .provenance)'" \
  "beadswim-layout shape flagellum --beads 6 --frame lab --box 90,90,60 | jq 'del(.provenance)'"
for filter in 'vary - --over /fluid/density=2' 'defect jitter --sigma 0.1' 'reduce' 'combine - made.json --at 45,45,30' 'units --to um,s,mg --cell 1um --viscosity 1 --density 1'; do
  check "made_by lies after $filter" test "$(beadswim-layout $filter <made.json 2>err | jq 'has("made_by")')" = false
done
refuses 'made.json: --beads: "2": the value must be a whole number from 3|--beads: "2": the value must be a whole number from 3' beadswim-layout vary made.json --over beads=2
refuses '"core-gap"' beadswim-layout vary made.json --over core-gap=2
# A layout that was changed since is varied as it is, not made again.
beadswim-layout swimmer --preset paper-single | jq '.types.a.beads[1].radius = 3' >edited.json
check 'a changed layout is not made anew' holds '.types.a.beads[1].radius == 3 and (has("made_by") | not)' \
  <(beadswim-layout vary edited.json --over period=1234)
refuses '"box"' beadswim-layout vary edited.json --over box=90
jq '.made_by.command = "swarn"' made.json >bad-made.json
refuses '' beadswim-layout vary bad-made.json --over beads=6

# Opposite values, kept sums and products, rotations
accepts beadswim-layout vary chain.json --over /types/purcell-chain/angles/0/stiffness,/types/purcell-chain/angles/1/stiffness=1,1.5
check 'equal values' holds -s 'map(.types["purcell-chain"].angles | [.[0].stiffness, .[1].stiffness]) == [[1, 1], [1.5, 1.5]]' out
beadswim-layout shape dumbbell --unbounded | jq '.types.dumbbell.driving.forces =
  [{bead: 1, direction: [1, 0, 0], constant: 0.1}, {bead: 2, direction: [1, 0, 0], constant: -0.1}]' >pushed.json
f=/types/dumbbell/driving/forces
accepts beadswim-layout vary pushed.json --over $f/0/constant,-$f/1/constant=0.1,0.3
check 'opposite values' holds -s 'map(.types.dumbbell.driving.forces | [.[0].constant, .[1].constant]) == [[0.1, -0.1], [0.3, -0.3]]' out
refuses 'do not sum to zero' beadswim-layout vary pushed.json --over $f/0/constant=0.3
s=/types/a/springs
accepts beadswim-layout vary base.json --over $s/0/rest_length=16,24 --keep "$s/0/rest_length+$s/1/rest_length"
check 'a kept sum' holds -s 'map(.types.a.springs | [.[0].rest_length, .[1].rest_length]) == [[16, 24], [24, 16]] and .[0].study["/types/a/springs/1/rest_length"] == 24' out
beadswim-layout swimmer --preset paper-single --unbounded --period 4800 --stiffness 0.05 >kept.json
accepts beadswim-layout vary kept.json --over period=2400,9600 --keep 'period*stiffness'
check 'a kept product' holds -s 'map(.types.a | [.driving.period, .springs[0].stiffness]) == [[2400, 0.1], [9600, 0.025]]' out
beadswim-layout swimmer --preset paper-single --unbounded --arm 16,24 --period 4800 >armed.json
accepts beadswim-layout vary armed.json --over $s/0/rest_length=10,32 --keep "$s/0/rest_length:$s/1/rest_length"
check 'a kept ratio' holds -s 'map(.types.a.springs | [.[0].rest_length, .[1].rest_length]) == [[10, 15], [32, 48]]' out
refuses 'has the value 0' beadswim-layout vary kept.json --over period=0 --keep 'period*stiffness'
accepts beadswim-layout vary armed.json --over arm=[14,26],[20]
check 'lists of a flag' holds -s 'map(.types.a.springs | [.[0].rest_length, .[1].rest_length]) == [[14, 26], [20, 20]] and map(.study.arm) == ["14,26", "20"]' out
accepts beadswim-layout vary armed.json --over /swimmers/0/position=[1,2,3],[4,5,6]
check 'lists by a pointer' holds -s 'map(.swimmers[0].position) == [[1, 2, 3], [4, 5, 6]]' out
refuses 'arm: \[1,2,3\]: the value must be 1 or 2 numbers' beadswim-layout vary armed.json --over arm=[1,2,3]
refuses 'leads to a list or an object' beadswim-layout vary armed.json --over /swimmers/0/position=[1,2]
refuses 'lists of numbers are written as' beadswim-layout vary armed.json --over arm=[1,2],[x]
refuses 'none of "period" and "stiffness" is varied' beadswim-layout vary kept.json --over phase=1 --keep 'period*stiffness'
refuses 'does not state one number for "stiffness"' beadswim-layout vary base.json --over period=1 --keep 'stiffness*period'
accepts beadswim-layout vary base.json --over /swimmers/0/rotate/z=0,90deg
check 'a turn about z' holds -s '.[1].swimmers[0].axis | (.[0] | fabs) < 1e-15 and .[1] == 1' out
refuses '"/swimmers/1/rotate/z" turns no swimmer' beadswim-layout vary base.json --over /swimmers/1/rotate/z=1
beadswim-layout vary base.json --over /flow/velocity_gradient/0/2=0,1e-6 >sheared.jsonl
accepts beadswim-layout vary sheared.jsonl --over /flow/velocity_gradient/1/2=0,1e-6
check 'a flow that is left out is zero' holds -s 'map([.flow.velocity_gradient // [[0, 0, 0], [0, 0, 0]] | .[0][2], .[1][2]]) == [[0, 0], [0, 1e-6], [1e-6, 0], [1e-6, 1e-6]]' out
accepts beadswim-layout vary two.jsonl --over radius=3,4
check 'a filter of streams' holds -s 'map([.study.period, .study.radius]) == [[1000, 3], [1000, 4], [2000, 3], [2000, 4]]' out
# Overrides of single swimmers stay.
beadswim-layout swarm --preset paper-uniform | beadswim-layout defect phase --random --seed 1 >swarm.json
accepts beadswim-layout vary swarm.json --over amplitude=1
check 'own phases stay' holds -s '.[0].types.a.driving.amplitude == [1, 1] and ([.[0].swimmers[].driving.phase_offset] | unique | length == 9)
  and all(.[0].swimmers[]; .driving | has("amplitude") | not)' out
beadswim-layout defect frequency --sigma 0.1 --seed 1 <swarm.json >frequencies.json
refuses '"period" changes no swimmer: each swimmer of frequencies.json has its own period' beadswim-layout vary frequencies.json --over period=1000,2000
accepts beadswim-layout vary frequencies.json --over amplitude=1,2
jq 'del(.swimmers[4].driving.period)' frequencies.json >followed.json
accepts beadswim-layout vary followed.json --over period=1000
check 'a swimmer without its own period follows' holds -s '.[0].types.a.driving.period == 1000' out
accepts beadswim-layout vary frequencies.json --over /swimmers/3/driving/period=1000,2000

refuses 'unknown value "perod"; did you mean "period"' beadswim-layout vary base.json --over perod=1,2
refuses '"period=a:2:3": "a" is not a finite number' beadswim-layout vary base.json --over period=a:2:3
refuses 'a range is FROM:TO:COUNT' beadswim-layout vary base.json --over period=1:2
refuses 'must be a whole number from 2' beadswim-layout vary base.json --over period=1:2:1
refuses 'needs two numbers above 0' beadswim-layout vary base.json --over period=0:2:3:log
refuses 'write NAME=' beadswim-layout vary base.json --over period=
refuses 'write NAME=' beadswim-layout vary base.json --over period
refuses 'this is no JSON pointer' beadswim-layout vary base.json --over /domain~2=1
accepts beadswim-layout vary base.json --over /swimmers/0/id=3,4
refuses 'standard input can be read only once' beadswim-theory - - <base.json
refuses 'a value is missing' beadswim-layout vary base.json --over period=1,,2
refuses 'base.json with /types/a/bead=1:/types/a/bead: unknown key; did you mean "beads"' beadswim-layout vary base.json --over /types/a/bead=1
refuses '/types/a/bead: unknown key; did you mean "beads"' beadswim-layout vary base.json --over /types/a/bead/0/radius=1
refuses '/swimmers/0/drving: unknown key; did you mean "driving"' beadswim-layout vary base.json --over /swimmers/0/drving/period=1
refuses 'has 3 entries, numbered from 0' beadswim-layout vary base.json --over /types/a/beads/3/radius=1
refuses 'base.json:/units is a single value' beadswim-layout vary base.json --over /units/length=1
refuses 'leads to a list or an object' beadswim-layout vary base.json --over /types/a=1
refuses 'named twice' beadswim-layout vary base.json --over period=1,2 --over period=3
refuses '"period" has 2 values and "phase" has 3' beadswim-layout vary base.json --over period=1,2 --over phase=1,2,3 --together
refuses 'belongs to a study of "period" already' beadswim-layout vary two.jsonl --over period=3
refuses 'base.json with radius=40:/types/a/springs/0/rest_length' beadswim-layout vary base.json --over radius=4,40
jq 'del(.made_by)' chain.json >unknown-chain.json
refuses 'is not a swimmer of three beads on a line' beadswim-layout vary unknown-chain.json --over radius=1
refuses 'unknown value "bod"; did you mean "body"' beadswim-layout vary base.json --over frame=lab,bod
refuses 'more than 1000000 layouts' beadswim-layout vary base.json --over period=1:2:1000 --over radius=1:2:1000 --over phase=0,1

# --- streams through filters, check and theory

beadswim-layout vary base.json --over period=2000:8000:7 --over phase=30deg,90deg >study.jsonl
accepts beadswim-layout check study.jsonl --json
check 'a line per layout, with its study' holds -s 'length == 14 and all(.study.phase == .types.a.phase)' out
accepts beadswim-layout check study.jsonl
out_has '^layout 14, period = 8000'
beadswim-layout vary swarm.json --over stiffness=0.1,0.2 >swarms.jsonl
accepts beadswim-layout defect jitter swarms.jsonl --sigma 0.1
check 'two swarms with the same defects' holds -s 'length == 2 and .[0].swimmers == .[1].swimmers' out
accepts beadswim-theory study.jsonl --method rpy-ode,rpy-perturbation
mv out study-theory.jsonl
check 'a prediction per layout' holds -s 'length == 14 and all(.study.period == .scene.types.a.driving.period)' study-theory.jsonl
accepts beadswim-theory study.jsonl --method rpy-ode,rpy-perturbation --jobs 3
check 'the same on any number of processes' cmp <(jq -c 'del(.provenance)' out) <(jq -c 'del(.provenance)' study-theory.jsonl)
head -3 study.jsonl >some.jsonl
accepts beadswim-theory base.json some.jsonl --method rpy-ode
check 'files together' holds -s 'map(has("study")) == [false, true, true, true]' out
accepts beadswim-theory --method rpy-ode <<<"$(jq -c . base.json)"
check 'a line in, a line out' test "$(wc -l <out)" -eq 1

jq -c . chain.json | cat some.jsonl - study.jsonl >mixed.jsonl
run beadswim-theory mixed.jsonl --method rpy-force-repaired --jobs 2
has_status 3
err_has '1 of 18 layouts have no prediction'
check 'a failure in place of the prediction' holds -s 'map(.status == "failed" and .schema == "beadswim/failure/1") == [false, false, false, true] + [range(14) | false]
  and .[3].member == 4 and (.[3].reason | test("three beads on a line"))' out
{ cat some.jsonl; jq -c 'del(.fluid)' base.json; } >invalid.jsonl
refuses 'invalid.jsonl line 4: the object lacks the key "fluid"' beadswim-theory invalid.jsonl
refuses 'invalid.jsonl line 4: the object lacks the key "fluid"' beadswim-layout vary invalid.jsonl --over radius=3
{ head -1 some.jsonl; echo '{"schema": '; } >broken.jsonl
refuses 'broken.jsonl line 2: line 1, column 12: the text ends before' beadswim-theory broken.jsonl
run beadswim-layout check invalid.jsonl
has_status 2
err_has 'invalid.jsonl line 4: the object lacks the key "fluid"'
refuses 'missing.jsonl: the file cannot be read' beadswim-theory some.jsonl missing.jsonl

# --- streams through compare

head -6 study.jsonl >six.jsonl
beadswim-run six.jsonl --model rpy --cycles 2 --progress none -o six-{}.h5md >six-runs.jsonl 2>err
run beadswim-compare six-runs.jsonl study-theory.jsonl --method rpy-ode --tolerance 0.02
has_status 0
check 'a verdict per run, with its study' holds -s --slurpfile runs six-runs.jsonl 'map(.study) == ($runs | map(.study)) and all(.pass and .decided_by == "rpy-ode")' out
err_has '^period = 2000, phase = 0.523599: pass by rpy-ode: velocity [-+]0'
err_has '^verdicts: 6 of 6 pass$'
tac six-runs.jsonl >backwards.jsonl
run beadswim-compare backwards.jsonl study-theory.jsonl --method rpy-ode --tolerance 0.02
check 'pairs are found by their studies' holds -s 'length == 6 and all(.pass)' out
run beadswim-compare six-runs.jsonl study-theory.jsonl --method rpy-ode --tolerance 1e-9
has_status 1
err_has '^verdicts: 0 of 6 pass$'
run beadswim-compare six-runs.jsonl <(sed 3d study-theory.jsonl) --method rpy-ode --tolerance 0.02
has_status 3
err_has '1 of 6 runs have no verdict'
check 'a failure without a partner' holds -s '.[2].status == "failed" and .[2].member == 3 and (.[2].reason | test("has no document of the study")) and (map(select(.pass)) | length == 5)' out
run beadswim-compare <(sed '2s/.*/{"schema":"beadswim\/failure\/1","status":"failed","program":"beadswim-run","member":2,"reason":"no memory","study":{"period":2000,"phase":1.5707963267948966}}/' six-runs.jsonl) \
  study-theory.jsonl --method rpy-ode --tolerance 0.02
has_status 3
check 'a failure goes on' holds -s '.[1].reason | test("is a failure: no memory")' out
refuses 'line 2: the object lacks the key' beadswim-compare <(jq -c 'if input_line_number == 2 then del(.model) else . end' six-runs.jsonl) study-theory.jsonl
run beadswim-compare six-1.json study-theory.jsonl --method rpy-ode --tolerance 0.02
has_status 0
run beadswim-compare six-1.h5md six-1.json --tolerance 1e-9
has_status 0
err_has '^velocity .* run +\+0.00 %'
# A trajectory has the last cycle of each swimmer at the end of each base cycle, with the numbers of the record.
for period in 1000 4000; do
  beadswim-layout swarm --preset paper-uniform --block-swimmers 1,1,2 | jq ".swimmers[1].driving.period = $period" >own-$period.json
  beadswim-run own-$period.json --model rpy --cycles 6 -o own-$period.h5md --progress none >own-$period-run.json 2>err
done
run beadswim-compare own-1000-run.json own-1000.h5md --cycle 4 --tolerance 1e-9
has_status 0
refuses 'own-1000.h5md: the run does not contain cycle 3, only some of the cycles 2 to 12' beadswim-compare own-1000-run.json own-1000.h5md --cycle 3
refuses 'does not contain the last 3 cycles, only some of the cycles 2 to 12' beadswim-compare own-1000-run.json own-1000.h5md --cycle mean:3
run beadswim-compare own-4000-run.json own-4000.h5md --cycle mean:3 --tolerance 1e-9
has_status 0

# Records of more than 64 swimmers do not list them; the trajectory beside the record does.
beadswim-layout swarm --preset paper-uniform --blocks 2,3,4 --block-swimmers 1,2,2 >many.json
for model in rpy oseen; do beadswim-run many.json --model $model --cycles 1 -o $model.h5md --progress none >$model.json 2>err; done
run beadswim-compare rpy.json rpy.h5md --tolerance 1e-9
has_status 0
check 'all swimmers' holds '[.rows[].swimmer] | unique | length == 96' out
accepts beadswim-compare rpy.json --table rpy.csv
accepts beadswim-compare rpy.h5md --swimmer 95 --table -
check 'a table of all swimmers, of the trajectory' test "$(wc -l <rpy.csv)" -eq 97
check 'the same of one' cmp out <(grep -E '^(swimmer|95),' rpy.csv)
run beadswim-compare rpy.json rpy.h5md --swimmer 95
has_status 0
check 'one swimmer' holds '[.rows[].swimmer] | unique == [95]' out
refuses 'the ids in the record are from 0 to 95' beadswim-compare rpy.json rpy.h5md --swimmer 96
beadswim-theory many.json --method rpy-ode >theory-of-many.json
run beadswim-compare rpy.json theory-of-many.json --swimmer 95
has_status 1 # a swarm swims otherwise than one swimmer in open space
check 'swimmers with equal parameters have equal predictions' holds '[.rows[] | [.swimmer, .method]] | unique == [[95, "rpy-ode"]]' out
run beadswim-compare rpy.json oseen.json
has_status 1
err_has '^verdict: FAIL'
check 'a short table' test "$(wc -l <err)" -lt 50
accepts beadswim-plot stroke rpy.json
mv oseen.h5md other.h5md; cp six-1.h5md oseen.h5md
refuses 'the trajectory oseen.h5md belongs to another run' beadswim-compare oseen.json rpy.json

# --- figures

accepts beadswim-plot against study-theory.jsonl --x period --group-by phase --method rpy-ode,rpy-perturbation -o - --data data.csv
notes_have 'uncertainties that runs and predictions state'
mv out figure.svg
check 'a curve per method and phase' test "$(sed 1d data.csv | cut -d'"' -f10 | sort -u | tr '\n' ' ')" = 'rpy-ode, phase = 0.5236 rpy-ode, phase = 1.571 rpy-perturbation, phase = 0.5236 rpy-perturbation, phase = 1.571 '
check 'the numbers of the predictions' cmp <(grep 'rpy-ode, phase = 1.571' data.csv | cut -d, -f7- | cut -d, -f1,2 | sort -t, -g) \
  <(jq -r 'select(.study.phase > 1) | "\(.study.period),\(.predictions[0].velocity)"' study-theory.jsonl | sort -t, -g)
check 'their relative uncertainties as lengths' test "$(paste -d, <(grep 'rpy-ode, phase = 1.571' data.csv | cut -d, -f7- | sort -t, -g) \
  <(jq -r 'select(.study.phase > 1) | "\(.study.period),\(.predictions[0] | .uncertainty * .velocity)"' study-theory.jsonl | sort -t, -g) |
  awk -F, '{ d = $3 - $5; if (d * d < 1e-20 * $5 * $5 && $5 > 0) ++equal } END { print equal }')" = 7
check 'bands' grep -q '<polygon' figure.svg
for result in efficiency power arm_amplitudes sin_phase_shift gap; do
  accepts beadswim-plot against study-theory.jsonl --x period --y "$result" --group-by phase --log xy -o figure.svg
done
refuses '--x: "perod" is not varied in .*did you mean "period"' beadswim-plot against study-theory.jsonl --x perod -o x.svg
beadswim-theory base.json --method rpy-ode >base-theory.json
refuses '--x: base-theory.json belongs to no study' beadswim-plot against base-theory.json --x period -o x.svg
jq -c '.study.frame = "lab"' study-theory.jsonl >words.jsonl
refuses '--x: "frame" is the word "lab"' beadswim-plot against words.jsonl --x frame -o x.svg

jq -c 'select(.study.phase < 1) | .predictions[0].usable = (.study.period < 4000)' study-theory.jsonl >usable.jsonl
accepts beadswim-plot against usable.jsonl --x period --method rpy-perturbation,rpy-ode -o figure.svg --data data.csv
check 'each point once, with the name of its method' test "$(sed 1d data.csv | cut -d'"' -f10 | sed 's/ (not usable)//' | sort | uniq -c | xargs)" = '7 rpy-ode 7 rpy-perturbation'
check 'points that are not usable are a series of their own' test "$(grep -c '(not usable)' data.csv)" -eq "$(jq '.predictions[] | select(.usable == false) | 1' usable.jsonl | wc -l)"

# --- runs of a stream

beadswim-layout vary base.json --over period=2000:8000:4 --over phase=30deg,90deg >study.jsonl
runs=(--model rpy --cycles 2 --progress none)
run beadswim-run study.jsonl "${runs[@]}" -o run-{}.h5md
has_status 0
err_has '[1-8] of 8 layouts have warnings'
mv out runs.jsonl
check 'a record per layout, in order' holds -s 'map(.study.period) == [2000, 2000, 4000, 4000, 6000, 6000, 8000, 8000]
  and all(.status == "finished" and .study.phase == .driving.phase)' runs.jsonl
check 'each record is beside its trajectory' cmp run-3.json <(sed -n 3p runs.jsonl)
check 'trajectories' test -s run-8.h5md
beadswim-run <(sed -n 3p study.jsonl) "${runs[@]}" -o alone.h5md >alone.json 2>err
check 'the record of a run alone' cmp <(jq 'del(.cost, .provenance, .request_sha256)' run-3.json) <(jq 'del(.cost, .provenance)' alone.json)

accepts beadswim-plot against runs.jsonl study-theory.jsonl --x period --group-by phase --method rpy-ode -o figure.svg --data data.csv
check 'runs as marks with errors' grep -qE '"rpy, phase = 0.5236",2000,[0-9.e-]+,[0-9.e-]+$' data.csv

# The same command repeats nothing; what is missing or was made with other flags is run.
touch mark
run beadswim-run study.jsonl "${runs[@]}" -o run-{}.h5md
check 'the same records' cmp out runs.jsonl
check 'nothing is run again' test -z "$(find . -name 'run-*' -newer mark)"
rm run-2.h5md run-5.json
run beadswim-run study.jsonl "${runs[@]}" -o run-{}.h5md
check 'the same results' cmp <(jq -c 'del(.cost)' out) <(jq -c 'del(.cost)' runs.jsonl)
check 'only two were run' test "$(find . -name 'run-*.json' -newer mark | sort | tr '\n' ' ')" = './run-2.json ./run-5.json '
run beadswim-run study.jsonl "${runs[@]}" --cycles 1 -o run-{}.h5md
check 'other flags: run again' holds -s 'all(.swimmers[0].cycles | length == 1)' out

rest_is_long

# Groups of ranks give the same records.
for ranks_and_group in '2 1' '2 2' '3 2'; do
  read -r ranks group <<<"$ranks_and_group"
  run mpirun -n "$ranks" beadswim-run study.jsonl "${runs[@]}" --ranks-per-run "$group" --no-provenance -o "ranks-$ranks-$group-{}.h5md"
  has_status 0
  mv out "ranks-$ranks-$group.jsonl"
  check "$ranks ranks in groups of $group: the same results" cmp <(jq -c 'del(.provenance, .cost, .request_sha256)' runs.jsonl) <(jq -c 'del(.request_sha256)' "ranks-$ranks-$group.jsonl")
done

# A map of two quantities.
accepts beadswim-plot against study-theory.jsonl --x period --y phase --colour velocity --method rpy-ode --log x -o map.svg --data map.csv
check 'a value per layout' test "$(tail -n +2 map.csv | wc -l)" -eq 14
check 'the values of the predictions' cmp <(tail -n +2 map.csv | cut -d, -f7- | sort) \
  <(jq -r '[.study.period, .study.phase, (.predictions[] | select(.method == "rpy-ode") | .velocity)] | map(tostring) | join(",")' study-theory.jsonl | sort)
accepts beadswim-plot against runs.jsonl --x period --y phase --colour arm_amplitudes -o map.pdf
refuses 'a second value for period = 2000, phase = 0.523599' beadswim-plot against study-theory.jsonl --x period --y phase --colour velocity --method all
refuses '--y: unknown value "phase".* a second quantity of the study needs --colour' beadswim-plot against study-theory.jsonl --x period --y phase
refuses '"radius" is not varied in' beadswim-plot against study-theory.jsonl --x period --y radius --colour velocity
refuses '--group-by: a map shows one value per point' beadswim-plot against study-theory.jsonl --x period --y phase --colour velocity --group-by phase

# A campaign that is killed at any moment ends with the same records.
beadswim-layout vary base.json --over phase=30deg:150deg:24 >campaign.jsonl
campaign=(--model multipole --multipole-order 2 --cycles 3 --progress none --no-provenance)
beadswim-run campaign.jsonl "${campaign[@]}" -o whole-{}.h5md >whole.jsonl 2>err
for pause in 0.3 0.7 1.1; do
  mpirun -n 2 beadswim-run campaign.jsonl "${campaign[@]}" -o killed-{}.h5md >killed.jsonl 2>err &
  sleep "$pause"
  pkill -9 -f 'beadswim-run campaign.jsonl'
  wait
done 2>jobs
run mpirun -n 2 beadswim-run campaign.jsonl "${campaign[@]}" -o killed-{}.h5md
has_status 0
check 'the same records' cmp out whole.jsonl

# A checkpoint at the end of a run whose record is missing: the run begins again.
ended=(--model rpy --cycles 1 --checkpoint-every 0.5 --progress none --no-provenance -o ended-{}.h5md)
beadswim-run some.jsonl "${ended[@]}" >ended.jsonl 2>err
check 'checkpoints' test -e ended-2.h5md.ckpt.0
rm ended-2.json
run beadswim-run some.jsonl "${ended[@]}"
has_status 0
check 'the same records' cmp out ended.jsonl

refuses '--restart: is for a single layout' beadswim-run some.jsonl --restart ended-1.h5md -o ended-{}.h5md

# A time limit stops the stream; the same command goes on.
run beadswim-run campaign.jsonl "${campaign[@]}" --time-limit 0.5 -o limited-{}.h5md
has_status 4
err_has 'after the first [0-9]+ of 24 layouts; the same command goes on'
check 'the records so far' cmp out <(head -n "$(wc -l <out)" whole.jsonl)

# Runs of few steps, which end before they look for a stop, and idle ranks stop, too.
beadswim-layout vary base.json --over phase=30deg:150deg:600 >short.jsonl
short=(--model rpy --steps-per-cycle 20 --frames-per-cycle 4 --cycles 1 --progress none --no-provenance)
run beadswim-run short.jsonl "${short[@]}" --time-limit 0.5 -o short-{}.h5md
has_status 4
check 'it stopped early' test "$(wc -l <out)" -lt 600
name=idle$$
for rank in 0 1; do  # the one that has no layout
  rm -f $name-*
  mpirun -n 2 beadswim-run base.json --ranks-per-run 1 --model rpy --cycles 100000 --progress none -o "$name-{}.h5md" >out 2>err &
  for _ in $(seq 100); do [ -s $name-1.h5md.part ] && break; sleep 0.1; done
  sleep 0.5
  kill -TERM "$(pgrep -f "^beadswim-run .*$name" | sed -n $((rank + 1))p)"
  status=0
  wait $! || status=$?
  command_line="kill -TERM (rank $rank of 2 with one layout)"
  has_status 4
done

# A layout that cannot be run does not stop the others.
jq -c '.domain = {lengths: [60, 30, 30], boundary: ["periodic", "periodic", "periodic"]} | .swimmers[0].position = [30, 15, 15]' base.json |
  cat - some.jsonl >mixed.jsonl
run beadswim-run mixed.jsonl --model lbm --cells-per-radius 2 --cycles 0.05 --progress none -o mixed-{}.h5md
has_status 3
err_has '3 of 4 layouts have no result'
mv out mixed-runs.jsonl
check 'failures' holds -s 'map(.status) == ["finished", "failed", "failed", "failed"] and .[1].member == 2 and (.[1].reason | test("lattice needs a box"))' mixed-runs.jsonl

# Plans of a stream: one per layout, in order, on any number of ranks; their sum.
plan=(--plan --model lbm --cells-per-radius 2 --cycles 1 --no-provenance --tolerance 20)
run beadswim-run mixed.jsonl "${plan[@]}"
has_status 3
err_has '3 of 4 layouts have no run within the tolerance'
check 'a plan, and failures or plans without a choice' holds -s 'length == 4 and .[0].schema == "beadswim/plan/1" and (.[0].choice | test("--model lbm")) and
  (.[1:] | all(.choice == null))' out
run beadswim-run some.jsonl --plan --model rpy --tolerance 20 --cycles 2
has_status 0
cp out plans.jsonl
check 'the studies' test "$(jq -c .study out)" = "$(jq -c .study some.jsonl)"
sum=$(sed -nE 's/^all: 3 of 3 layouts have .* together ([0-9.e+-]+) core-seconds.*/\1/p' err)
check 'the sum of the costs' holds -s --argjson sum "$sum" 'map(.runs[0].cost.core_seconds) | add / $sum - 1 | fabs < 0.01' out
head -1 out >plan.json
valid plan plan.json
run mpirun -n 2 beadswim-run some.jsonl --plan --model rpy --tolerance 20 --cycles 2
has_status 0
check 'the same on two ranks' test "$(jq -c '[.study, .choice, .runs[0].error]' out)" = "$(jq -c '[.study, .choice, .runs[0].error]' plans.jsonl)"

# A large lattice runs on all ranks, after the others, and its record has its place.
on_lattice() { # BOX
  beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box "$1" --boundary periodic --period 100 --amplitude 0.02 --jsonl
}
for box in 48,48,32 32,16,16 32,16,16 32,16,16; do on_lattice $box; done >sizes.jsonl
lattice=(--model lbm --cells-per-radius 2 --cycles 0.2 --no-provenance)
run mpirun -n 2 beadswim-run sizes.jsonl "${lattice[@]}" -o sizes-{}.h5md
has_status 0
err_has '4 layouts: 3 run side by side, up to 2 at a time, each on 1 rank; then 1 large, one after the other on all 2 ranks'
cp out sizes.out
run beadswim-run sizes.jsonl "${lattice[@]}" -o single-size-{}.h5md
has_status 0
err_has '4 layouts: 4 run side by side, up to 1 at a time, each on 1 rank'
check 'the same records' cmp <(jq -S 'del(.request_sha256)' out) <(jq -S 'del(.request_sha256)' sizes.out)
run mpirun -n 2 beadswim-run sizes.jsonl "${lattice[@]}" --ranks-per-run 1 -o grouped-size-{}.h5md
err_has '4 layouts: 4 run side by side, up to 2 at a time, each on 1 rank'

# A lattice with few cells for each rank runs side by side with the others, also if it has most of the work.
for box in 32,32,32 32,16,16; do on_lattice $box; done >few.jsonl
run mpirun -n 2 beadswim-run few.jsonl "${lattice[@]}" -o few-{}.h5md
has_status 0
err_has '2 layouts: 2 run side by side, up to 2 at a time, each on 1 rank$'

# More files than a process may hold open.
for n in $(seq 60); do sed -n 1p study.jsonl >"many-$n.json"; done
run bash -c 'ulimit -n 40; beadswim-theory many-*.json --method rpy-perturbation --jobs 1 | wc -l'
check 'all of 60 files with 40 open files at most' test "$(cat out)" = 60

refuses 'line 1: the run record contains no complete cycle' beadswim-plot stroke mixed-runs.jsonl -o failures.svg

# --- a run that stops before its first cycle ends has no result: it is left out and counted, and the others are shown
beadswim-layout swimmer --preset paper-single --unbounded | beadswim-layout vary --over amplitude=0.1,60 >strong.jsonl
run beadswim-run strong.jsonl --model rpy --cycles 3 --progress none -o strong-{}.h5md
mv out strong-runs.jsonl
check 'the second stops in its first cycle' holds -s '.[0].status == "finished" and .[1].swimmers[0].cycles == []' strong-runs.jsonl
beadswim-theory strong.jsonl --method rpy-perturbation >strong-theory.jsonl 2>err
for inputs in strong-runs.jsonl 'strong-1.h5md strong-2.h5md' 'strong-1.json strong-2.json'; do
  for figure in 'against --x amplitude' 'stroke ' 'velocity-against-period ' 'separation ' 'speed-against-error --reference strong-first.theory'; do
    sed -n 1p strong-theory.jsonl >strong-first.theory
    [[ $inputs =~ h5md && ! $figure =~ stroke|velocity ]] && continue # trajectories have no study and no cost
    run beadswim-plot ${figure%% *} $inputs ${figure#* } -o figure.svg
    has_status 0
    err_has '^beadswim-plot: 1 of 2 documents have no result, and are left out$'
  done
done
refuses 'strong-2.json: the run record contains no complete cycle' beadswim-plot stroke strong-2.json
run beadswim-plot against strong-runs.jsonl strong-theory.jsonl --x amplitude --data strong.csv
has_status 0
err_has '2 of 4 documents' # the run, and a prediction that is not usable
check 'one run' test "$(grep -c '"rpy"' strong.csv)" -eq 1
run beadswim-compare strong-runs.jsonl strong-theory.jsonl --tolerance 0.5 --quantity velocity
has_status 3
check 'a verdict, and a failure' holds -s '.[0].pass and .[1].status == "failed" and (.[1].reason | contains("no complete cycle"))' out
mv out strong-verdicts.jsonl
run beadswim-plot speed-against-error strong-verdicts.jsonl
has_status 0
err_has '1 of 2 documents have no result'
sed -n 1p strong.jsonl >weak.json
run beadswim-theory weak.json --method oseen-stroke-closed --stroke-from strong-runs.jsonl
has_status 0
err_has '1 of 2 documents of strong-runs.jsonl have no result'
views strong-2.h5md strong.html && err_empty
refuses 'each of the 8 layouts needs a trajectory of its own; write \{\} once' beadswim-run study.jsonl "${runs[@]}" -o run.h5md
refuses '--cells-per-radius: the setting applies to the lattice only' beadswim-run study.jsonl "${runs[@]}" --cells-per-radius 3 -o run-{}.h5md
refuses '--ranks-per-run: 2 is more than the 1 ranks' beadswim-run study.jsonl "${runs[@]}" --ranks-per-run 2 -o run-{}.h5md
refuses 'invalid.jsonl line 4: the object lacks the key "fluid"' beadswim-run invalid.jsonl "${runs[@]}" -o invalid-{}.h5md
check 'nothing was run' test ! -e invalid-1.h5md
accepts beadswim-run base.json "${runs[@]}" -o single-{}.h5md
refuses '"x[{][}]" does not end in .h5md' beadswim-run study.jsonl "${runs[@]}" -o 'x{}'
for n in 1 2; do sed -n "${n}p" study.jsonl >"in-$n.json"; done
cp in-1.json kept.json
refuses 'in-1.json: the output would replace the input file' beadswim-run in-1.json in-2.json "${runs[@]}" -o in-{}.h5md
check 'the layout is still there' cmp in-1.json kept.json
echo '{"mine": 1}' >note-1.json
refuses 'note-1.json: this file is no run record' beadswim-run study.jsonl "${runs[@]}" -o note-{}.h5md
mkdir blocked-2.h5md   # a failure by something that can be mended is tried again
run beadswim-run study.jsonl "${runs[@]}" -o blocked-{}.h5md
has_status 3
rmdir blocked-2.h5md
run beadswim-run study.jsonl "${runs[@]}" -o blocked-{}.h5md
has_status 0
check 'all finished' holds -s 'length == 8 and all(.status == "finished")' out
run beadswim-run in-1.json in-2.json --model auto --tolerance 0.3 --cycles 1 --progress none -o auto-{}.h5md
mv out auto.jsonl
run beadswim-run in-1.json in-2.json --model auto --tolerance 0.2 --cycles 1 --progress none -o auto-{}.h5md
check 'other flags of a plan: other hashes' test "$(jq .request_sha256 auto.jsonl out | sort -u | wc -l)" -eq 4
run timeout 60 mpirun -n 2 bash -c 'exec beadswim-run study.jsonl --model rpy --cycles 2 --progress none -o full-{}.h5md >/dev/full'
check 'a full disk ends all ranks' test "$status" -eq 3
accepts beadswim-run base.json "${runs[@]}" -o single-{}.h5md
check 'one layout is a stream, too' test -s single-1.json -a "$(wc -l <out)" -eq 1

finish
