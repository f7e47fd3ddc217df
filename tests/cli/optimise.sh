#!/bin/bash
# Tests beadswim-optimise: optima that are known, limits, the layout that it writes, the trace, and bad input.
. "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --unbounded >paper.json
beadswim-layout swimmer --preset paper-single --unbounded --phase 0 --amplitude 0.02,0.01 >unequal.json

holds() { jq -e "$@" >held; }
near() { # JQ-FILTER VALUE RELATIVE-TOLERANCE
  check "$1 is $(jq -c "$1" out), not $2 within $3" holds "($1) / ($2) - 1 | . <= $3 and . >= -$3" out
}

# --- known optima

# Equation (4.3) of the paper with A = B is proportional to sin(alpha).
run beadswim-optimise paper.json --free phase=0:180deg --maximise velocity --method oseen-force-closed --trace trace.jsonl
has_status 0
near .study.phase '2 * (1 | atan)' 1e-3
err_has '^beadswim-optimise: paper.json: velocity 7\.892.*e-05 .* \(7\.892.*e-05 as given\), after [0-9]+ evaluations by DIRECT-L, then COBYLA$'
err_has '^beadswim-optimise: phase = 1\.57'
# sin(90 degrees - x) is at most 1 % smaller for x up to acos(0.99) = 0.1415.
near '.study.phase - .study.phase_from' 0.1415 0.04
near '.study.phase_to - .study.phase' 0.1415 0.04
check 'phase in the layout' holds '.types.a.driving.phase == .study.phase and .schema == "beadswim/layout/1"' out
check 'filters in the provenance' holds '.provenance[1].program == "beadswim-optimise" and (.provenance[1].arguments | index("--maximise=velocity"))' out
check 'the layout is valid' beadswim-layout check out >checked
near .study.velocity "$(beadswim-theory out --method oseen-force-closed | jq '.predictions[0].velocity')" 1e-12
check 'the trace' holds -s '.[0].stage == "given" and .[0].velocity > 0 and (map(.evaluation) == [range(1; length + 1)])
  and (map(select(.stage == "search")) | length > 50 and all(.feasible and (.study.phase | type == "number")))
  and (map(select(.stage == "search").velocity) | max) == (map(select(.stage == "range").velocity) + [.[0].velocity] | max)' trace.jsonl

# The trace states what is searched, beside the usual results.
run beadswim-optimise paper.json --free phase=0:180deg --maximise sin_phase_shift --evaluations 10 --method oseen-force-closed --trace sine.jsonl
has_status 0
check 'the sine is in the trace' holds -s 'all(has("sin_phase_shift") and has("gap") and (has("velocity_x") | not))' sine.jsonl
rest_is_long

# With alpha = 0 it is proportional to W k/((k^2 + 4 W^2)(k^2 + 36 W^2)), W = pi eta omega lambda, greatest at
# k^2 = W^2 (sqrt(3328) - 40)/6.
run beadswim-optimise unequal.json --free stiffness=0.001:1 --maximise velocity --method oseen-force-closed
near .study.stiffness '3.14159265358979 / 3 * (2 * 3.14159265358979 / 4800) * 4 * (((3328 | sqrt) - 40) / 6 | sqrt)' 1e-3
# The velocity changes its sign with that of the phase.
run beadswim-optimise paper.json --free phase=-180deg:180deg --minimise velocity --method oseen-force-closed
near .study.phase '-2 * (1 | atan)' 1e-3
check 'a negative velocity' holds '.study.velocity < 0' out

# No point of a grid is better.
run beadswim-optimise paper.json --free phase=0:180deg --free stiffness=0.02:0.1 --maximise efficiency
has_status 0
err_has 'then BOBYQA'
mv out found.json
beadswim-layout vary paper.json --over phase=0.05:3:20 --over stiffness=0.02:0.1:15 | beadswim-theory --method rpy-ode >grid.jsonl
check 'the grid is not better' holds -s --slurpfile found found.json \
  'map(.predictions[0].efficiency) | max | . <= $found[0].study.efficiency and . > 0.97 * $found[0].study.efficiency' grid.jsonl

