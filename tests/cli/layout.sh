#!/bin/bash
# Tests beadswim-layout: the layouts that it writes, its help and messages, and its use in pipes.
source "$(dirname "$0")/harness.sh"

# --- what it says of itself
accepts beadswim-layout --help
out_has 'swimmer'
out_has 'check'
accepts beadswim-layout --version
out_has '^beadswim-layout [0-9]+\.[0-9]+\.[0-9]+ \(.+\)$'
accepts beadswim-layout swimmer --help
for flag in preset radius arm stiffness damping angular-stiffness bead-density amplitude phase period viscosity density \
  frame box boundary unbounded jsonl; do
  out_has "^  --$flag"
done
accepts beadswim-layout check --help

# --- wrong command lines
refuses 'a command is needed: swimmer, swarm, shape, from-run, defect, combine, reduce, units, vary, check' beadswim-layout
refuses 'swimer: unknown command; did you mean "swimmer"' beadswim-layout swimer
refuses 'swimer: unknown command' beadswim-layout swimer --help
for box in '80 48 48' '80, 48, 48' '80,48 48'; do
  refuses '48,?: unexpected argument; join the numbers of one flag by commas|"80,?(48)?" has [12] values, but 3 are needed, separated by commas' \
    beadswim-layout swimmer --preset paper-single --box $box
done
refuses '--no-such-flag: unknown flag. "beadswim-layout --help" lists all flags' beadswim-layout --no-such-flag
refuses '--raduis: unknown flag; did you mean --radius' beadswim-layout swimmer --raduis=4
refuses 'required flags are missing: --stiffness, --amplitude' beadswim-layout swimmer --radius 4 --arm 20 --box 99,99,99
refuses '--preset: unknown value "paper-singel"; did you mean "paper-single"' beadswim-layout swimmer --preset paper-singel
refuses '--preset: unknown value "paper-uniform". Valid values: paper-single; some presets belong to the other command, swimmer or swarm' \
  beadswim-layout swimmer --preset paper-uniform
refuses '--beads: no such flag: a swimmer has three beads and two arms; --radius, --bead-density and --arm describe them' \
  beadswim-layout swimmer --preset paper-single --beads 4
refuses '--beads: no such flag: a swimmer has three beads' beadswim-layout swarm --preset paper-uniform --num-beads=4
refuses '--bead: unknown flag; did you mean --bead-density' beadswim-layout swimmer --preset paper-single --bead 4
refuses '--tolerance: "5%": the value must be a number from 0 to 0.5; write 5 % as 0.05' \
  beadswim-layout reduce layout.json --tolerance 5%
refuses '--amplitude: "5 %": the value must be a finite number, 0 or greater; write 5 % as 0.05' \
  beadswim-layout swimmer --preset paper-single --amplitude '5 %'
refuses '--radius: "4,5" has 2 values, but 1 or 3' beadswim-layout swimmer --preset paper-single --radius 4,5
refuses '--radius: the flag is given 2 times' beadswim-layout swimmer --preset paper-single --radius 4 --radius 5
refuses '--axis: required but not given; see "beadswim-layout defect spacing --help"' beadswim-layout defect spacing layout.json
refuses '--sigma: "-5deg": the angle must be 0 or greater' beadswim-layout defect rotation layout.json --sigma=-5deg
refuses '--sigma: "5deg": the value must be a number' beadswim-layout defect jitter layout.json --sigma 5deg
refuses '--fraction: "2": the value must be a number from 0 to 1' beadswim-layout defect vacancy layout.json --fraction 2
refuses '--radius: the flag needs a value' beadswim-layout swimmer --preset paper-single --radius
refuses '--period: "": the value must be' beadswim-layout swimmer --preset paper-single --period ""
for word in nan inf -inf 1e999 4x ""; do
  refuses '--amplitude: ' beadswim-layout swimmer --preset paper-single "--amplitude=1,$word"
done
refuses '--box: the flag cannot be combined with --unbounded; remove one of the two flags' beadswim-layout swimmer --preset paper-single --unbounded --box 99,99,99
refuses '--units: unknown value "pgg"; did you mean "pg"' beadswim-layout swimmer --preset paper-single --units um,s,pgg
refuses '--units: the preset is in lattice units, .* give one --radius, --viscosity and --density in the units um, s and mg' \
  beadswim-layout swimmer --preset paper-single --units um,s,mg --radius 1 --viscosity 1e6
