#!/bin/bash
# Tests that predictions and runs give the same numbers in all units.
source "$(dirname "$0")/harness.sh"

# Converts a layout of three-bead swimmers to units of length, time and mass that are smaller by these factors.
in_units() { # LENGTH TIME MASS
  jq --argjson l "$1" --argjson t "$2" --argjson m "$3" '($m * $l / $t / $t) as $force
    | .fluid.density *= $m / $l / $l / $l | .fluid.kinematic_viscosity *= $l * $l / $t
    | if .domain then .domain.lengths[] *= $l else . end | .swimmers[].position[] *= $l
    | .types[] |= (.beads[] |= (.radius *= $l | .density *= $m / $l / $l / $l)
      | .springs[] |= (.stiffness *= $m / $t / $t | .rest_length *= $l | .damping *= $m / $t)
      | .angular_stiffness *= $force * $l | .driving.amplitude[] *= $force | .driving.period *= $t)'
}
# 1e-25 with a density in SI, extreme units with the mass of a unit of density, and a power of 4
systems=('1e-25 1 1e-72' '1e25 1 1e75' '1e-25 1e-25 1e-75' '1e25 1e-25 1e75' '1e-25 1e25 1e-75' '1e-6 1e-3 1e-15')

beadswim-layout swimmer --preset paper-single --radius 3,4,5 --arm 18,24 --amplitude 0.3,0.2 --damping 1,2 --unbounded >open.json
beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic >boxed.json
for scene in open boxed; do
  beadswim-theory $scene.json 2>/dev/null >reference.json
  for system in "${systems[@]}"; do
    read -r l t m <<<"$system"
    in_units $l $t $m <$scene.json >units.json
    run beadswim-theory units.json
    has_status 0
    check "predictions in units of $system" holds "(\"$l $t $m\" | split(\" \") | map(tonumber)) as [\$l, \$t, \$m]
      | map(.predictions) | length == 2 and (.[0] | length > 5) and ([.[0], .[1]] | transpose | all(
        .[0].method == .[1].method and (.[1].velocity / .[0].velocity / \$l * \$t - 1 | fabs) < 1e-9
        and (.[1].arm_amplitudes[1] / .[0].arm_amplitudes[1] / \$l - 1 | fabs) < 1e-9
        and (.[0].power == null or (.[1].power / .[0].power / \$m / \$l / \$l * \$t * \$t * \$t - 1 | fabs) < 1e-9)
        and (.[0].uncertainty == null or (.[1].uncertainty / .[0].uncertainty - 1 | fabs) < 1e-3)))" <(jq -s . reference.json out)
  done
done

# --- beadswim-layout units against the conversion above: to lattice units of 2 lengths and 3 times, with a density of 5
same_scene() { # A B: equal to roundoff
  check "$1 and $2 are not the same scene" holds '[.[] | del(.provenance, .units, .study, .made_by) | [paths(numbers) as $p | getpath($p)]]
    | .[0] as $a | .[1] as $b | ($a | length) == ($b | length) and all(range($a | length); ($a[.] - $b[.] | fabs) <= 1e-13 * ($a[.] | fabs))' <(jq -s . "$1" "$2")
}
jq 'del(.made_by) | .units = {length: "um", time: "s", mass: "mg"}' boxed.json >named.json
accepts beadswim-layout units named.json --to lattice --cell 2um --step 3000ms --density 5
cp out there.json
in_units 0.5 0.3333333333333333 0.625 <boxed.json >units.json
same_scene there.json units.json
accepts beadswim-layout units there.json --to um,s,mg --cell 2 --viscosity 0.3333333333333333 --density 1
same_scene out named.json
beadswim-layout shape triangle --unbounded --units um,s,mg --radius 2 --period 3 --viscosity 1 >triangle.json
beadswim-layout combine triangle.json triangle.json --at 0,0,40 --rotate '1 1,2,3' | jq '.swimmers[0].start = {positions: [[-5, -3, 0], [5, -3, 0], [0, 6, 0]]}' >shapes.json
same_bytes "beadswim-layout units shapes.json --to mm,ms,pg | beadswim-layout units - --to um,s,mg >back.json; jq .units back.json" 'jq .units shapes.json'
same_scene back.json shapes.json
beadswim-layout units shapes.json --to mm,ms,pg >small.json
beadswim-layout units shapes.json --to lattice --cell 0.7um --step 0.1s >cells.json
for scene in shapes small cells; do
  beadswim-run $scene.json -o $scene.h5md --model rpy --cycles 1 --progress none --no-provenance 2>err >$scene.run
  jq -c --slurpfile layout $scene.json '.swimmers[1].cycles[0].velocity | map(. * ($layout[0].types.triangle | .driving.period / .beads[0].radius))' $scene.run