# --- limits

limited=(--free amplitude=0.01:1 --free stiffness=0.02:0.2 --maximise velocity)
run beadswim-optimise paper.json "${limited[@]}" --subject-to power=:1e-4 --subject-to gap=8:
has_status 0
err_has '^beadswim-optimise: power = (9.99.*e-05|0.0001) is at its limit$'
err_has 'then COBYLA$'
beadswim-theory out --method rpy-ode >limited.json
check 'power and gap are within their limits' holds '.predictions[0] | .power <= 1e-4 and .power > 0.9999e-4
  and ([.arm_means[0] - .arm_amplitudes[0], .arm_means[1] - .arm_amplitudes[1]] | min) >= 16' limited.json
run beadswim-optimise paper.json "${limited[@]}" --subject-to power=:1e-12
has_status 3
out_empty
err_has '^beadswim-optimise: the nearest layout: power = [0-9.e-]+ is outside its limits$'
err_has 'none of [0-9]+ layouts is within the limits; widen'
run beadswim-optimise paper.json --free amplitude=0.5:2 --maximise velocity --method rpy-perturbation
err_has 'warning: beads of an arm overlap in their stroke .*add --subject-to gap=0:'

# --- filters, streams, models

best() { beadswim-optimise "$@" --free phase=0:180deg --maximise velocity 2>report; }
best paper.json >by-name.json
check 'a pipe' cmp <(best <paper.json) by-name.json
beadswim-layout vary paper.json --over arm=20,30 | best --method oseen-force-closed >stream.jsonl
# The given layouts need not be such that they can be evaluated; one that has no result does not stop the others.
run beadswim-optimise <(beadswim-layout vary paper.json --over amplitude=1.5,0 | jq -c 'del(.study)') --free amplitude=0.1:0.3 --maximise efficiency
has_status 0
check 'two results' holds -s 'length == 2 and .[0].study.amplitude == .[1].study.amplitude' out
beadswim-layout vary paper.json --over arm=20,9 >arms.jsonl
run beadswim-optimise arms.jsonl --free phase=0:180deg --maximise velocity --subject-to gap=6: --trace arms.trace
has_status 3
err_has '1 of 2 layouts have no result'
check 'a failure in its place' holds -s '.[0].study.velocity > 0 and .[1].status == "failed" and .[1].member == 2 and .[1].study.arm == 9' out
check 'a trace of both' holds -s 'map(.layout) | unique == [1, 2]' arms.trace
# The layout that was found can be searched again.
run beadswim-optimise stream.jsonl --free phase=80deg:100deg --minimise power --method oseen-force-closed
has_status 0
check 'the earlier results are gone' holds -s 'all(.study | has("velocity") | not) and all(.study.power > 0)' out
check 'a layout per layout' holds -s 'map(.study.arm) == [20, 30] and all(.study.velocity > 0)' stream.jsonl
run beadswim-optimise paper.json --free phase=60deg:120deg --maximise velocity --model rpy --cycles 3 --evaluations 20 --verify-by rpy-ode
has_status 0
err_has '^beadswim-optimise: rpy-ode: velocity .* % from rpy$'
near .study.velocity '.study["velocity_by_rpy-ode"]' 0.01
near .study.velocity "$(beadswim-run out --model rpy --cycles 3 -o run.h5md --progress none 2>report | jq '.swimmers[0].cycles[-1].speed_along_axis')" 1e-9
# Radii whose beads overlap cannot be treated.
run beadswim-optimise paper.json --free radius=2:12 --minimise power
err_has 'then Nelder-Mead'
run beadswim-optimise paper.json --free /types/a/beads/0/radius,/types/a/beads/2/radius=3:5 --maximise velocity
check 'two equal values' holds '.types.a.beads | .[0].radius == .[2].radius and .[1].radius == 4' out
# Springs without a rest length follow their beads. The power of a dumbbell depends on their distance.
beadswim-layout shape dumbbell --unbounded | jq 'del(.types[].bonds[].rest_length)' >dumbbell.json
run beadswim-optimise dumbbell.json --free /types/dumbbell/beads/1/at/0=8:20 --minimise power
has_status 0
moved() { beadswim-layout vary dumbbell.json --over "/types/dumbbell/beads/1/at/0=$1" | beadswim-theory --method rpy-ode | jq .predictions[0].power; }
check 'the power depends on the place' test "$(moved 8)" != "$(moved 20)"
near .study.power "[$(moved 8), $(moved 20)] | min" 1e-3
# Four values: the random numbers of a seed.
four=(--free phase=60deg:120deg --free stiffness=0.02:0.05 --free period=4000:6000 --free radius=3:5 --maximise velocity --method oseen-force-closed)
four() { beadswim-optimise paper.json "${four[@]}" --evaluations 100 --seed "$1" 2>report; }
four 1 >first.json
check 'the same seed' cmp <(four 1) first.json
check 'another seed' test "$(four 2 | jq .study.phase)" != "$(jq .study.phase first.json)"
check 'the random search is named' grep -q 'by CRS2, then BOBYQA' report

