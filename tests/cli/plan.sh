#!/bin/bash
# Tests beadswim-run with --plan and --model auto: the expected errors and costs of runs, the run that is chosen, and whether the
# chosen run is as accurate as expected.
source "$(dirname "$0")/harness.sh"

export XDG_CACHE_HOME=$PWD/cache
beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce >cell.json 2>/dev/null
beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 >single.json

# --- a plan: a table for people, JSON for programs, nothing run
run beadswim-run cell.json --plan
has_status 0
err_has 'measuring how fast this machine updates lattice cells'
err_has '<- cheapest'
err_has '^hard: swimmer 0: inertia'
cp out plan.json
check "no run was made" test "$(echo *.h5md*)" = '*.h5md*'
check "all models are in it" holds '[.runs[].model] | unique == ["lbm", "oseen", "rpy", "rpy+near", "unsteady"]' plan.json
check "many resolutions are" holds '[.runs[] | .resolution // empty] | length > 40 and (map(.cells_per_radius * 16 | . % 3 == 0) | all)' plan.json
check "more cells cost more and err less" holds '[.runs[] | select(.resolution.relaxation_time == 1 and .resolution.precision == "double")]
  | (map(.cost.core_seconds) | . == sort) and (map(.error.velocity) | . == (sort | reverse))' plan.json
check "shorter steps cost more and err less" holds '[.runs[] | select(.resolution.cells_per_radius == 3 and .resolution.precision == "double")]
  | (map(.cost.core_seconds) | . == (sort | reverse)) and (map(.error.velocity) | . == sort)' plan.json
check "typical errors are within their limits" holds '[.runs[] | select(.error) | [.typical_error, .error] | map([.velocity] + .arm_amplitudes) | transpose[]] | length > 100 and all(0 < .[0] and .[0] < .[1])' plan.json
check "the choice is the cheapest within 3 %" holds '.tolerance == 0.03 and (.choice as $choice
  | [.runs[] | select(.refused == null and ([.error.velocity] + .error.arm_amplitudes | max) <= 0.03)]
  | min_by(.cost.core_seconds).flags == $choice)' plan.json
valid plan plan.json

# --- the machine's speed is kept, and measured again where the file is none
run beadswim-run cell.json --plan
check "it is not measured twice" test -z "$(grep measuring err)"
for broken in 'no JSON' "$(jq -c '.precisions[1].seconds_per_cell[2] = 0' cache/beadswim/lattice-speed-1.json)"; do
  echo "$broken" >cache/beadswim/lattice-speed-1.json
  run beadswim-run cell.json --plan
  has_status 0
  err_has 'measuring how fast this machine'
done

# --- flags close what they name
run beadswim-run cell.json --plan --cells-per-radius 3 --relaxation-time 0.8 --bead-boundary psm --precision single
check "one lattice is left" holds '[.runs[] | select(.model == "lbm")] | length == 1 and (.[0].flags
  == "--model lbm --cells-per-radius 3 --relaxation-time 0.8 --precision single --bead-boundary psm")' out
check "mobility models are refused" holds '[.runs[] | select(.model != "lbm") | .refused] | length == 6 and all(test("applies to the lattice only"))' out
run beadswim-run cell.json --plan --model rpy
check "one model is left" holds '[.runs[].model] == ["rpy"]' out

# --- more is asked than can be had
run beadswim-run cell.json --plan --tolerance 1e-4
has_status 2
err_has '^beadswim-run: --tolerance: no run has an error limit within 0.01 %; the run with the smallest limit, --model lbm --cells-per-radius 8.*, has .*: raise the tolerance'
check "the plan is there" holds '.choice == null and .best != null' out
err_has '^no run has an error limit within 0.01 %$'
err_has '^not listed: [0-9]+ lattice runs that cost more than a run with a similar or smaller error$'
check "runs in the table and others are all" test "$(grep -c '^  --model' err)" -eq \
  "$(jq --argjson others "$(sed -n 's/^not listed: \([0-9]*\) .*/\1/p' err)" '[.runs[] | select(.refused == null)] | length - $others' out)"
