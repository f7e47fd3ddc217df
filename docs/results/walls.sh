#!/bin/bash
# Swimmers over a no-slip wall and in shear flow: the records and figures of docs/walls.md.
#
# usage: docs/results/walls.sh FOLDER [lattice|models|tilted|approach|swarm]     default: all; FOLDER: for layouts and trajectories
#
# Writes the lines of walls.jsonl to standard output. lattice, tilted: 30 and 14 minutes on one core, the other parts: ten minutes.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
here=$(cd "$(dirname "$0")" && pwd)
folder=$1
parts=${2:-lattice models tilted approach swarm}
mkdir -p "$folder"
cd "$folder"

paper=(--preset paper-single --frame body)
quiet=(--progress none --no-provenance)

# One line per run: second cycle of the swimmer.
line() { # MODEL HEIGHT RECORD
  jq -c --arg model "$1" --argjson height "$2" '.swimmers[0].cycles[1] as $cycle
    | {model: $model, height_over_radius: ($height / 4), period: .driving.period, velocity: $cycle.velocity[0], angular_velocity: $cycle.angular_velocity[1]}' "$3"
}

for part in $parts; do
  case $part in
    lattice) # far from the other wall and from periodic images
      for run in {48000,24000}" "{12,16,24}; do
        read -r period height <<<"$run"
        beadswim-layout swimmer "${paper[@]}" --period "$period" --box 216,160,144 --boundary periodic,periodic,no-slip --position "108.4,80.3,$height" >"lattice-$height.json"
        beadswim-run "lattice-$height.json" --model lbm --cells-per-radius 3 --relaxation-time 2 --precision single --cycles 2 \
          -o "lattice-$height.h5md" "${quiet[@]}" >record.json
        line lbm "$height" record.json
      done
      ;;
    models)
      for run in 48000" "{6,8,12,16,24,40} 24000" "{12,16,24}; do
        read -r period height <<<"$run"
        beadswim-layout swimmer "${paper[@]}" --period "$period" --half-space z --position "0,0,$height" >"over-$height.json"
        models=('multipole --multipole-order 2')
        ((period == 24000)) || models=(rpy rpy+near 'multipole --multipole-order 1' "${models[@]}")
        for model in "${models[@]}"; do
          # shellcheck disable=SC2086 # the model is followed by its flag
          beadswim-run "over-$height.json" --model $model --cycles 2 -o over.h5md "${quiet[@]}" >record.json
          line "${model/ --multipole-order / order }" "$height" record.json
        done
      done
      ;;
    tilted) # the second cycle of two points of the figure, by the lattice and by the mobility
      for point in "16 -10" "24 -20"; do
        read -r height angle <<<"$point"
        axis=$(jq -nr --argjson a "$angle" '($a * 3.14159265358979 / 180) | "\(cos),0,\(sin)"')
        beadswim-layout swimmer "${paper[@]}" --period 48000 --half-space z --position "0,0,$height" "--axis=$axis" >tilted.json
        beadswim-run tilted.json --model multipole --multipole-order 2 --cycles 2 -o tilted.h5md "${quiet[@]}" >record-half-space.json
        beadswim-layout swimmer "${paper[@]}" --period 48000 --box 216,160,144 --boundary periodic,periodic,no-slip --position "108.4,80.3,$height" "--axis=$axis" >tilted.json
        beadswim-run tilted.json --model lbm --cells-per-radius 3 --relaxation-time 2 --precision single --cycles 2 -o tilted.h5md "${quiet[@]}" >record-slit.json
        for record in record-half-space.json record-slit.json; do
          jq -c --argjson height "$height" --argjson angle "$angle" '.swimmers[0].cycles[1] as $cycle
            | {tilted: .model, height_over_radius: ($height / 4), angle: $angle, period: .driving.period, velocity: $cycle.velocity, angular_velocity: $cycle.angular_velocity[1]}' "$record"
        done
      done
      ;;
    approach) # 15 radii above the wall, at these angles [degree]
      for angle in -60 -40 -20 -10 0 10; do
        axis=$(jq -nr --argjson a "$angle" '($a * 3.14159265358979 / 180) | "\(cos),0,\(sin)"')
        beadswim-layout swimmer "${paper[@]}" --period 48000 --half-space z --position 0,0,60 "--axis=$axis" >"$angle.json"
        beadswim-run "$angle.json" --model multipole --multipole-order 2 --cycles 900 --frames-per-cycle 4 -o "$angle.h5md" "${quiet[@]}" >/dev/null
      done
      beadswim-plot trajectories ./-60.h5md ./-40.h5md ./-20.h5md ./-10.h5md ./0.h5md ./10.h5md --along z --against angle \
        -o "$here/../images/wall-approach.svg"
      ;;
    swarm) # 18 swimmers at first along the flow; strain 4 in 200 cycles; with and without driving, with and without flow
      beadswim-layout swarm --preset paper-uniform --blocks 2,3,3 --block-swimmers 1,1,1 |
        jq '.domain = null | .types[].driving.frame = "body"' >still.json
      jq '.flow = {velocity_gradient: [[0, 0, 1e-5], [0, 0, 0], [0, 0, 0]]}' still.json >sheared.json
      jq '.types[].driving.amplitude = [0, 0]' sheared.json >passive.json
      for scene in still sheared passive; do
        beadswim-run "$scene.json" --model multipole --cycles 200 --frames-per-cycle 4 -o "$scene.h5md" "${quiet[@]}" |
          jq -c --arg scene "$scene" '[.swimmers[].cycles[-1].axis[2]] as $tilts
            | {scene: $scene, swimmers: ($tilts | length), mean_tilt: ($tilts | add / length), largest_tilt: ($tilts | map(fabs) | max)}'
      done
      beadswim-plot swarm sheared.h5md --block-swimmers 1 -o "$here/../images/swarm-in-shear.svg"
      ;;
  esac
done
