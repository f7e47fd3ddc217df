#!/bin/bash
# Makes the records of docs/speed-against-error.md: runs of four scenes with different models, resolutions, bead boundaries,
# precisions, relaxation times and levels of cells, one run at a time on one rank. The reference of nine swimmers runs on two ranks.
#   docs/results/speed-against-error.sh FOLDER [SCENE...]     (the programs on PATH)
# SCENE: swimmer (15 minutes), cell (10), nine (20), many (180); default: all. Writes for each scene FOLDER/SCENE.jsonl, one record
# per line with the last cycle only, and the reference, FOLDER/SCENE-reference.json. "cell" is the unit cell of the paper's
# uniform swarm; "many" are 540 swimmers. The reference of the swimmer is made from runs of resolution.sh.
set -euo pipefail
folder=${1:?name a folder for the records}
shift
scenes=("${@:-all}")
results=$(realpath "$(dirname "$0")")
mkdir -p "$folder"
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

is_wanted() { [[ ${scenes[0]} == all || " ${scenes[*]} " == *" $1 "* ]]; }

# Displaces all swimmers of a layout by the N-th vector of a sequence that fills a lattice cell evenly; N = 0: by nothing.
placed() { # CELL N
  jq --argjson cell "$1" --argjson n "$2" '([0.8191725, 0.6710436, 0.5497005] | map($cell * (. * $n | . - floor))) as $d
    | .swimmers[].position |= ([., $d] | transpose | map(add))'
}

swimmer() { # CELLS-PER-RADIUS N
  beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --position 30,20,20 --period 2000 --amplitude 0.2 |
    placed "$(jq -n "4 / $1")" "$2"
}
cell() { # CELLS-PER-RADIUS N
  beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce 2>/dev/null | placed "$(jq -n "6 / $1")" "$2"
}
nine() { # the paper's defect swarm; the arguments are not used: beads of different swimmers lie differently in their cells
  beadswim-layout swarm --preset paper-defect
}
many() { # CELLS-PER-RADIUS N   the paper's uniform swarm, disturbed; N: from 1
  beadswim-layout swarm --preset paper-uniform --block-swimmers 1,3,3 --blocks 5,4,3 |
    beadswim-layout defect phase --sigma 0.3 --seed 1 | beadswim-layout defect jitter --sigma 1 --seed 2 |
    placed "$(jq -n "6 / $1")" $(($2 - 1))
}

# Prints a record with its last cycle only. Records of more than 64 swimmers get every 27th swimmer of the trajectory.
compact() { # TRAJECTORY   standard input: record
  "$results/last-cycle.py" "$1" 27 | jq -c 'del(.provenance, .warnings) | .swimmers[].cycles |= .[-1:] | if .swarm then .swarm |= .[-1:] else . end'
}

measure() { # SCENE CYCLES CELLS-PER-RADIUS POSITIONS [FLAGS...]   prints one record per position
  local scene=$1 cycles=$2 cells=$3 places=$4 work
  shift 4
  work=$(mktemp -d)
  for n in $(seq "$places"); do
    $scene "$cells" "$n" >"$work/layout.json"
    mpirun -n "${ranks:-1}" beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles "$cycles" --progress none "$@" \
      </dev/null | compact "$work/run.h5md"
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

schemes() { # SCENE CYCLES POSITIONS CELLS-PER-RADIUS...   all bead boundaries with the paper's relaxation time
  local scene=$1 cycles=$2 places=$3
  shift 3
  for scheme in staircase cli psm mr; do
    for cells; do on_lattice "$scene" "$cycles" "$cells" "$places" --bead-boundary $scheme --relaxation-time 1.5; done
  done
}
times() { # SCENE CYCLES POSITIONS CELLS-PER-RADIUS RELAXATION-TIME... [FLAGS...]
  local scene=$1 cycles=$2 places=$3 cells=$4
  shift 4
  while [[ ${1:-} == [0-9]* ]]; do
    on_lattice "$scene" "$cycles" "$cells" "$places" --relaxation-time "$1" "${@:2}"
    shift
  done
}

if is_wanted cell; then
  {
    models cell 6
    schemes cell 6 4 2.25 3 4.5
    schemes cell 6 2 6
    for time in 0.6 0.8 1 2; do times cell 6 4 3 $time; done
    for time in 0.6 0.8 1 2; do times cell 6 2 4.5 $time; done
    for cells in 2.25 3 4.5; do times cell 6 2 $cells 1 --precision single; done
  } >cell.jsonl
  for scheme in mr psm; do
    for cells in 6 9; do on_lattice cell 6 $cells 1 --bead-boundary $scheme --relaxation-time 1; done
  done >cell-reference.jsonl
  jq -sc -f "$results/extrapolated-record.jq" cell-reference.jsonl >cell-reference.json
fi

if is_wanted swimmer; then
  {
    models swimmer 4
    schemes swimmer 4 4 2 3
    schemes swimmer 4 2 4
    times swimmer 4 1 6 1.5
    for time in 0.6 0.8 1 2; do times swimmer 4 4 2 $time; done
    for time in 0.6 0.8 1 2; do times swimmer 4 4 3 $time; done
    times swimmer 4 2 4 1
    for cells in 2 3 4; do times swimmer 4 2 $cells 1 --precision single; done
  } >swimmer.jsonl
  {
    cat "$results/resolution-reference.json"
    for run in '"mr", 6' '"psm", 4' '"psm", 8'; do
      jq -nc "first(inputs | select([.resolution | .bead_boundary, .cells_per_radius, .precision, .relaxation_time, .density_on_lattice != 1]
        == [$run, \"double\", 1.5, true]))" "$results/resolution.jsonl"
    done
  } | jq -sc -f "$results/extrapolated-record.jq" >swimmer-reference.json
fi

if is_wanted nine; then
  {
    models nine 3
    schemes nine 3 1 2 3 4.5
    for time in 0.6 0.8 1 2; do times nine 3 1 3 $time; done
    times nine 3 1 2 1
    times nine 3 1 4.5 1
    for cells in 2 3 4.5; do times nine 3 1 $cells 1 --precision single; done
    for cells in 3 4.5; do times nine 3 1 $cells 1 --refine 1; done
  } >nine.jsonl
  for cells in 4.5 6; do ranks=2 times nine 3 1 $cells 0.8 --precision single; done |
    jq -sc -f "$results/extrapolated-record.jq" >nine-reference.json
fi

if is_wanted many; then
  {
    models many 3
    for time in 1 2; do times many 3 1 2 $time --precision single; done
    for scheme in staircase cli psm; do times many 3 1 3 1.5 --precision single --bead-boundary $scheme; done
    for time in 1 1.5; do times many 3 1 3 $time --precision single; done
    for cells in 2 3; do times many 3 1 $cells 1 --precision double; done
    times many 3 1 3 1 --precision single --refine 1
    times many 3 3 3 0.8 --precision single
    times many 3 2 4 0.8 --precision single
    times many 3 1 5 0.8 --precision single
  } >many.jsonl
  jq -c 'select(.resolution.relaxation_time | . and . > 0.7 and . < 0.9)' many.jsonl |
    jq -sc -f "$results/extrapolated-record.jq" >many-reference.json
fi