# A tolerance that was not given is not missed.
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.5 --period 1200 >quick.json
run beadswim-run quick.json --plan --model rpy
has_status 0
err_has '^no run has an error limit within 3 %, the default of --tolerance$'
run beadswim-run quick.json --plan --model rpy --tolerance 0.03
has_status 2
run beadswim-run <(jq -c . quick.json; jq -c . quick.json) --plan --model rpy
has_status 0
err_has '^all: 2 of 2 layouts have a run; together'
run beadswim-run <(jq -c . quick.json; jq -c . quick.json) --plan --model rpy --tolerance 0.03
has_status 3
# Resolutions that the box leaves no room for are named.
beadswim-layout swimmer --preset paper-single --box 61,41,40 --boundary periodic >odd.json
run beadswim-run odd.json --plan --model lbm
check "only what divides the box" holds '[.runs[].resolution.cells_per_radius] | unique == [4, 8]' out
err_has '^hard: no lattice run has about 2, 2.5, 3, 5, 6 cells per radius, .* multiple of the smallest radius, 4$'
refuses '^beadswim-run: --tolerance: no run has an error limit' beadswim-run cell.json -o x.h5md --model auto --tolerance 1e-4
refuses '^beadswim-run: --tolerance: ' beadswim-run cell.json -o x.h5md --model auto --tolerance -1
check "no file is left" test ! -e x.h5md

# --- what is chosen keeps it: the swarm within 3 %, the swimmer within 10 and 3 %, of references that took hours
within() { # LAYOUT TOLERANCE CYCLES REFERENCE
  run beadswim-run "$1" -o run.h5md --model auto --tolerance "$2" --cycles "$3" --progress lines
  has_status 0
  err_has '^beadswim-run: starting the cheapest run within --tolerance: --model '
  check "it is within $2" holds "$(jq -c '.swimmers[0].cycles[-1] | [.velocity[0] - .mean_flow[0]] + .arm_amplitudes' "$BEADSWIM_SOURCE/docs/results/speed-against-error/$4") as \$r
    | .swimmers[0].cycles[-1] | [[.velocity[0] - .mean_flow[0]] + .arm_amplitudes, \$r] | transpose | all((.[0] / .[1] - 1 | fabs) < $2)" out
}
within cell.json 0.03 6 cell-reference.json
within single.json 0.1 4 swimmer-reference.json
within single.json 0.03 4 swimmer-reference.json
run beadswim-run --restart run.h5md --cycles 5 --progress none
has_status 2 # it kept no checkpoint

check "the page has the results of the scenes that a seed has chosen" cmp -s \
  <(jq -rs -f "$BEADSWIM_SOURCE/docs/results/plan-agreement.jq" "$BEADSWIM_SOURCE/docs/results/plan-agreement.jsonl" | grep '^Within\|^Predicted\|^Typical') \
  <(sed -n '/^<!-- from plan-agreement.jsonl -->$/,/^<!-- end -->$/p' "$BEADSWIM_SOURCE/docs/choosing-a-model.md" | sed '1d;$d')

# --- memory and files are as large as it says
run beadswim-run cell.json --plan --model lbm --cells-per-radius 3 --relaxation-time 1 --precision double --cycles 2
cp out expected.json
run beadswim-run cell.json --model lbm --cells-per-radius 3 --relaxation-time 1 --precision double --cycles 2 -o sized.h5md --progress none
jq --slurpfile plan expected.json --argjson size "$(stat -c %s sized.h5md)" \
  '[.cost.peak_memory_bytes / $plan[0].runs[0].cost.memory_bytes, $size / $plan[0].runs[0].cost.output_bytes]' out >sizes.json
check "memory and output are within a third" holds 'all(. > 0.67 and . < 1.5)' sizes.json

# --- a scene that no model can run: the message has every reason
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 3 >strong.json
refuses 'no model can run this scene with these settings\. --model oseen.*reduce --amplitude.*--model lbm.*lattice needs a box' \
  beadswim-run strong.json -o strong.h5md --model auto --tolerance 0.1

