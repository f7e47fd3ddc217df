#!/bin/bash
# Tests beadswim-run with the models rpy, rpy+near, multipole and oseen: runs without a lattice, which write the same types of files as
# lattice runs.
source "$(dirname "$0")/harness.sh"

small() { # RANKS ARGUMENT...
  mpirun -n "$1" beadswim-run "${@:2}" --progress none --no-provenance
}
decided() { # METHOD TOLERANCE RUN PREDICTION
  run beadswim-compare "$3" "$4" --method "$1" --tolerance "$2"
  has_status 0
}

# --- a swimmer in open space against the theory of its own mobility; the record is valid, and says what it took
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.2 >open.json
beadswim-theory open.json >theory.json
for model in rpy oseen rpy+near; do
  run beadswim-run open.json --model $model -o $model.h5md --steps-per-cycle 1000 --cycles 4 --progress none
  has_status 0
  check "the record names the model" holds ".model == \"$model\" and .momentum == null and .resolution == null and .mobility.products > 4000" out
  cp out $model.json
  decided "${model/rpy+near/multipole}-ode" 2e-6 $model.json theory.json
  check "power and efficiency are those of theory" holds --arg method "${model/rpy+near/multipole}-ode" --slurpfile theory theory.json \
    '($theory[0].predictions[] | select(.method == $method)) as $p | .swimmers[0].cycles[-1]
      | [.power / $p.power - 1, .efficiency / $p.efficiency - 1] | map(fabs) | max < 1e-5' $model.json
done
check "the trajectory has frames and axes without a box" test "$(h5dump -H -d /particles/beads/position/value rpy.h5md | grep -c '161, 3, 3')" -eq 1

# --- swarms: turned, with periods of their own and some swimmers missing; the same to the tolerance on 1 and 2 ranks
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,2,2 |
  beadswim-layout defect rotation --sigma 0.2 --seed 5 | beadswim-layout defect frequency --sigma 0.1 --seed 2 |
  beadswim-layout defect vacancy --count 2 --seed 1 >swarm.json
for model in rpy rpy+near multipole; do
  run small 1 swarm.json --model $model -o one.h5md --cycles 1.5
  has_status 0
  cp out one.json
  run small 2 swarm.json --model $model -o more.h5md --cycles 1.5
  has_status 0
  # Roundoff may change the number of products and iterations, and so velocities within their tolerance.
  check "velocities agree by $model on 2 ranks" holds --argjson near 1e-9 '[.[].swimmers[].cycles[0].velocity] | .[:(length / 2)] as $a | [$a, .[(length / 2):]] | transpose | all(.[]; [.[0], .[1]] | transpose | all(.[]; (.[0] - .[1] | fabs) < $near))' \
    <(jq -s . one.json out)
done

# --- records contain the scene of the layout, also without provenance, for up to 64 swimmers
scene_of_layout() { jq '{fluid, domain, types, swimmers}' "$1"; }
check "the record has not the layout's scene" cmp -s <(jq .scene one.json) <(scene_of_layout swarm.json)
beadswim-layout swarm --preset paper-uniform --blocks 1,5,13 --block-swimmers 1,1,1 >many.json
run small 1 many.json --model oseen --sum-tolerance 0.01 --cycles 0.02 -o many.h5md
has_status 0
check "the record of 65 swimmers has a scene" holds '.scene == null and .swimmers == null' out

# --- stopped by time, and gone on, with the bits of an unbroken run
for model in multipole rpy+near; do
  run small 2 swarm.json --model $model -o whole.h5md --cycles 1.5
  has_status 0
  cp out whole.json
  run small 2 swarm.json --model $model -o part.h5md --cycles 0.7 --checkpoint-every 0.35
  has_status 0
  run small 2 --restart part.h5md --cycles 1.5
  has_status 0
  check "the record of $model is that of an unbroken run" cmp -s out whole.json
  check "all datasets of $model are those of an unbroken run" h5diff whole.h5md part.h5md
done
refuses '^beadswim-run: --model: the value lbm differs from rpy\+near, ' beadswim-run --restart part.h5md --model lbm --cycles 3

# --- beads that are driven together repel each other, and the run says so
beadswim-layout swimmer --preset paper-single --unbounded --arm 14 --amplitude 0.4 >close.json
run beadswim-run close.json --model rpy -o close.h5md --cycles 2 --progress none
has_status 0
err_has 'warning: beads came within .* and were repelled'
check "the gap stays open" holds '.mobility.smallest_gap | . > 0 and . < 0.8' out

# --- a torn arm stops the run on all ranks with a message
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 3 >torn.json
run small 2 torn.json --model rpy -o torn.h5md --steps-per-cycle 200
has_status 3
err_has 'the arm from bead . of swimmer 0 at .* to bead . is torn: its length is .* times the rest length, above the limit of 2'
check "the record reaches up to it" holds '.status == "failed" and .state_sha256 == null' out

