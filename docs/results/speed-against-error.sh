#!/bin/bash
# Makes the records of docs/speed-against-error.md: runs of the paper's swimmer and of the unit cell of its uniform swarm with
# different models, resolutions, bead boundaries, precisions and relaxation times, one run at a time on one rank.
#   docs/results/speed-against-error.sh FOLDER     (half an hour; the programs on PATH)
# Writes FOLDER/swarm.jsonl and swimmer.jsonl, one record per line with the last cycle only, and the references, swarm- and
# swimmer-reference.json. resolution.sh makes more runs of the swimmer, with relaxation times of 0.8 to 1.5.
set -euo pipefail
folder=${1:?name a folder for the records}
results=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# Displaces the swimmer of a layout to the N-th position of a sequence that fills a lattice cell evenly.
placed() { # CELL N
  jq --argjson cell "$1" --argjson n "$2" '.swimmers[0].position |= (. as $p | [0.8191725, 0.6710436, 0.5497005]
    | to_entries | map($p[.key] + $cell * (.value * $n | . - floor)))'
}

swimmer() { # CELLS-PER-RADIUS N
  beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --position 30,20,20 --period 2000 --amplitude 0.2 |
    placed "$(jq -n "4 / $1")" "$2"
}
swarm() { # CELLS-PER-RADIUS N
  beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce 2>/dev/null | placed "$(jq -n "6 / $1")" "$2"
}

measure() { # SCENE CYCLES CELLS-PER-RADIUS POSITIONS [FLAGS...]   prints one record per position
  local scene=$1 cycles=$2 cells=$3 places=$4 work
  shift 4
  work=$(mktemp -d)
  for n in $(seq "$places"); do
    $scene "$cells" "$n" >"$work/layout.json"
    beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles "$cycles" --progress none "$@" </dev/null |
      jq -c 'del(.provenance) | .swimmers[].cycles |= .[-1:]'
  done
  rm -r "$work"
}
on_lattice() { # SCENE CYCLES CELLS-PER-RADIUS POSITIONS [FLAGS...]
  measure "$@" --cells-per-radius "$3"
}

models() { # SCENE CYCLES
  for model in oseen rpy rpy+near; do measure "$1" "$2" 1 1 --model $model; done
  for order in 1 2; do measure "$1" "$2" 1 1 --model multipole --multipole-order $order; done
  for order in 0 1 2; do measure "$1" "$2" 1 1 --model unsteady --multipole-order $order; done
}

times() { # SCENE CYCLES COARSE FINE   runs two resolutions at all relaxation times
  for time in 0.6 0.8 1 2 3; do
    on_lattice "$1" "$2" "$3" 4 --relaxation-time $time
    on_lattice "$1" "$2" "$4" 2 --relaxation-time $time
  done
}

{
  models swarm 6
  for scheme in staircase cli psm mr; do
    for cells in 2.25 3 4.5; do on_lattice swarm 6 $cells 4 --bead-boundary $scheme; done
    on_lattice swarm 6 6 2 --bead-boundary $scheme
  done
  for cells in 2.25 3 4.5; do on_lattice swarm 6 $cells 4 --precision single; done
  on_lattice swarm 6 6 2 --precision single
  times swarm 6 3 4.5
  for scheme in staircase cli psm; do
    on_lattice swarm 6 3 4 --bead-boundary $scheme --relaxation-time 1
    on_lattice swarm 6 4.5 2 --bead-boundary $scheme --relaxation-time 1
  done
} >swarm.jsonl

for scheme in mr psm; do
  for cells in 6 9; do on_lattice swarm 6 $cells 1 --bead-boundary $scheme --relaxation-time 1; done
done >swarm-reference.jsonl

{
  models swimmer 4
  for time in 0.6 2 3; do
    on_lattice swimmer 4 2 8 --relaxation-time $time
    on_lattice swimmer 4 3 6 --relaxation-time $time
  done
} >swimmer.jsonl

jq -sc -L "$results" -f "$results/extrapolated.jq" swarm-reference.jsonl >swarm-reference.json
{
  jq -c 'select(.resolution.bead_boundary == "mr" and .resolution.cells_per_radius == 6)' "$results/resolution.jsonl" | head -1
  cat "$results/resolution-reference.json"
  jq -c '.resolution as $r | select($r.bead_boundary == "psm" and $r.density_on_lattice != 1 and $r.precision == "double"
    and $r.cells_per_radius == 4 and $r.relaxation_time == 1.5)' "$results/resolution.jsonl" | head -1
  jq -c 'select(.resolution.bead_boundary == "psm" and .resolution.cells_per_radius == 8)' "$results/resolution.jsonl"
} | jq -sc -L "$results" -f "$results/extrapolated.jq" >swimmer-reference.json