# --- a small driving, slowly: a mobility model does, and its sums keep a tolerance of their own
beadswim-layout swimmer --preset paper-single --unbounded --period 100000 --amplitude 0.05 >slow.json
run beadswim-run slow.json -o slow.h5md --model auto --tolerance 0.02 --cycles 2
has_status 0
check "the model is one without inertia" holds '.model == "rpy+near" and .mobility.tolerance == 0.0001' out

run beadswim-run slow.json --plan --tolerance 0.02 --sum-tolerance 1e-3
check "flags state the tolerance of the sums" holds '.tolerance == 0.02 and .choice == "--model rpy+near --sum-tolerance 0.001"' out
run beadswim-run slow.json --plan --model rpy+near --tolerance 0.02 --sum-tolerance 0.01
check "errors of the sums are expected" holds '.runs[0].error.velocity > 0.05' out
run beadswim-run slow.json --plan --sum-tolerance 1e-3
check "lattices have no sums" holds '[.runs[] | select(.model == "lbm") | .refused] | length > 0 and all(test("applies to mobility models only"))' out
run beadswim-run slow.json -o slow.h5md --model auto --tolerance 0.02 --sum-tolerance 1e-3 --cycles 1 --progress none
has_status 0
err_empty
check "the sums have their tolerance" holds '.model == "rpy+near" and .mobility.tolerance == 0.001' out

# --- auto plans with the default tolerance, too; a model that is not named is lbm
run beadswim-run slow.json -o slow.h5md --model auto --cycles 1
has_status 0
err_has '^beadswim-run: starting the cheapest run within --tolerance: --model rpy[+]near'
run beadswim-run --help
check "help has both" grep -qE -- '\[default: lbm; auto with --plan or --tolerance\]' <(tr -s ' \n' ' ' <out)
refuses 'lattice needs a box|unbounded' beadswim-run slow.json -o slow.h5md
refuses '^beadswim-run: --model: ' beadswim-run --restart slow.h5md --model auto

# --- proposals
beadswim-layout swarm --preset paper-uniform --blocks 2,1,1 >swarm.json
run beadswim-run swarm.json --plan
check "the cell is proposed" holds '.proposals[0] | .command == "beadswim-layout reduce swarm.json" and (.what | test("18 copies of a cell of 96 x 32 x 32"))' out
err_has '^propose: beadswim-layout reduce swarm.json: the scene consists of 18 copies'
pasted() { # JQ   runs the command of the plan's proposal through the shell, and checks the layout that it writes
  local command
  command=$(jq -er '.proposals[0].command' out)
  run bash -c "$command >smaller.json"
  has_status 0
  run beadswim-layout check --json smaller.json
  has_status 0
  check "$command makes another layout" holds "$1" smaller.json
}
pasted '.swimmers | length == 1'
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,1 | beadswim-layout defect phase --sigma 1 --seed 1 >two.json
run beadswim-run two.json --plan --model rpy
err_has '^hard: neighbours also move one another sideways; mobility models lack the part of this motion that inertia causes'
run beadswim-run slow.json --plan
check "a lattice is refused in open space" holds '[.runs[] | select(.model == "lbm") | .refused] | length > 0 and all(test("unbounded"))' out
beadswim-layout swimmer --preset paper-single >large.json
run beadswim-run large.json --plan
check "a smaller box is proposed" holds '.proposals[0].command | test("^beadswim-layout reduce large.json --box [0-9]+,[0-9]+,[0-9]+$")' out
check "the plan says what errors are" holds '.error_definition | test("^expected relative error of velocity .* at infinitely fine resolution; ")' out
err_has "^error: $(jq -r .error_definition out | sed 's/[()]/./g')\$"
check "levels of cells make lattices possible" holds '[.runs[] | select(.model == "lbm" and (.refused | not))] | length > 9
  and all(.flags | test(" --refine [1-5]$"))' out
check "the cells of each level are listed, in the table too" \
  holds '[.runs[] | select(.model == "lbm" and .refused == null)] | all((.flags | capture("--refine (?<n>.)").n | tonumber) + 1 == (.resolution.cells | length))' out
err_has '^cells: --cells-per-radius [0-9.]+ --refine [1-5]: [0-9]+ [+] [0-9+ ]+, coarsest level first$'
run beadswim-run large.json --plan --refine off
check "lattices that do not fit are refused" holds '[.runs[] | select(.resolution.cells_per_radius == 8) | .refused] | all(test("GB per rank"))' out

