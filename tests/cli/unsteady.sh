#!/bin/bash
# Tests beadswim-run with the model unsteady: fluid inertia without a lattice, against theory with inertia; restarts and limits.
source "$(dirname "$0")/harness.sh"

unsteady() { # RANKS LAYOUT ARGUMENT...
  run mpirun -n "$1" beadswim-run "$2" --model unsteady --progress none --no-provenance "${@:3}"
}
# True if velocity and arm amplitudes of the last cycle are those of a method, within relative limits.
agrees() { # METHOD VELOCITY ARMS
  beadswim-theory swimmer.json --method "$1" >theory.json
  holds --slurpfile theory theory.json --argjson velocity "$2" --argjson arms "$3" '
    $theory[0].predictions[0] as $p | .swimmers[0].cycles[-1]
    | ((.speed_along_axis - .mean_flow[0]) / $p.velocity - 1 | fabs < $velocity)
      and ([.arm_amplitudes, $p.arm_amplitudes] | transpose | all(.[]; .[0] / .[1] - 1 | fabs < $arms))' out
}

# --- heavy beads in a periodic box at small amplitude: order 0 has the strokes of pairs with inertia, order 2 nearly exact motion
beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic --position 60,40,40 --period 2000 --amplitude 0.02 --bead-density 3 >swimmer.json
unsteady 1 swimmer.json -o order.h5md --cycles 4 --multipole-order 0
has_status 0
check "strokes at order 0 are those of pairs with inertia" agrees unsteady-response 0.05 0.001
check "the momentum of fluid and beads is zero" holds '(.momentum.total | map(fabs) | max) < 1e-12 and .swimmers[0].cycles[-1].mean_flow[0] < 0' out
unsteady 1 swimmer.json -o order.h5md --cycles 4 --multipole-order 2 --steps-per-cycle 60
has_status 0
check "motion at order 2 is that of theory" agrees inertia-corrected 0.01 0.001
check "the record has the model's settings" holds '.model == "unsteady" and (.mobility | .multipole_order == 2 and .reynolds_stress and .residual < 1e-4 and .mesh_spacing <= 4.8)' out

rest_is_long

# --- repeated cells move like one cell: the mesh is fine enough for swarms, in which modes of the flow add up
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,3,3 --blocks 3,2,2 >swarm.json
unsteady 2 swarm.json -o swarm.h5md --cycles 1 --multipole-order 1
has_status 0
jq '.swarm[-1].swimming.velocity' out >velocity.json
beadswim-layout reduce swarm.json >cell.json
unsteady 2 cell.json -o cell.h5md --cycles 1 --multipole-order 1
has_status 0
check "108 swimmers have the velocity of one in a cell" holds --slurpfile swarm velocity.json '$swarm[0][0] / .swimmers[0].cycles[-1].velocity[0] - 1 | fabs < 0.005' out

# --- in open space, a large periodic cube replaces it
beadswim-layout swimmer --preset paper-single --unbounded --period 2000 --amplitude 0.02 >swimmer.json
unsteady 2 swimmer.json -o open.h5md --cycles 3 --multipole-order 0 --steps-per-cycle 40
has_status 0
err_has 'warning: the model unsteady replaces open space by a periodic cube of edge 240;'
check "strokes are those in open space" agrees unsteady-response 0.05 0.005

# --- the Reynolds stress and free-slip walls matter; a swarm goes on from a checkpoint with the bits of an unbroken run
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 | beadswim-layout defect rotation --sigma 0.2 --seed 5 |
  jq '.domain.boundary[2] = "free-slip"' >swarm.json
