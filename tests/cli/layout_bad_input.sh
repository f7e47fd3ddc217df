#!/bin/bash
# Tests invalid layouts: each must give one clear error that names the place in the file, exit status 2, and nothing on standard
# output.
source "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --box 72,30,30 --boundary periodic --position 36,15,15 >sound.json || exit 1
accepts beadswim-layout check sound.json

# Applies SED-SCRIPT to the valid layout and checks that the result is refused with a message that matches REGEX. sed -z is used,
# so that a pattern can span lines; only its first match is replaced.
bad() { # NAME SED-SCRIPT REGEX
  sed -z "$2" sound.json >bad.json
  check "the edit \"$1\" changes nothing" test "$(cmp -s sound.json bad.json; echo $?)" = 1
  refuses "bad.json:$3" beadswim-layout check bad.json
  check "$1: more than one error" test "$(wc -l <err)" = 1
}

first_bead='{ "radius": 4.0, "density": 1.0 }'
spring='{ "stiffness": 0.0347, "rest_length": 20.0, "damping": 0.0 }'
swimmer='{ "id": 0, "type": "a", "position": \[36.0, 15.0, 15.0\], "axis": \[1.0, 0.0, 0.0\] }'

bad 'typo in schema' 's/"schema"/"shcema"/' '/shcema: unknown key; did you mean "schema"'
bad 'part of a key' 's/"kinematic_viscosity"/"viscosty"/' '/fluid/viscosty: unknown key; did you mean "kinematic_viscosity"'
bad 'a key like none' 's/"frame": "lab"/"foo": 1/' '/types/a/driving/foo: unknown key\. Keys allowed here: '
bad 'typo in a key' 's/"radius"/"raduis"/' '/types/a/beads/0/raduis: unknown key; did you mean "radius"'
bad 'typo in an optional key' 's/"resolution"/"resolutoin"/' '/resolutoin: unknown key; did you mean "resolution"'
bad 'missing key' 's/, "axis": [^}]*\]//' '/swimmers/0: the object lacks the key "axis"'
bad 'NaN' 's/"density": 1.0/"density": NaN/' ' line 4, column .*finite number'
bad 'number as text' 's/"density": 1.0/"density": "1.0"/' '/fluid/density: "1.0": the value must be of type number'
bad 'negative radius' 's/"radius": 4.0/"radius": -4/' '/types/a/beads/0/radius: -4: the value must be greater than 0'
bad 'bead outside the box' 's/\[36.0, 15.0/[73.0, 15.0/' '/swimmers/0/position: the position \(73, 15, 15\) of bead 2 lies outside the box'
bad 'bead through a wall' 's/\["periodic", "periodic"/["periodic", "no-slip"/; s/\[36.0, 15.0/[36.0, 3.0/' \
  '/swimmers/0/position: bead 1.*along y: its centre must be between 4 and 26'
bad 'overlapping beads' "s/$swimmer/{ \"id\": 7, \"type\": \"a\", \"position\": [14, 15, 15], \"axis\": [0, 1, 0] }, $swimmer/" \
  '/swimmers/1/position: bead 1 of swimmer 0 at .* overlaps bead 2 of swimmer 7'
bad 'overlap through the seam' 's/\[72.0/[47.0/' '/swimmers/0/position: bead 3 .* overlaps bead 1 .* through the periodic boundary'
bad 'arm shorter than its beads' 's/"rest_length": 20.0/"rest_length": 7/' '/types/a/springs/0/rest_length: with the rest length 7, beads 1 and 2 overlap'
bad 'spring to a bead that is not there' "s/$spring/$spring, $spring/" \
  '/types/a/springs: the array has 3 elements, but exactly 2 are needed .*the second joins beads 2 and 3'
bad 'spring with one bead less' "s/$first_bead,[[:space:]]*//" '/types/a/beads: the array has 2 elements, but exactly 3'
bad 'wrong unit' 's/"lattice"/{ "length": "um", "time": "nss", "mass": "pg" }/' '/units/time: "nss": the value must be one of .*did you mean "ns"'
bad 'unit of another quantity' 's/"lattice"/{ "length": "s", "time": "s", "mass": "pg" }/' '/units/length: "s": the value must be one of \["m"'
bad 'unit that contradicts its name' \
  's/"lattice"/{ "length": { "name": "um", "si_factor": 1 }, "time": "s", "mass": "pg" }/' \
  '/units/length/si_factor: the factor 1 is wrong: one um is 1e-06 in SI'