done >relative
check 'runs in other units have another dimensionless velocity' holds -s '(map(length) == [3, 3, 3]) and (.[0] | map(fabs) | max) > 1e-6 and
  (.[0] as $a | all(.[]; [., $a] | transpose | all((.[0] - .[1] | fabs) < 1e-7 * ($a | map(fabs) | max))))' relative
beadswim-layout vary named.json --over period=1000,2000 --over /domain/lengths/0=120 --over phase=1 | beadswim-layout units - --to mm,ms,g >study.jsonl
check 'the values of a study are converted' holds -s 'map(.study | [.period, 1e6 * ."/domain/lengths/0", .phase | round]) == [[1000000, 120000, 1], [2000000, 120000, 1]]' study.jsonl
refuses '--cell: conversion from lattice units needs this flag' beadswim-layout units boxed.json --to um,s,pg --viscosity 1 --density 1
refuses '--cell: "4parsec"|--cell: unknown value "parsec"' beadswim-layout units boxed.json --to um,s,pg --cell 4parsec --viscosity 1 --density 1
refuses '--step: conversion from lattice units does not use this flag' beadswim-layout units boxed.json --to um,s,pg --cell 1 --step 1 --viscosity 1 --density 1
refuses '--to: the layout is in lattice units already' beadswim-layout units boxed.json --to lattice --cell 1 --step 1

beadswim-layout swimmer --preset paper-single --radius 2 --arm 8 --stiffness 0.05 --period 400 --box 32,16,16 --boundary periodic >cell.json
models=(oseen rpy rpy+near multipole unsteady lbm)
for n in {0..5}; do # two systems for each model, and two models for each system
  model=${models[n]}
  settings=(--model "$model" --cycles 1 --progress none --no-provenance)
  # Roundoff may change the number of iterations for moments, and so results within their tolerance.
  if [[ $model =~ ^(multipole|unsteady)$ ]]; then settings+=(--sum-tolerance 1e-9); fi
  run beadswim-run cell.json -o cell.h5md "${settings[@]}"
  has_status 0
  mv out reference.json
  for system in "${systems[n]}" "${systems[(n + 3) % 6]}"; do
    read -r l t m <<<"$system"
    in_units $l $t $m <cell.json >units.json
    run beadswim-run units.json -o units.h5md "${settings[@]}"
    has_status 0
    check "$model in units of $system" holds "(\"$l $t $m\" | split(\" \") | map(tonumber)) as [\$l, \$t, \$m]
      | map(.swimmers[0].cycles[0]) | (.[1].velocity[0] / .[0].velocity[0] / \$l * \$t - 1 | fabs) < 1e-7
        and (.[1].arm_amplitudes[0] / .[0].arm_amplitudes[0] / \$l - 1 | fabs) < 1e-9
        and (.[1].efficiency / .[0].efficiency - 1 | fabs) < 1e-6" <(jq -s . reference.json out)
  done
done

# --- units that differ by powers of 4: the same bits
in_units 4 16 64 <cell.json >units.json
beadswim-run cell.json -o cell.h5md --model multipole --cycles 1 --progress none --no-provenance 2>/dev/null >reference.json
run beadswim-run units.json -o units.h5md --model multipole --cycles 1 --progress none --no-provenance
check 'powers of 4' holds 'map(.swimmers[0].cycles[0]) | .[1].velocity[0] * 4 == .[0].velocity[0]' <(jq -s . reference.json out)

finish