refuses '--units: .* give one --radius' beadswim-layout swimmer --preset paper-single --units um,s,mg --radius 1,1,2 --viscosity 1e6 --density 1e-9
refuses 'bead 1 .* not completely between the walls along x' beadswim-layout swimmer --preset paper-single --box 20,20,20
refuses 'overlaps .* through the periodic boundary' \
  beadswim-layout swimmer --preset paper-single --box 20,20,20 --boundary periodic

# --- layouts
same_bytes 'beadswim-layout swimmer --preset paper-single' 'cd / && LC_ALL=C TZ=UTC beadswim-layout swimmer --preset paper-single'
out_has '"schema": "beadswim/layout/1"'
out_has '"lengths": \[1200.0, 800.0, 800.0\], "boundary": \["free-slip", "free-slip", "free-slip"\]'
out_has '"angular_stiffness": 138.8'
out_has '"position": \[600.0, 400.0, 400.0\]'
out_has '"cells_per_radius": 4.0, "relaxation_time": 1.5'
cp out paper.json

accepts beadswim-layout swimmer --preset paper-single --radius 3,4,5 --arm 18,27 --stiffness 0.03,0.06 --damping 0,2 \
  --amplitude 0.2,0 --phase=-0.5 --unbounded
out_has '"domain": null'
out_has '"stiffness": 0.06, "rest_length": 27.0, "damping": 2.0'
out_has '"amplitude": \[0.2, 0.0\], "phase": -0.5'

accepts beadswim-layout swimmer --radius 4 --arm 20 --stiffness 0.03 --amplitude 0.1 --period 1000 --viscosity 0.2 \
  --density 2 --units um,ms,pg --box 100,50,50 --boundary periodic,no-slip,free-slip --frame body --axis 0,0,-2
out_has '"units": \{ "length": "um", "time": "ms", "mass": "pg" \}'
out_has '"axis": \[0.0, 0.0, -1.0\]'
out_has '"radius": 4.0, "density": 2.0'
out_has '"phase": 1.5707963267948966'

# --- a preset in other units: the same scene. A bead of 1 um in water has cells of 0.25 um, steps of 0.25^2/3 us and
# masses of 0.25^3 pg.
water=(--units um,us,pg --radius 1 --viscosity 1 --density 1)
accepts beadswim-layout swimmer --preset paper-single "${water[@]}"
cp out um.json
accepts beadswim-layout swimmer --preset paper-single
check 'all numbers of the layout are converted' holds --slurpfile um um.json '
  def is(a; b): (a - b) / b | fabs < 1e-12;
  0.25 as $cell | ($cell * $cell / 3) as $step | ($cell * $cell * $cell) as $mass | ($mass * $cell / ($step * $step)) as $force |
  .types.a as $a | $um[0].types.a as $b |
  is($b.beads[0].radius; 1) and is($b.beads[2].density; 1) and
  is($b.springs[0].rest_length; $cell * $a.springs[0].rest_length) and
  is($b.springs[1].stiffness; $a.springs[1].stiffness * $force / $cell) and
  is($b.angular_stiffness; $a.angular_stiffness * $force * $cell) and
  is($b.driving.amplitude[1]; $a.driving.amplitude[1] * $force) and is($b.driving.period; $a.driving.period * $step) and
  is($um[0].domain.lengths[0]; 300) and is($um[0].swimmers[0].position[1]; $cell * .swimmers[0].position[1]) and
  $um[0].resolution == .resolution and $um[0].fluid == {density: 1, kinematic_viscosity: 1}' out
dimensionless='[.types.a | .reynolds_bead, .radius_over_penetration_depth, .arm_over_radius[0], .drag_over_spring[0], .mach, .steps_per_period]'
for preset in swimmer/paper-single swarm/paper-uniform swarm/paper-defect; do
  beadswim-layout "${preset%/*}" --preset "${preset#*/}" | beadswim-layout check --json | jq "$dimensionless | map(1e9 * . | round)" >lattice.numbers
  beadswim-layout "${preset%/*}" --preset "${preset#*/}" "${water[@]}" >water.json
  check "$preset: the same dimensionless numbers" cmp lattice.numbers <(beadswim-layout check --json water.json | jq "$dimensionless | map(1e9 * . | round)")
