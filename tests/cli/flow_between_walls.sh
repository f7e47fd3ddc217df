#!/bin/bash
# Tests flow between no-slip walls, which moving walls or a body force drive, and the input that is refused.
source "$(dirname "$0")/harness.sh"

# A free sphere between walls, of which the upper one moves along x and y.
beadswim-layout shape sphere --radius 3 --force 0 --amplitude 0 --direction 1,0,0 --period 500 --viscosity 0.33333333 --density 1 \
  --units lattice --box 24,24,30 --boundary periodic,periodic,no-slip --position 12,12,20 >at_rest.json
moving() { # LOWER UPPER OUTPUT
  jq --argjson lower "$1" --argjson upper "$2" \
    '.domain.boundary[2] = {"no-slip": {lower_velocity: $lower, upper_velocity: $upper}}' at_rest.json >"$3"
}
moving '[0,0,0]' '[0.01,-0.006,0]' walls.json
settings=(--cells-per-radius 3 --relaxation-time 1.5 --progress none --no-provenance)

# --- the fluid moves with the walls; the sphere moves with the fluid
accepts beadswim-layout check walls.json
run beadswim-run walls.json -o one.h5md "${settings[@]}" --cycles 6
has_status 0
mv out one.json
check 'the sphere does not move at 2/3 of the velocity of the wall' \
  holds '.swimmers[0].cycles[-1].velocity | (.[0] / (0.01 * 2 / 3) - 1 | fabs) < 0.03 and (.[1] / .[0] + 0.6 | fabs) < 1e-4 and (.[2] | fabs) < 1e-4' one.json
check 'the mean velocity of the fluid is not half of that of the wall' \
  holds '.swimmers[0].cycles[-1].mean_flow | (.[0] / 0.005 - 1 | fabs) < 0.03' one.json
check 'the record lacks the walls' holds '.domain.boundary[2]["no-slip"].upper_velocity == [0.01, -0.006, 0]' one.json

# --- the same bits on three ranks and across a restart, with a body force and levels of cells that follow a pulled sphere
beadswim-layout shape sphere --radius 3 --force 2 --amplitude 0 --direction 3,2,1 --period 400 --viscosity 0.16666667 --density 1 \
  --units lattice --box 72,64,64 --boundary periodic,periodic,no-slip --position 50,32,32 |
  jq '.domain.boundary[2] = {"no-slip": {lower_velocity: [0.01, 0, 0], upper_velocity: [0, 0.02, 0]}} | .body_force = [1e-6, 2e-6, 0]' >pulled.json
levels=(--cells-per-radius 3 --relaxation-time 1 --refine 1 --progress none --no-provenance)
run beadswim-run pulled.json -o one.h5md "${levels[@]}" --cycles 1
has_status 0
mv out one-pulled.json
run mpirun -n 3 beadswim-run pulled.json -o three.h5md "${levels[@]}" --cycles 0.5 --checkpoint-every 0.25 --precision double
has_status 0
run mpirun -n 2 beadswim-run --restart three.h5md -o three-on.h5md --cycles 1 --progress none --no-provenance
has_status 0
check 'ranks and a restart change the state' test "$(jq .state_sha256 one-pulled.json)" = "$(jq .state_sha256 out)"
check 'fluid at rest has momentum' holds '.momentum.initial | map(fabs) | max < 1e-12' one-pulled.json
run beadswim-run pulled.json -o uniform.h5md --cells-per-radius 3 --relaxation-time 1 --cycles 1 --progress none --no-provenance
has_status 0
check 'levels change the flow' holds '[., input] | map(.swimmers[0].cycles[0]) | (.[0].velocity[0] / .[1].velocity[0] - 1 | fabs) < 0.003
  and (.[0].mean_flow[1] / .[1].mean_flow[1] - 1 | fabs) < 0.003' one-pulled.json out
run beadswim-run walls.json -o single.h5md "${settings[@]}" --cycles 6 --precision single
has_status 0
check 'single precision changes the flow' holds '[., input] | map(.swimmers[0].cycles[-1].velocity[0]) | (.[0] / .[1] - 1 | fabs) < 1e-3' one.json out

# Prints the velocity along x at the corner of the box, for each plane of the last flow field of a run.
profile() { # TRAJECTORY
  python3 - "$(ls "$1".flow/*.vti | tail -1)" <<'PYTHON'
import base64, struct, sys, xml.etree.ElementTree as xml
image = xml.parse(sys.argv[1]).getroot().find("ImageData")
nx, ny, nz = (int(n) for n in image.get("WholeExtent").split()[1::2])
velocity = next(array for array in image.iter("DataArray") if array.get("Name") == "velocity")
numbers = struct.unpack(f"<{3 * nx * ny * nz}f", base64.b64decode(velocity.text.strip())[8:])
print([numbers[3 * nx * ny * z] for z in range(nz)])
PYTHON
}

# --- a body force drives plane Poiseuille flow, with the velocity g z (h - z)/(2 rho nu), whose mean over cells is
# g (2 h^2 + 1)/(24 rho nu). A small free sphere hardly disturbs the flow.
beadswim-layout shape sphere --radius 1 --force 0 --amplitude 0 --direction 1,0,0 --period 500 --viscosity 0.33333333 --density 1 \
  --units lattice --box 16,16,8 --boundary periodic,periodic,no-slip --position 8,8,4 | jq '.body_force = [4.1666666666666665e-5, 0, 0]' >slit.json