# --- what the model cannot do
beadswim-layout swimmer --preset paper-single --box 100,60,60 >box.json
refuses '^beadswim-run: --cells-per-radius: the setting applies to the lattice only' beadswim-run open.json --model rpy -o x.h5md --cells-per-radius 3
refuses '^beadswim-run: --sum-tolerance: the setting applies to mobility models only' \
  beadswim-run box.json --model lbm -o x.h5md --sum-tolerance 1e-3
refuses '^beadswim-run: --sum-tolerance: .*0.5.* a number from 1e-12 to 0.01' \
  beadswim-run open.json --model rpy -o x.h5md --sum-tolerance 0.5

refuses '^beadswim-run: --multipole-order: the setting applies to the models multipole and unsteady only' beadswim-run open.json --model rpy -o x.h5md --multipole-order 1
refuses '^beadswim-run: --multipole-order: .*3.* 0 to 2' beadswim-run open.json --model multipole -o x.h5md --multipole-order 3

# --- --tolerance is a plan's
for model in lbm rpy; do
  refuses '^beadswim-run: --tolerance: the flag applies to --plan and --model auto only; leave it out, or use --sum-tolerance$' \
    beadswim-run open.json --model $model -o x.h5md --tolerance 1e-3
done
beadswim-layout swimmer --preset paper-single --box 100,60,60 --boundary no-slip >walls.json
refuses 'walls.json:/domain/boundary/0: the boundary is no-slip' beadswim-run walls.json --model rpy -o x.h5md
check "no file is left" test ! -e x.h5md

rest_is_long

# --- springs so stiff that the velocity is roundoff of the positions: the run says so
beadswim-layout swimmer --preset paper-single --unbounded --period 2000 --amplitude 0.2 --stiffness 3.47e6 >stiff.json
beadswim-theory stiff.json --method multipole-ode >theory.json
run beadswim-run stiff.json --model rpy+near -o stiff.h5md --cycles 4 --progress none
err_has 'the velocity is expected to be wrong by more than 1000 %'
check "the stated uncertainty covers the error" holds --slurpfile theory theory.json \
  '.swimmers[0] | (.cycles[-1].speed_along_axis / $theory[0].predictions[0].velocity - 1 | fabs) as $error
    | $error > 1 and .uncertainty.velocity.total > $error' out

# --- beads that are pressed together at a gap far below a fifth of a radius: steps resolve the contact
beadswim-layout swimmer --preset paper-single --period 2000 --amplitude 0.05 --arm 8.004 --unbounded >pressed.json
for steps in 120 960; do
  run beadswim-run pressed.json --model rpy+near -o pressed.h5md --cycles 3 --steps-per-cycle $steps --progress none
  has_status 0
  cp out pressed-$steps.json
done
check "the velocity does not depend on the time step" holds -s \
  'map(.swimmers[0].cycles[-1].speed_along_axis) | .[0] / .[1] - 1 | fabs < 0.01' pressed-120.json pressed-960.json

# --- in the layout's own box, periodic and midway between walls
for boundary in periodic periodic,free-slip,free-slip; do
  beadswim-layout swimmer --preset paper-single --box 100,60,60 --boundary $boundary --amplitude 0.2 >box.json
  beadswim-theory box.json >theory.json
  run beadswim-run box.json --model rpy -o box.h5md --steps-per-cycle 400 --cycles 3 --sum-tolerance 1e-6 --progress none
  has_status 0
  cp out box.run.json
  decided rpy-box-ode 1e-4 box.run.json theory.json
done

# --- force moments: order 0 is rpy, order 1 and 2 are near exact flow
run small 1 open.json --model rpy -o order.h5md --cycles 0.5
cp out order.json
run small 1 open.json --model multipole --multipole-order 0 -o order.h5md --cycles 0.5
check "order 0 has the bits of rpy" holds --slurpfile rpy order.json '.state_sha256 == $rpy[0].state_sha256 and .mobility.iterations == 0' out
beadswim-theory open.json --method multipole-ode,rpy-ode >exact.json
for order in 1 2; do
  run small 1 open.json --model multipole --multipole-order $order -o order.h5md --cycles 2
  has_status 0
  check "order $order is near exact flow" holds --argjson order $order --slurpfile theory exact.json '
    ([$theory[0].predictions[] | {(.method): .velocity}] | add) as $v
    | .mobility.multipole_order == $order and .mobility.residual < 1e-4
      and ((.swimmers[0].cycles[-1].speed_along_axis - $v["multipole-ode"]) / ($v["rpy-ode"] - $v["multipole-ode"]) | . > 0 and . < [0.06, 0.01][$order - 1])' out
done
run small 1 swarm.json --model multipole --plan
check "its plan has a cost and an error" holds '.runs | length == 1 and (.[0] | .model == "multipole" and .cost.core_seconds > 0 and .error.velocity > 0 and (.flags | endswith("--multipole-order 1")))' out

finish