bad 'misspelt lattice' 's/"lattice"/"latice"/' '/units: "latice": .*did you mean "lattice"'
bad 'SI as a name' 's/"lattice"/"SI"/' \
  '/units: "SI": the value must be "lattice", or an object such as \{"length":"um","time":"ms","mass":"pg"\}'
bad 'a unit that has no name' 's/"lattice"/{ "length": "lambda", "time": "s", "mass": "pg" }/' \
  '/units/length: "lambda": the value must be one of .*, or an object such as \{"name":"my length","si_factor":1e-07\}'
bad 'an imposed flow' 's/"fluid": {/"shear": { "rate": 1 }, &/' '/shear: imposed flow has other keys: "flow" of .*; remove the key'
bad 'a sheared fluid' 's/"kinematic_viscosity"/"velocity_gradient": [0, 1, 0], &/' '/fluid/velocity_gradient: imposed flow has other keys'
bad 'a prescribed stroke' 's/"frame": "lab"/&, "stroke": {}/' '/types/a/driving/stroke: version 1 of the layout has no prescribed stroke: .*amplitude, phase, period'
bad 'a prescribed arm' 's/"frame": "lab"/&, "rest_length": [20, 21]/' '/types/a/driving/rest_length: version 1 of the layout has no prescribed stroke: .*shape prescribed-three-bead'
bad 'a swimmer at a temperature' 's/"id": 0/&, "temperature": 300/' '/swimmers/0/temperature: thermal noise has the key "thermal_energy" of "fluid"'
bad 'a weight' 's/"id": 0/&, "gravity": 1/' '/swimmers/0/gravity: this version has no gravity; .*net_force'
bad 'unknown type' 's/"type": "a"/"type": "b"/' '/swimmers/0/type: the swimmer type "b" is not defined under /types\.'
bad 'id given twice' "s/$swimmer/$swimmer, { \"id\": 0, \"type\": \"a\", \"position\": [36, 25, 15], \"axis\": [1, 0, 0] }/" \
  '/swimmers/1/id: the id 0 is already used by /swimmers/0'
bad 'axis not of unit length' 's/"axis": \[1.0/"axis": [2.0/' '/swimmers/0/axis: the axis \(2, 0, 0\) has the length 2'
bad 'duplicate key' 's/"id": 0/"id": 0, "id": 0/' '/swimmers/0/id: this key is given twice'
bad 'newer version' 's#layout/1#layout/3#; s/"fluid"/"medium"/' '/schema: the schema "beadswim/layout/3" is newer than this program'
bad 'another document' 's#layout/1#run/1#' '/schema: the document is a run record \(beadswim-run\), without positions, .*; give a layout \(beadswim-layout\)'
bad 'no schema' 's/"schema": [^\n]*//' ' the document lacks the key "schema"'
bad 'two documents' 's/$/{}/' ' line [0-9]+, column 1: a second JSON document begins here, but only one document is read; write one document per line \(JSON Lines\), or select one document, for example with jq'

# Numbers beyond the range of floating-point numbers.
bad 'a huge box' 's/"lengths": \[[^]]*\]/"lengths": [1e150, 1e150, 1e150]/' ' the box length 1e\+150 is out of range: in units of the smallest radius 4,'
bad 'a denormal period' 's/"period": [0-9.]*/"period": 1e-320/' ' with the smallest radius .* exceed the range of floating-point numbers'
bad 'a tiny amplitude' 's/"amplitude": \[[^]]*\]/"amplitude": [1e-200, 0]/' ' the driving amplitude (-?)1e-200 is out of range'
bad 'a huge stiffness' 's/"stiffness": [0-9.]*/"stiffness": 1e200/' ' the (angular )?stiffness 1e\+200 is out of range'

: >bad.json
refuses 'bad.json: .*empty' beadswim-layout check bad.json
refuses ': this path is a folder' beadswim-layout check .
sed 's/"radius"/"raduis"/' sound.json >bad.json
run bash -c 'beadswim-layout check - <bad.json'
has_status 2
out_empty
err_has 'standard input:/types/a/beads/0/raduis'

finish