run beadswim-run slit.json -o slit.h5md --cells-per-radius 1 --relaxation-time 1.5 --bead-boundary psm --progress none --no-provenance \
  --cycles 2 --flow-every 1
has_status 0
profile slit.h5md >profile.json
check 'the velocities are not those of Poiseuille flow' holds \
  'to_entries | all(.key as $z | .value / (6.25e-5 * ($z + 0.5) * (7.5 - $z)) - 1 | fabs < 0.003)' profile.json
check 'the mean flow is not that of Poiseuille' holds '.swimmers[0].cycles[-1].mean_flow[0] / (6.25e-5 * 129 / 12) - 1 | fabs < 0.003' out
# The sphere has the momentum of fluid, and of the mass 4 pi/3 9/2 nu (3/2 (tau - 1/2) + 1) that corrects the delay of its force.
check 'the momentum is not that of flow and sphere' holds \
  '.swimmers[0].cycles[-1] as $cycle | .momentum.total[0] / (16 * 16 * 8 * $cycle.mean_flow[0] + 15.708 * $cycle.velocity[0]) - 1 | fabs < 0.001' out

# --- the same with a larger sphere, in any units
jq '.body_force = [4e-5, 0, 0] | .swimmers[0].position[2] = 15' at_rest.json >forced.json
run beadswim-run forced.json -o forced.h5md "${settings[@]}" --cycles 4
has_status 0
check 'the mean velocity is not that of Poiseuille flow' \
  holds '.swimmers[0].cycles[-1].mean_flow[0] / (4e-5 * 900 / 12 * 3) | . > 0.97 and . < 1.01' out
check 'the record lacks the body force' holds '.scene.body_force == [4e-5, 0, 0] and .body_force == .scene.body_force' out
jq '.units = {length: "um", time: "ms", mass: "pg"} | .fluid.density = 2 | .fluid.kinematic_viscosity *= 0.25 | .body_force[0] *= 0.125
  | .domain.lengths |= map(. * 0.5) | .swimmers[0].position |= map(. * 0.5) | .types[].beads[0] |= (.radius *= 0.5 | .density *= 2)' \
  forced.json >in_units.json
run beadswim-run in_units.json -o units.h5md "${settings[@]}" --cycles 4
has_status 0
# Velocity has the unit length/time: half the length, in an equal time. The force per volume has rho L/T^2: twice the density.
check 'another unit system gives another flow' \
  holds '.swimmers[0].cycles[-1].mean_flow[0] / (0.125 * 4e-5 * 225 / 12 / 2 / (0.33333333 / 4)) | . > 0.97 and . < 1.01' out

# --- filters keep the walls; other walls are another scene
beadswim-layout defect jitter walls.json --sigma 0.5 --seed 1 >jittered.json
check 'a filter loses the velocity of walls' holds '.domain.boundary[2]["no-slip"].upper_velocity[1] == -0.006' jittered.json

# --- refused
refuses '--box: a background flow, walls or a body force move the fluid of this layout' beadswim-layout reduce walls.json --box 60,60,60
jq '.domain.boundary[0] = "no-slip"' walls.json >bad.json
refuses 'bad.json:/domain/boundary/2/no-slip/upper_velocity/0: the wall cannot move along x, because no-slip walls close this axis; set this component to 0' \
  beadswim-layout check bad.json
moving '[0,0,0]' '[0.01,0,0.001]' bad.json
refuses 'bad.json:/domain/boundary/2/no-slip/upper_velocity: the velocity \(0.01, 0, 0.001\) has a component across the wall, along z; walls move along themselves: set this component to 0' \
  beadswim-layout check bad.json
jq '.domain.boundary[2]["no-slip"] |= del(.upper_velocity)' walls.json >bad.json
refuses 'the object lacks the key "upper_velocity"' beadswim-layout check bad.json
jq '.domain.boundary[2] = {"free-slip": .domain.boundary[2]["no-slip"]}' walls.json >bad.json
refuses 'free-slip: unknown key. Keys allowed here: no-slip' beadswim-layout check bad.json
moving '[0.2,0,0]' '[0,0,0]' bad.json
refuses 'bad.json:/domain/boundary/2: a wall moves by 0.2 cells in a time step, but only 0.1 are permitted; use a smaller --relaxation-time or more --cells-per-radius' \
  beadswim-run bad.json -o x.h5md --cells-per-radius 3 --relaxation-time 1.5
jq '.body_force = [0.01, 0, 0]' at_rest.json >bad.json
refuses 'bad.json:/body_force: the fluid would move by [0-9.]* cells in a time step, but only 0.1 are permitted; use a smaller' \
  beadswim-run bad.json -o x.h5md --cells-per-radius 3 --relaxation-time 1.5
jq '.body_force = [0, 0, 1e-5]' at_rest.json >bad.json
refuses 'bad.json:/body_force/2: the fluid cannot flow along z, because walls close this axis; set this component to 0' \
  beadswim-layout check bad.json
jq '.body_force = [1e-5, 0, 0] | .domain.boundary[2] = "periodic"' at_rest.json >bad.json
refuses 'bad.json:/body_force: there are no no-slip walls' beadswim-layout check bad.json
refuses 'boundary/2: the boundary is no-slip at both ends of the axis, but mobility models' beadswim-run walls.json -o x.h5md --model rpy
check 'a run that was refused leaves files' test ! -e x.h5md

finish