# A second method that exceeds a limit, or cannot treat the layout.
run beadswim-optimise paper.json --free amplitude=0.1:0.5 --maximise velocity --subject-to power=:5e-4 --verify-by multipole-ode --trace verified.jsonl
has_status 0
err_has '^beadswim-optimise: multipole-ode: power = 0.0005.* is outside its limits$'
check 'the trace says so' holds -s 'last | .stage == "verification" and .feasible == false and .power > 5e-4' verified.jsonl
# A model that cannot run the layout is refused before the search, one that fails later leaves the result.
refuses '^beadswim-optimise: --verify-by: lbm cannot run the layout: paper.json:.* a lattice needs a box' \
  beadswim-optimise paper.json --free phase=0:180deg --maximise velocity --method oseen-force-closed --verify-by lbm --trace early.jsonl
check 'no search was made' holds -s 'map(.stage) == ["given"]' early.jsonl
beadswim-layout swimmer --preset paper-single --box 81,41.5,41 >odd.json
refuses 'lbm cannot run the layout: odd.json:.* not a whole number' \
  beadswim-optimise odd.json --free phase=0:180deg --maximise velocity --method oseen-force-closed --verify-by lbm
run beadswim-optimise paper.json --free amplitude=0.1:9 --maximise velocity --method oseen-force-closed --verify-by rpy
has_status 3
err_has 'rpy cannot verify the layout that was found: '
check 'the result is there' holds '.study.velocity > 0' out

# A limit of 0 does not depend on units, and holds strictly.
for units in lattice m,s,kg; do
  beadswim-layout swimmer --preset paper-single --unbounded | jq --arg units "$units" 'if $units == "lattice" then . else
    .units = {length: "m", time: "s", mass: "kg"} | (.types.a.beads[].radius, .types.a.springs[].rest_length) *= 1e-6 | .fluid.kinematic_viscosity *= 1e-12
    | .fluid.density *= 1e18 | .types.a.beads[].density *= 1e18 | .types.a.driving.amplitude |= map(. * 1e-6) | .types.a.angular_stiffness *= 1e-12 end' >units.json
  [ "$units" = lattice ] && unit=1e0 || unit=1e-6
  run beadswim-optimise units.json --free "amplitude=0.${unit}:0.7${unit#1}" --maximise velocity --subject-to gap=0:
  has_status 0
  err_has 'gap = .* is at its limit'
  check 'no overlap' bash -c '! grep -q overlap err'
  jq "[.study.amplitude, .study.velocity] | map(. / $unit)" out >"found-$units.json"
