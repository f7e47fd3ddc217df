#!/bin/bash
# Speed and diffusion of the paper's swimmer with thermal noise, over 1000 persistence times (docs/noise.md): prints a line per
# thermal energy. Takes half an hour on two cores.
#   docs/results/noise.sh >docs/results/noise.jsonl
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.4 --frame body |
  beadswim-layout vary --over thermal-energy=0.02,0.05,0.1 >"$folder/layouts.jsonl"
while read -r layout; do
  energy=$(jq .fluid.thermal_energy <<<"$layout")
  beadswim-run - --model rpy --cycles "$(jq -n "2200 / $energy")" --frames-per-cycle 8 --progress none \
    -o "$folder/$energy.h5md" <<<"$layout" >"$folder/$energy.json" &
done <"$folder/layouts.jsonl"
wait
for record in "$folder"/*.json; do
  jq -c '.thermal as $thermal | .swimmers[0].cycles[1:] | map(.speed_along_axis) | length as $n | (add / $n) as $mean
    | {thermal_energy: $thermal.thermal_energy, cycles: $n,
       velocity: {mean: $mean, standard_error: (map((. - $mean) * (. - $mean)) | add / ($n * ($n - 1)) | sqrt)}}
      + ($thermal | {lag, effective_diffusion, rotational_diffusion})' "$record"
done