pasted '.domain.boundary == ["periodic", "periodic", "periodic"] and (.domain.lengths | .[0] < 200 and .[1] < 100)'
jq 'del(.domain, .swimmers[].position, .provenance, .made_by)' large.json >large.kept
check "all but box and position is kept" cmp -s large.kept <(jq 'del(.domain, .swimmers[].position, .provenance)' smaller.json)
cp large.json "it's large.json"
run beadswim-run "it's large.json" --plan --model rpy
pasted '.domain.lengths[0] < 200'
beadswim-run --plan --model rpy <large.json >out 2>err
check "of standard input, too" holds '.proposals[0].command | test("^beadswim-layout reduce - --box ")' out
command=$(jq -r '.proposals[0].command' out)
check "the layout is that of the file" cmp -s <(bash -c "$command" <large.json | jq 'del(.provenance)') <(jq 'del(.provenance)' smaller.json)

# --- flags of the plan run when pasted: the choice, the best and all mobility models
jq -r '[.choice, .best] + [.runs[] | select(.model != "lbm" and .refused == null) | .flags] | unique[]' plan.json >flags
check "there are flags" test "$(wc -l <flags)" -ge 4
while read -r flags; do
  run bash -c "beadswim-run cell.json $flags -o pasted.h5md --cycles 0.01 --progress none"
  has_status 0
done <flags

# --- hard cases are recognised
plan_of() { # LAYOUT-FLAGS...
  local usual=()
  [[ " $* " == *" --box "* ]] || usual+=(--box 60,40,40)
  [[ " $* " == *" --period "* ]] || usual+=(--period 2000)
  [[ " $* " == *" --amplitude "* ]] || usual+=(--amplitude 0.2)
  beadswim-layout swimmer --preset paper-single --boundary periodic "${usual[@]}" "$@" >hard.json
}
plan_of --amplitude 1.2
run beadswim-run hard.json --plan --model rpy
check "beads that touch are not for points" holds '.runs[0].refused | test("contact|lubrication matters")' out
plan_of --amplitude 0.8
run beadswim-run hard.json --plan --model rpy
check "beads that all but touch are not for points" holds '.runs[0].refused | test("where lubrication matters")' out
plan_of --arm 9
run beadswim-run hard.json --plan --model lbm --cells-per-radius 4 --relaxation-time 1
check "films that cells do not resolve are priced" holds '.runs[0].error.velocity > 0.1' out
plan_of --box 60,12,12
run beadswim-run hard.json --plan
err_has 'of the velocity with the same stroke in open space'
plan_of
run beadswim-run hard.json --plan --model lbm --cells-per-radius 4 --relaxation-time 0.51
check "tau near one half is refused" holds '.runs[0].refused | test("close to 1/2")' out
run beadswim-run hard.json --plan --model lbm --cells-per-radius 1 --relaxation-time 1
check "beads of two cells are priced" holds '.runs[0].error.velocity > 0.2' out
plan_of --period 300
run beadswim-run hard.json --plan --model rpy+near
check "inertia is priced" holds '.runs[0].error.arm_amplitudes | max > 0.1' out
plan_of --amplitude 40 --period 200
run beadswim-run hard.json --plan --model lbm --cells-per-radius 4 --relaxation-time 1.5
check "fast beads are refused" holds '.runs[0].refused | test("would reach Mach")' out
plan_of --amplitude 0.6 --stiffness 0.2 --phase 3.14159265358979 --period 40000
run beadswim-run hard.json --plan
err_has '^hard: swimmer 0: driving along a fixed direction compresses the swimmer'
plan_of --amplitude 0
run beadswim-run hard.json --plan
check "at rest there is nothing to be wrong about" holds '[.runs[] | select(.refused == null) | .error // empty] == []' out
plan_of --arm 8.0001
run beadswim-run hard.json --plan
has_status 2
check "beads that touch at rest are refused" holds '.best == null and .choice == null' out
plan_of --stiffness 1e9
run beadswim-run hard.json --plan --model lbm --cells-per-radius 2 --relaxation-time 1.5
check "stiff springs are refused as by the run" holds '.runs[0].refused | test("sub-steps")' out
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,1 --stiffness 0.0347 | beadswim-layout defect jitter --sigma 0.01 --seed 1 >swarm.json
run beadswim-run swarm.json --plan --cycles 60
err_has '^hard: small differences between swimmers grow'
check "its swimmers cannot be foretold" holds '.choice == null' out

