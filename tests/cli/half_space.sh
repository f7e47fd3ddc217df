#!/bin/bash
# Tests fluid over a plane no-slip wall and background flow: runs, predictions, and the input that is refused.
source "$(dirname "$0")/harness.sh"

over_wall() { # HEIGHT FLAGS...
  beadswim-layout swimmer --preset paper-single --half-space z --position "0,0,$1" --frame body "${@:2}"
}
settings=(--model rpy --progress none --no-provenance)

# --- a run far from the wall moves as predicted, and its record states the half-space
over_wall 24 >over.json
accepts beadswim-layout check over.json
run beadswim-run over.json -o over.h5md "${settings[@]}" --cycles 4
has_status 0
mv out over-run.json
check 'the record lacks the half-space' holds '.domain == {half_space: {axis: "z", boundary: "no-slip"}} and .scene.domain == .domain' over-run.json
run beadswim-theory over.json --method rpy-ode
has_status 0
mv out over-theory.json
check 'the run does not move as predicted' holds '[.[0].swimmers[0].cycles[-1], .[1].predictions[0]]
  | (.[0].velocity[0] / .[1].velocity_vector[0] - 1 | fabs) < 1e-3
    and (.[0].angular_velocity[1] / .[1].angular_velocity[1] - 1 | fabs) < 0.05
    and (.[0].efficiency / .[1].efficiency - 1 | fabs) < 0.01' <(jq -s . over-run.json over-theory.json)
run beadswim-compare over-run.json over-theory.json --tolerance 0.01
has_status 0
run beadswim-theory over.json
has_status 0
check 'other methods ignore the wall' holds '[.predictions[].method] == ["oseen-perturbation", "rpy-perturbation", "multipole-perturbation", "oseen-ode", "rpy-ode"]' out
run beadswim-run over.json -o moments.h5md --model multipole --multipole-order 2 --progress none --cycles 4
has_status 0
mv out moments-run.json
check 'with force moments, a run does not move as predicted' holds '[.[0].swimmers[0].cycles[-1], (.[1].predictions[] | select(.method == "multipole-ode"))]
  | (.[0].velocity[0] / .[1].velocity_vector[0] - 1 | fabs) < 1e-3' <(beadswim-theory over.json --method multipole-ode | jq -s . moments-run.json -)

# --- `check` states the height and, with a flow, the strain per period
run beadswim-layout check --json over.json
has_status 0
check 'the height is wrong' holds '.smallest_relative_height == 6 and (.types.a | has("strain_per_period") or has("shear_reynolds") | not)' out

# --- models, ranks and a restart agree
run mpirun -n 2 beadswim-run over.json -o two.h5md "${settings[@]}" --cycles 2 --checkpoint-every 1
has_status 0
run beadswim-run --restart two.h5md -o on.h5md --cycles 4 --progress none --no-provenance
has_status 0
check 'ranks and a restart change the motion' holds '[., input] | map(.swimmers[0].cycles[-1].velocity[0]) | (.[0] / .[1] - 1 | fabs) < 1e-4' over-run.json out
for model in oseen rpy+near multipole; do
  run beadswim-run over.json -o model.h5md --model "$model" --cycles 2 --progress none --no-provenance
  has_status 0
  check "$model differs too much" holds '[., input] | map(.swimmers[0].cycles[1].velocity[0]) | .[0] / .[1] | . > 0.8 and . < 1.2' over-run.json out
done

# --- the same motion over a wall across another axis, in other units
beadswim-layout swimmer --preset paper-single --half-space x --position 24,0,0 --axis 0,1,0 --frame body >across_x.json
run beadswim-run across_x.json -o x.h5md "${settings[@]}" --cycles 4
has_status 0
check 'the axis of the wall matters' holds '[., input] | map(.swimmers[0].cycles[-1].velocity) | (.[0][0] / .[1][1] - 1 | fabs) < 1e-6 and (.[0][2] - .[1][0] | fabs) < 1e-6 * .[0][0]' over-run.json out