for order in 0 1; do
  unsteady 2 swarm.json -o whole.h5md --cycles 1 --multipole-order $order
  has_status 0
  cp out whole.json
  unsteady 2 swarm.json -o part.h5md --cycles 0.5 --checkpoint-every 0.25 --multipole-order $order
  has_status 0
  rm -f other.*
  cp part.h5md.ckpt.1 other.h5md.ckpt.1
  cp part.h5md other.h5md
  run mpirun -n 2 beadswim-run --restart part.h5md --cycles 1 --progress none --no-provenance
  has_status 0
  check "the record is that of an unbroken run" cmp -s out whole.json
  check "all datasets are those of an unbroken run" h5diff whole.h5md part.h5md
  run mpirun -n 3 beadswim-run --restart other.h5md --cycles 1 --progress none --no-provenance
  has_status 0
  check "the record on other ranks agrees" holds --slurpfile whole whole.json '
    [[.swimmers[].cycles[0].velocity], [$whole[0].swimmers[].cycles[0].velocity]] | transpose
    | all(.[]; transpose | all(.[]; (.[0] - .[1] | fabs) < 1e-8))' out
done
unsteady 2 swarm.json -o still.h5md --cycles 1 --multipole-order 1 --reynolds-stress off
has_status 0
check "the Reynolds stress changes velocities" holds --slurpfile whole whole.json '.mobility.reynolds_stress == false
  and (.swimmers[0].cycles[0].velocity[0] / $whole[0].swimmers[0].cycles[0].velocity[0] - 1 | fabs | . > 1e-4 and . < 0.1)' out

# --- plans: every order, or the one that is asked for; auto runs it where it is the cheapest within the tolerance
run beadswim-run swarm.json --model unsteady --plan --tolerance 0.5
has_status 0
check "a plan has all orders" holds '[.runs[].flags] == [range(3) | "--model unsteady --multipole-order \(.)"] and all(.runs[]; .error.velocity > 0 and .cost.core_seconds > 0)' out
check "higher orders have smaller errors" holds '[.runs[].error.velocity] | .[0] > .[1] and .[1] > .[2]' out
run beadswim-run swarm.json --model unsteady --multipole-order 1 --plan --tolerance 0.5
check "a plan has the order asked for" holds '[.runs[].flags] == ["--model unsteady --multipole-order 1"]' out

# --- limits: each names a model that can
refuses '^beadswim-run: --reynolds-stress: the setting applies to the model unsteady only' beadswim-run swarm.json --model rpy -o x.h5md --reynolds-stress off
refuses '^beadswim-run: --reynolds-stress: the setting applies to mobility models only' beadswim-run swarm.json --model lbm -o x.h5md --reynolds-stress off
limit() { # REGEX JQ-PROGRAM
  jq "$2" swarm.json >limit.json
  refuses "^beadswim-run: limit.json: $1" beadswim-run limit.json --model unsteady -o x.h5md
}
limit 'the radius 6 of a bead is .* times the penetration depth .*--model lbm' '.types[].driving.period = 100'
limit 'the largest bead radius is 5 times the smallest, .*--model lbm' '.types[].beads[0].radius = 1.2'
limit 'a bead of density 0.01 .*is too light for the time steps .* at least .*--model lbm' '.types[].beads[1].density = 0.01 | .types[].driving.period = 400'
limit 'the box needs a mesh of .* points .*--model rpy' '.domain.lengths = [6000, 6000, 6000]'
beadswim-layout shape sphere >towed.json
refuses '^beadswim-run: towed.json: driving forces that do not sum to zero need a box .*--model rpy' beadswim-run towed.json --model unsteady -o x.h5md
jq '.domain.boundary[1] = "no-slip"' swarm.json >limit.json
refuses 'the boundary is no-slip at both ends of the axis, but .*--model lbm' beadswim-run limit.json --model unsteady -o x.h5md

# --- the page has the table of its records
page=$BEADSWIM_SOURCE/docs/fluid-inertia.md
(cd "$BEADSWIM_SOURCE/docs/results" && jq -rn -f memory-scenes.jq --slurpfile lattice memory-scenes-lattice.jsonl --slurpfile models memory-scenes-models.jsonl) >table.md
check "the page has the records' table" cmp -s table.md <(sed -n '/^<!-- from the records -->$/,/^<!-- end -->$/p' "$page" | sed '1d;$d')

finish