# --- a stand-in that is longer than the swimmer does not fit into the box: errors are then those in open space
beadswim-layout shape sphere --unbounded >open.json
run beadswim-run open.json --plan --model rpy --tolerance 0.9
jq '.runs[0] | .error, .typical_error' out >open.errors
for edge in 80 60; do
  beadswim-layout shape sphere --box $edge,$edge,$edge --boundary periodic >tight.json
  run beadswim-run tight.json --plan --model rpy --tolerance 0.9
  has_status 0
  err_has '^hard: swimmer 0: error estimates are for a swimmer alone in open space'
  check "the errors of a sphere in a box of $edge are those in open space" cmp -s open.errors <(jq '.runs[0] | .error, .typical_error' out)
done
for shape in dumbbell triangle; do
  for edge in 36 40 44; do
    beadswim-layout shape $shape --box $edge,$edge,$edge --boundary periodic >tight.json
    run beadswim-run tight.json --plan --tolerance 0.9
    has_status 0
    check "mobility models and lattices treat a $shape in a box of $edge" \
      holds '[.runs[] | select(.refused == null) | .model] | unique == ["lbm", "oseen", "rpy", "rpy+near", "unsteady"]' out
  done
done

# --- drivings of swimmers' own: one at rest does not stand for the others, nor a weak one for a strong one
swarm_with() { # JQ   the jittered swarm, changed
  beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,1 | beadswim-layout defect jitter --sigma 0.01 --seed 1 |
    jq "$1" >swarm.json
}
swarm_with '.types.a.driving as $d | .swimmers[0].driving = ($d | .amplitude = [0, 0])'
run beadswim-run swarm.json --plan --model rpy+near
check "errors are those of who is driven" holds '.runs[0].error.velocity > 0.3' out
swarm_with '.types.a.driving as $d | .swimmers[1].driving = ($d | .period = 100)'
run beadswim-run swarm.json --plan --model rpy+near
check "errors are of the shortest period" holds '.runs[0] | .refused or (.error.arm_amplitudes | max > 0.3)' out

# --- driven across its line, a swimmer bends, and no theory knows it; and a disorder beyond all numbers
beadswim-layout swimmer --preset paper-single --box 60,60,60 --boundary periodic --axis 0,1,0 >across.json
run beadswim-run across.json --plan
err_has '^hard: swimmer 0: theory cannot predict the motion: the driving forces are perpendicular to the swimmer.s axis'
run beadswim-run swarm.json --plan --tolerance 0.03 --cycles 100000
has_status 2
check "it ends with a plan" holds '.schema == "beadswim/plan/1"' out

# --- --tolerance is the plan's whatever the model; the proposed box lies along the swimmer
run beadswim-run single.json --plan --model rpy --tolerance 0.2
check "the tolerance is the plan's" holds '.tolerance == 0.2 and .choice == "--model rpy"' out
beadswim-layout swimmer --preset paper-single --box 800,800,1200 --axis 0,0,1 --frame body >up.json
run beadswim-run up.json --plan --model rpy
check "the box is long along z" holds '.proposals[0].command | capture("--box (?<x>[0-9.]+),(?<y>[0-9.]+),(?<z>[0-9.]+)") | map_values(tonumber) | .z > .x and .x == .y' out
pasted '.domain.lengths as $box | .swimmers[0] | .axis == [0, 0, 1] and .position == [$box[0] / 2 + 0.6, $box[1] / 2 + 0.2, $box[2] / 2]'
run beadswim-run cell.json --plan --model lbm --cells-per-radius 3 --relaxation-time 1 --lubrication off
check "flags that were given are in the run's" holds '.runs[0].flags | test("--lubrication off")' out
beadswim-layout swimmer --preset paper-single --box 1e9,1e9,1e9 >vast.json
run timeout 60 beadswim-run vast.json --plan --model lbm
has_status 2