# --- a background flow moves a swimmer and turns it; strain acts only on beads with higher moments
over_wall 24 --amplitude 0 | jq '.flow = {velocity_gradient: [[0, 0, 1e-5], [0, 0, 0], [0, 0, 0]]}' >sheared.json
run beadswim-run sheared.json -o sheared.h5md "${settings[@]}" --cycles 1
has_status 0
check 'the swimmer does not move with the flow' holds '.flow.velocity_gradient[0][2] == 1e-5 and (.swimmers[0].cycles[0].velocity[0] / 24e-5 - 1 | fabs) < 1e-3' out
run beadswim-layout check --json sheared.json
has_status 0
check 'the numbers of the flow are wrong' holds '.types.a | (.strain_per_period / 0.048 - 1 | fabs) < 1e-12 and (.shear_reynolds / 48e-5 - 1 | fabs) < 1e-12' out
run beadswim-layout check sheared.json
out_has 'over the wall/radius of the bead +6$'
out_has 'strain of the background flow per period, G T +0.048$'
out_has 'Re of the shear = G lambda\^2/nu +0.00048$'
run beadswim-theory sheared.json --method rpy-ode
has_status 0
check 'theory does not move it with the flow' holds '.predictions[0].velocity_vector[0] / 24e-5 - 1 | fabs < 1e-3' out
run beadswim-run sheared.json -o sheared.h5md --model multipole --cycles 1 --progress none --no-provenance
has_status 0
check 'beads do not lag behind the flow' holds '.swimmers[0].cycles[0].velocity[0] / 24e-5 | . < 0.9999 and . > 0.98' out
jq '.domain = null | .flow = {velocity: [1e-4, 2e-4, 0]}' over.json >carried.json
beadswim-layout swimmer --preset paper-single --unbounded --frame body >free.json
run beadswim-run free.json -o free.h5md "${settings[@]}" --cycles 1
mv out free-run.json
run beadswim-run carried.json -o carried.h5md "${settings[@]}" --cycles 1
has_status 0
run beadswim-run <(jq '.flow.velocity = [0.2, 0, 0]' carried.json) -o fast.h5md "${settings[@]}" --cycles 1
has_status 0
mv out fast-run.json
check 'the Reynolds number contains the velocity of the flow' holds '[., input] | map(.dimensionless.reynolds_bead) | .[1] / .[0] - 1 | fabs < 1e-6' free-run.json fast-run.json
check 'a fast uniform flow changes the motion' holds '[., input] | map(.swimmers[0].cycles[0].velocity[0]) | .[1] - .[0] - 0.2 | fabs < 1e-7' free-run.json fast-run.json
run beadswim-run carried.json -o carried.h5md "${settings[@]}" --cycles 1
check 'a uniform flow changes more than the velocity' holds '[., input] | map(.swimmers[0].cycles[0].velocity) | (.[1][0] - .[0][0] - 1e-4 | fabs) < 1e-9 and (.[1][1] - 2e-4 | fabs) < 1e-9' free-run.json out

refuses 'unsteady-multipole: .*methods for this swimmer are oseen-perturbation, rpy-perturbation, multipole-perturbation, oseen-ode, rpy-ode, multipole-ode$' beadswim-theory over.json --method unsteady-multipole

# --- a run warns of beads that come to the wall later
beadswim-layout shape sphere --half-space z --position 0,0,30 --force 2 --direction 0,0,-1 --amplitude 0 >sink.json
run beadswim-run sink.json -o sink.h5md "${settings[@]}" --cycles 0.6
has_status 0
check 'no warning of the approach' holds '.warnings | any(.code == "wall-approach" and (.message | test("up to [0-9.]+ %; an expected error is for the height of 7.5 radii.*--multipole-order 2")))' out
run beadswim-run sink.json -o sink.h5md --model multipole --multipole-order 2 --cycles 0.6 --progress none
check 'the remedy is the run itself' holds '.warnings | any(.code == "wall-approach" and (.message | test("compare this run with --model lbm")))' out
run beadswim-run sink.json -o sink.h5md --model rpy+near --cycles 2 --progress none
check 'a repulsion by the wall names no lattice that treats it' holds '.warnings | any(.code == "repulsion" and (.message | test("artificial.* --model lbm in a box with the boundary no-slip")))' out
over_wall 8 >near.json
run beadswim-run near.json -o near.h5md "${settings[@]}" --cycles 0.2
check 'a warning although no bead approaches' holds '.warnings | all(.code != "wall-approach")' out