done
check 'the box of a swarm is converted, too' holds '.domain.lengths == [20, 20, 20]' water.json
accepts beadswim-layout swimmer --preset paper-single "${water[@]}" --period 100 --box 50,20,20 --boundary periodic
check 'other flags are in the new units' holds '.types.a.driving.period == 100 and .domain.lengths == [50, 20, 20]' out

# --- several layouts in one scene
beadswim-layout swimmer --preset paper-single --unbounded --frame body >one.json
accepts beadswim-layout combine one.json one.json --at 0,0,30 --rotate '180deg z'
check 'the second swimmer is not turned and displaced' holds '[.swimmers[].id] == [0, 1] and .swimmers[1].position == [0, 0, 30] and
  (.swimmers[1].axis[0] + 1 | fabs) < 1e-15 and (.types | keys) == ["a"] and .schema == "beadswim/layout/1"' out
same_bytes 'beadswim-layout combine one.json one.json --at 0,0,0 --at 0,0,30' 'cat one.json | beadswim-layout combine - one.json --at 0,0,0 --at=0,0,30'
refuses 'the layout made by the layouts together is invalid: .* overlaps bead .*; --at moves swimmers' beadswim-layout combine one.json one.json
refuses 'paper.json: the domain is box|paper.json: the domain is 1200' beadswim-layout combine one.json paper.json --at 0,0,9
refuses '--at: the flag is given 3 times for 2 layouts' beadswim-layout combine one.json one.json --at 0,0,1 --at 0,0,2 --at 0,0,3
for turn in 90deg '90deg w' '90 0,0,0' 'x z' '1 0,1'; do
  refuses "--rotate: \"$turn\": .* write \"ANGLE AXIS\"" beadswim-layout combine one.json --rotate "$turn"
done

# --- phases in degrees; a phase of more than one turn is probably one
accepts beadswim-layout swimmer --preset paper-single --phase=-90deg
out_has '"phase": -1.5707963267948966'
err_empty
beadswim-layout check out >table
check "check does not state the phase" grep -qE '^  driving phase alpha \[rad\] +-1\.571$' table
run beadswim-layout swimmer --preset paper-single --phase 90
has_status 0
out_has '"phase": 90'
err_has '^beadswim-layout: warning: --phase: 90 rad is more than one turn; if the value is in degrees, write --phase=90deg$'
refuses '--phase: "90 degrees": the value must be a finite number of radians, or of degrees such as 90deg' \
  beadswim-layout swimmer --preset paper-single --phase "90 degrees"

# --- on one line, for streams: the same scene
accepts beadswim-layout swimmer --preset paper-single --jsonl
check 'the layout is not on one line' test "$(wc -l <out)" -eq 1
cp out line.json
check 'the scene on one line is another' cmp -s <(jq 'del(.provenance)' line.json) <(jq 'del(.provenance)' paper.json)
same_bytes 'beadswim-layout check - <line.json' 'beadswim-layout check paper.json'

# --- check, from a file and through a pipe
accepts beadswim-layout check paper.json
out_has 'lambda/delta +0.177'
out_has 'cells in the box +7.68e\+08'
same_bytes 'beadswim-layout check paper.json' 'beadswim-layout check <paper.json'
same_bytes 'beadswim-layout check paper.json' 'beadswim-layout swimmer --preset paper-single | beadswim-layout check -'
run beadswim-layout swimmer --preset paper-single --amplitude 2
cp out strong.json
run beadswim-layout check strong.json
has_status 0
err_has 'warning: /types/a: the predicted amplitude .* exceeds the gap'

# --- a full disk is not the user's mistake
run bash -c 'beadswim-layout swimmer --preset paper-single >/dev/full'
has_status 3
err_has 'standard output: the text cannot be written: No space left'
for flag in --help --version; do
  run bash -c "beadswim-layout $flag >/dev/full"
  has_status 3
done

# --- a sphere in open space has no gap
beadswim-layout shape sphere --unbounded >sphere.json
run beadswim-layout check --json sphere.json
has_status 0
check 'the gap of a lone sphere' holds '.smallest_gap == null' out

finish