done
check 'the same in both units' holds -s '(.[0][0] / .[1][0] - 1, .[0][1] / .[1][1] - 1) | . < 1e-3 and . > -1e-3' found-lattice.json found-m,s,kg.json

# A signal ends a search by a model.
beadswim-optimise paper.json --free phase=0:180deg --maximise velocity --model multipole --cycles 30 --trace signal.jsonl >out 2>err &
until pgrep -f 'beadswim-optimise paper.json .*signal.jsonl' >held; do sleep 0.1; done
sleep 1
kill -INT "$(pgrep -f 'beadswim-optimise paper.json .*signal.jsonl' | head -1)"
wait $! || status=$?
has_status 4
check 'its trace' test -e signal.jsonl

# --- bad input

refuses 'too far apart' beadswim-optimise paper.json --free amplitude=1e-300:1e300 --maximise velocity
refuses 'named twice; write power=MIN:MAX once' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --subject-to power=1: --subject-to power=:2
refuses 'leads to no number' beadswim-optimise paper.json --free /types/a/driving/frame=0:1 --maximise velocity
refuses '"-" cannot be written' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --trace -
beadswim-layout shape sphere >sphere.json
refuses 'gives no gap for this layout' beadswim-optimise sphere.json --free /types/sphere/beads/0/radius=1:2 --maximise velocity --subject-to gap=1:
beadswim-layout swimmer --preset paper-single --unbounded --thermal-energy 0.02 >warm.json
refuses 'runs by rpy are shorter than five persistence times.*increase --cycles' \
  beadswim-optimise warm.json --free amplitude=0.1:0.2 --maximise effective_diffusion --model rpy --cycles 24
beadswim-layout vary paper.json --over arm=20,9 >short.jsonl
refuses 'short.jsonl line 2 with radius=.*overlap' beadswim-optimise short.jsonl --free radius=5:6 --maximise velocity

refuses 'unknown value "phas"; did you mean "phase"' beadswim-optimise paper.json --free phas=0:1 --maximise velocity
refuses 'the first number must be smaller than the second' beadswim-optimise paper.json --free phase=1:0 --maximise velocity
refuses '"phase=0:x": "x" is not a finite number' beadswim-optimise paper.json --free phase=0:x --maximise velocity
refuses 'write NAME=FROM:TO' beadswim-optimise paper.json --free phase=0:1:2 --maximise velocity
refuses 'named twice' beadswim-optimise paper.json --free phase=0:1 --free phase=1:2 --maximise velocity
refuses '/types/a/bead: unknown key; did you mean "beads"' \
  beadswim-optimise paper.json --free /types/a/bead/0/radius=1:2 --maximise velocity
refuses 'rpy-ode gives no angular_velocity for this layout; it gives velocity, efficiency, power, gap' \
  beadswim-optimise paper.json --free phase=0:1 --maximise angular_velocity
refuses 'name one objective with --maximise or --minimise' beadswim-optimise paper.json --free phase=0:1
refuses 'name one objective with --maximise or --minimise' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --minimise power
refuses 'unknown value "powr"; did you mean "power"' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --subject-to powr=:1
refuses 'the first number must be smaller' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --subject-to power=2:1
refuses 'a number is missing' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --subject-to power=:
refuses 'unknown value "rpy-od"; did you mean "rpy-ode"' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --method rpy-od
refuses 'rpy is a model of beadswim-run; use --model or --verify-by' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --method rpy
refuses 'needs a measured stroke' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --method multipole-stroke
refuses 'unknown value "lbn"; did you mean "lbm"' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --verify-by lbn
refuses '--cycles: is for models only' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --cycles 3
refuses 'cannot be written' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --trace nowhere/trace.jsonl
refuses 'would replace the input file' beadswim-optimise paper.json --free phase=0:1 --maximise velocity --trace paper.json
refuses 'with radius=12.*overlap' beadswim-optimise paper.json --free radius=11:13 --maximise velocity
finish