# --- oseen is refused, and stops, where its mobility is not positive: below 9/8 radii over a wall, and where beads of a row nearly touch
beadswim-layout shape sphere --radius 1 --half-space z --position 0,0,1.1 --force 1e-4 --amplitude 0 >low.json
refuses 'the mobility of oseen is not positive definite at rest: .* bead 1 of swimmer 0, .*use --model rpy' \
  beadswim-run low.json -o low.h5md --model oseen --cycles 1
refuses 'stroke: the mobility .*not positive definite' beadswim-theory low.json --method oseen-ode
row() { # SPACING AMPLITUDE
  beadswim-layout shape chain --unbounded | jq --argjson spacing "$1" --argjson amplitude "$2" '.types[] |= (
    .beads = [range(40) | {radius: 1, density: 1, at: [$spacing * ., 0, 0]}] | .bonds = [range(39) | {beads: [. + 1, . + 2], stiffness: 1}]
    | .angles = [] | .driving |= (del(.forces, .net_force) | .bonds = [range(39) | {bond: (. + 1), rest_length: [{amplitude: $amplitude, phase: 0}]}]))'
}
row 2.03 1e-6 >row.json
refuses 'the mobility of oseen is not positive definite at rest' beadswim-run row.json -o row.h5md --model oseen --cycles 1
jq '.domain = {lengths: [120, 40, 40], boundary: ["periodic", "periodic", "periodic"]} | .swimmers[0].position = [20, 20, 20]' row.json >boxed.json
refuses 'the mobility of oseen is not positive definite at rest' beadswim-run boxed.json -o row.h5md --model oseen --cycles 1
beadswim-layout shape sphere --radius 1 --half-space z --position 0,0,1.6 --force 10 --direction 0,0,-1 --amplitude 0 --period 10 >sinking.json
run beadswim-run sinking.json -o sinking.h5md --model oseen --steps-per-cycle 40 --cycles 3 --progress none
has_status 3
err_has 'not positive definite any more: .*use --model rpy'
row 2.3 0.1 >row.json
run beadswim-run row.json -o row.h5md --model oseen --cycles 1 --progress none
has_status 0

# --- the stated error of one sphere near the wall is at least that of Brenner's exact mobility
over_wall 4.6 >near.json  # 1.15 radii: 0.1267
for model in oseen:0.82 rpy:1.4 multipole:0.4; do
  run beadswim-run near.json -o near.h5md --model "${model%:*}" --cycles 0.1 --progress none
  check "$model states too small an error" holds ".expected_error.velocity > ${model#*:}" out
done

# --- pages and figures show the wall; the page of docs has the table of its records
writes_file() { # the command writes a file and no error
  run "$@"
  has_status 0
}
views over.h5md over.html &&
  check 'the page lacks the wall' grep -q '"walls":\[{"axis":2,"at":0.0}\]' over.html
writes_file beadswim-plot trajectories over.h5md --along z --against angle -o angle.svg
check 'the figure lacks the angle' grep -q 'angle of the axis to the plane across z' angle.svg
check 'the figure does not name the half-space' grep -q 'half-space z &gt; 0 over a no-slip wall' angle.svg
results=$BEADSWIM_SOURCE/docs/results
check "the page has other numbers than the records" cmp -s <(jq -rs -f "$results/walls.jq" "$results/walls.jsonl") \
  <(sed -n '/^<!-- from walls.jsonl -->$/,/^$/p' "$BEADSWIM_SOURCE/docs/walls.md" | sed '1d;$d')