# --- the same on any number of ranks but for costs
run mpirun -n 2 beadswim-run cell.json --plan
has_status 0
check "errors are the same on two ranks" cmp -s <(jq '[.runs[] | [.flags, .error]]' out) <(jq '[.runs[] | [.flags, .error]]' plan.json)
run mpirun -n 2 beadswim-run cell.json -o two.h5md --model auto --tolerance 0.1 --cycles 1
has_status 0

# --- the page has the table of what was planned and measured, and its claims are the records'
results=$BEADSWIM_SOURCE/docs/results
page=$BEADSWIM_SOURCE/docs/choosing-a-model.md
jq -rs -f "$results/plan-check.jq" "$results/plan-check.jsonl" >table.md
check "the page has the records' table" cmp -s table.md <(sed -n '/^<!-- from plan-check.jsonl -->$/,/^<!-- end -->$/p' "$page" | sed '1d;$d')
jq -rs -f "$results/simplified-scenes.jq" "$results/simplified-scenes.jsonl" >limits.txt
check "the page has how many errors are within limits" cmp -s limits.txt <(sed -n '/^<!-- from simplified-scenes.jsonl -->$/,/^<!-- end -->$/p' "$page" | sed '1d;$d')
check "the mesh of a fluid with memory has the bytes on record" test "$(jq -rs -f "$results/plan-costs.jq" "$results/plan-costs.jsonl" |
  sed -n 's/^mesh.*: \([0-9]*\) bytes.*/\1/p' | tr '\n' ' ')" = "62 114 132 158 "
check "the bead boundaries have the factors on record" test "$(jq -rs -L "$results" --slurpfile resolution "$results/resolution.jsonl" -f "$results/scheme-factors.jq" "$results/scheme-factors.jsonl" |
  sed -E 's/(.*): cells (.*), wander (.*) \(.*/\1 \2 \3/' | tr '\n' ' ')" = "cli 1.8 2.7 mr 1 1 psm 1.8 0.4 staircase 4.7 7.7 "
check "no choice was wrong" test -z "$(grep -c 'wrong:' table.md | grep -v '^0$')"
check "no estimate was below half" test "$(grep -c 'below half: 0' table.md)" = 4
# The same of the pages on random scenes and on neighbours, of the figure, of the scenes drawn, and of a run.
of_page() { sed -n "/$2/,/^\$/p" "$BEADSWIM_SOURCE/docs/$1" | grep '^|'; }
export -f of_page
same_bytes "jq -rs -f $results/stated-uncertainty.jq $results/stated-uncertainty.jsonl" "of_page stated-uncertainty.md '^| quantity'"
same_bytes "jq -rs -f $results/neighbours.jq $results/neighbours.jsonl" "of_page swarms.md '^| distance of the axes'"
same_bytes "jq -rs -f $results/stated-uncertainty-figure.jq $results/stated-uncertainty.jsonl" "cat $BEADSWIM_SOURCE/docs/images/stated-uncertainty.svg"
python3 "$results/random-scenes.py" 60 28 >scenes.jsonl
check "the scenes drawn are those on record" cmp -s <(jq .layout scenes.jsonl) <(jq .layout "$results/random-scenes.jsonl")
sed -n 6p scenes.jsonl | jq -c '.reference = "--model rpy+near" | .tested = []' | "$results/random-scenes.sh" >again.json
check "a run is that on record" holds --slurpfile known "$results/random-scenes.jsonl" \
  '([$known[5].runs[] | select(.flags == "--model rpy+near")][0].cycles[-1]) as $known | [.runs[0].cycles[-1], $known] | transpose
    | map(.[0] / .[1] - 1 | fabs) | max < 1e-3' again.json
check "the page has the costs on record" grep -qF "$(jq -rs -f "$results/run-costs.jq" "$results/run-costs.jsonl")" "$page"
check "scenes are five" test "$(wc -l <"$results/plan-check.jsonl")" -eq 5

finish
