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

beadswim-layout swimmer --preset paper-single --radius 2 --arm 8 --stiffness 0.05 --period 400 --box 32,16,16 --boundary periodic >cell.json
models=(oseen rpy rpy+near multipole unsteady lbm)
for n in {0..5}; do # two systems for each model, and two models for each system
  model=${models[n]}
  settings=(--model "$model" --cycles 1 --progress none --no-provenance)
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