# --- what cannot be treated is refused with the remedy
refuses 'over.json:/domain/half_space: a half-space is unbounded, but a lattice needs a box; use --model rpy or multipole, or a box' \
  beadswim-run over.json -o bad.h5md --model lbm
refuses 'over.json:/domain/half_space: the model unsteady lacks no-slip walls' beadswim-run over.json -o bad.h5md --model unsteady
refuses 'carried.json:/flow: the model unsteady lacks background flow' beadswim-run carried.json -o bad.h5md --model unsteady
refuses 'carried.json:/flow: a background flow is unbounded, but a lattice ends at its box' beadswim-run carried.json -o bad.h5md --model lbm
refuses 'bead 1 of radius 4 at .* is not completely in the fluid: its centre is 3.9 above the wall at z = 0' \
  beadswim-layout swimmer --preset paper-single --half-space z --position 0,0,3.9
refuses '--half-space: the wall is at the coordinate 0; give the position' beadswim-layout swimmer --preset paper-single --half-space z
refuses 'half-space' beadswim-layout swimmer --preset paper-single --half-space w --position 0,0,9
jq '.flow.velocity_gradient[1][1] = 1e-6' sheared.json >bad.json
refuses 'bad.json:/flow/velocity_gradient: the trace is 1e-06, but' beadswim-layout check bad.json
jq '.flow.velocity_gradient[0][1] = 1e-6' sheared.json >bad.json
refuses 'bad.json:/flow/velocity_gradient/0/1: over a no-slip wall at z = 0 only shear' beadswim-layout check bad.json
jq '.flow.velocity = [1e-5, 0, 0]' sheared.json >bad.json
refuses 'bad.json:/flow/velocity: the flow must be 0 on the no-slip wall' beadswim-layout check bad.json
jq '.body_force = [1e-5, 0, 0]' over.json >bad.json
refuses 'bad.json:/body_force: there are no no-slip walls' beadswim-layout check bad.json
beadswim-layout swimmer --preset paper-single --box 120,80,80 | jq '.flow = {velocity: [1e-5, 0, 0]}' >bad.json
refuses 'bad.json:/flow: a background flow is unbounded, but the domain is a box' beadswim-layout check bad.json
beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic,periodic,no-slip >slit.json
refuses 'slit.json:/domain/boundary/2: the boundary is no-slip at both ends' beadswim-run slit.json -o bad.h5md --model rpy
jq '.domain.half_space.axis = "w"' over.json >bad.json
refuses 'bad.json:/domain/half_space/axis: "w"' beadswim-layout check bad.json
jq '.domain.half_space.boundary = "free-slip"' over.json >bad.json
refuses 'bad.json:/domain/half_space/boundary: "free-slip"' beadswim-layout check bad.json
refuses '/domain: the fluid is unbounded .half-space' beadswim-layout reduce over.json
jq '.domain.lengths = [1, 1, 1]' over.json >bad.json
refuses 'bad.json:/domain/lengths: unknown key' beadswim-layout check bad.json
refuses '--box: the fluid of this layout ends at the wall of a half-space' beadswim-layout reduce over.json --box 120,80,80
run beadswim-theory <(beadswim-layout shape sphere --half-space z --position 0,0,5 --force 2 --direction 0,0,-1 --amplitude 0)
has_status 0
check 'a bead moves into the wall' holds '.predictions | map(select(.method == "rpy-ode")) | .[0].usable == false' out
jq '.swimmers = [range(6) | {id: ., type: "a", position: [0, 14 * ., 6], axis: [1, 0, 0]}]' over.json >six.json
run beadswim-layout defect jitter six.json --sigma 3 --seed 1 --repair
has_status 0
jq '.swimmers += [.swimmers[0] | .id = 1 | .position[0] += 300]' over.json >two.json
accepts beadswim-theory two.json --method rpy-ode
jq '.swimmers[1].position[2] += 1' two.json >bad.json
refuses 'swimmers 0 and 1 differ' beadswim-theory bad.json --method rpy-ode
run beadswim-theory sheared.json --method rpy-perturbation
has_status 2

finish
