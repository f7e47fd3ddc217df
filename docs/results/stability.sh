#!/bin/bash
# Makes the records of docs/swarm-stability.md.
#   docs/results/stability.sh FOLDER [GROUP...]     (an hour on one core; the programs on PATH)
# Groups: order: the uniform swarm, with each swimmer displaced by 1e-3, and undisturbed; larger: cells of 27 and of 16 swimmers;
# rows, along, along_fine: two swimmers side by side, also on finer lattices; phases: swimmers with different driving phases or
# periods; map: blocks of 1 x 3 x 3 with other gaps. Layouts and runs stay in FOLDER/runs; runs that exist there are not repeated.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
folder=${1:?name a folder for the records}
shift
mkdir -p "$folder/runs"
cd "$folder"
command -v beadswim-run >/dev/null || PATH=$(realpath "$here/../..")/build/release/bin:$PATH

# Runs a layout and prints a record. A run that stops or fails with a record (exit status 3 or 4) is a result too.
simulate() { # NAME LATTICE FLAGS...   standard input: layout; LATTICE: layout file with the regular sites of the swimmers
  local name=$1 lattice=$2 status=0 run
  shift 2
  run=runs/$group/$(tr -sc "a-zA-Z0-9.\n" - <<<"$name $*")
  mkdir -p "runs/$group"
  cat >"$run.layout.json"
  if [ ! -e "$run.json" ]; then
    echo "$group: $name $*" >&2
    beadswim-run "$run.layout.json" -o runs/run.h5md --progress none "$@" >runs/run.json 2>runs/run.err || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || [ "$status" -eq 4 ] || { cat runs/run.err >&2; return 1; }
    mv runs/run.json "$run.json"
    echo "$status" >"$run.status"
  fi
  jq -c --arg name "$name" --argjson exit "$(cat "$run.status")" --slurpfile layouts "$run.layout.json" --slurpfile lattices "$lattice" \
    -f "$here/stability.jq" "$run.json"
}
swarm() { # BLOCKS FLAGS...
  beadswim-layout swarm --preset paper-uniform --block-swimmers 1,1,1 --blocks "$@"
}
moved() { # SEED [SIGMA]
  beadswim-layout defect jitter --sigma "${2:-1e-3}" --seed "$1"
}
# Displaces all swimmers by 1 along each axis: half a cell at 3 cells per radius.
shifted() { jq '.swimmers[].position |= map(. + 1)'; }

order() {
  local k seed
  for k in 0.2 0.0347; do
    swarm 2,2,2 --stiffness $k >runs/lattice.json
    for seed in 1 2; do
      moved $seed <runs/lattice.json | simulate "8 swimmers, k = $k, seed $seed" runs/lattice.json --cycles 60 --cells-per-radius 3
    done
    shifted <runs/lattice.json >runs/shifted.json
    moved 1 <runs/shifted.json |
      simulate "8 swimmers, k = $k, seed 1, half a cell on" runs/shifted.json --cycles 30 --cells-per-radius 3
  done
  simulate "8 swimmers, k = 0.0347, none moved" runs/lattice.json --cycles 20 --cells-per-radius 3 <runs/lattice.json
}
larger() {
  local k
  for k in 0.0347 0.2; do
    swarm 3,3,3 --stiffness $k >runs/lattice.json
    pair "27 swimmers, k = $k" 1e-3 --cycles 40 --cells-per-radius 3
    swarm 1,4,4 --stiffness $k >runs/lattice.json
    pair "16 abreast, k = $k" 1e-3 --cycles 60 --cells-per-radius 3
  done
}
pair() { # NAME SIGMA FLAGS...
  local name=$1 sigma=$2
  shift 2
  moved 1 "$sigma" <runs/lattice.json | simulate "$name" runs/lattice.json "$@"
}
rows() {
  swarm 1,2,1 >runs/lattice.json
  pair '2 abreast, k = 0.2' 1e-3 --cycles 60 --cells-per-radius 3
  shifted <runs/lattice.json >runs/shifted.json
  moved 1 1e-3 <runs/shifted.json |
    simulate '2 abreast, k = 0.2, half a cell on' runs/shifted.json --cycles 60 --cells-per-radius 3
  pair '2 abreast, k = 0.2, by 0.1' 0.1 --cycles 124 --cells-per-radius 3
  pair '2 abreast, k = 0.2' 1e-3 --cycles 40 --cells-per-radius 4.5
  swarm 1,3,1 >runs/lattice.json
  pair '3 abreast, k = 0.2' 1e-3 --cycles 60 --cells-per-radius 3
  swarm 1,2,1 --stiffness 0.0347 >runs/lattice.json
  pair '2 abreast, k = 0.0347' 1e-3 --cycles 60 --cells-per-radius 3
  pair '2 abreast, k = 0.0347' 1e-3 --cycles 30 --cells-per-radius 4.5
}
# Displaces the second of two swimmers side by side by 1e-3 along x. Across x, beads stay on cell faces.
ahead() { jq '.swimmers[1].position[0] += 1e-3'; }
along() {
  local k
  for k in 0.0347 0.1 0.2; do
    swarm 1,2,1 --stiffness $k >runs/lattice.json
    ahead <runs/lattice.json | simulate "2 abreast, one ahead, k = $k" runs/lattice.json --cycles 60 --cells-per-radius 3
  done
}
along_fine() {
  local k
  for k in 0.0347 0.1 0.2; do
    swarm 1,2,1 --stiffness $k >runs/lattice.json
    ahead <runs/lattice.json | simulate "2 abreast, one ahead, k = $k" runs/lattice.json --cycles 30 --cells-per-radius 4.5
  done
  ahead <runs/lattice.json | simulate "2 abreast, one ahead, k = $k" runs/lattice.json --cycles 30 --cells-per-radius 6
}
phases() {
  local k seed flags=(--cells-per-radius 3 --cycles)
  for k in 0.2 0.0347; do
    swarm 1,1,1 --stiffness $k >runs/lattice.json
    simulate "all in step, k = $k" runs/lattice.json "${flags[@]}" 20 <runs/lattice.json
    swarm 2,2,2 --stiffness $k >runs/lattice.json
    beadswim-layout defect vacancy --count 7 <runs/lattice.json |
      simulate "alone in the box, k = $k" runs/lattice.json "${flags[@]}" 5
    beadswim-layout defect phase --random --seed 1 <runs/lattice.json |
      simulate "random phases, k = $k, seed 1" runs/lattice.json "${flags[@]}" 20
    beadswim-layout defect frequency --sigma 0.01 <runs/lattice.json |
      simulate "frequencies, k = $k" runs/lattice.json "${flags[@]}" 20
  done
  swarm 2,2,2 >runs/lattice.json
  beadswim-layout defect phase --random --seed 2 <runs/lattice.json |
    simulate "random phases, k = 0.2, seed 2" runs/lattice.json "${flags[@]}" 20
  beadswim-layout defect phase --sigma 0.3 <runs/lattice.json |
    simulate "phases by 0.3, k = 0.2" runs/lattice.json "${flags[@]}" 20
}
arrangement() { # K C DX DY   runs rows of 3 x 3; the regular sites have equal gaps in the same box
  local even
  even=$(jq -n "(2 * $2 + $4) / 3")
  beadswim-layout swarm --preset paper-uniform --stiffness "$1" --core-gap "$even" --block-gap "$3,$even,$even" >runs/lattice.json
  beadswim-layout swarm --preset paper-uniform --stiffness "$1" --core-gap "$2" --block-gap "$3,$4,$4" | moved 1 1e-2 |
    simulate "k = $1, C = $2, D_x = $3, D_y = $4" runs/lattice.json --cycles 20 --cells-per-radius 3 --precision single
}
map() {
  local k gaps all=('24 16 46' '24 32 46' '32 32 46' '36 32 46' '44 32 46' '36 16 46' '24 32 24' '32 16 32' '36 56 46' '44 32 44'
    '28 32 46' '24 56 46' '24 16 24')
  for k in 0.0347 0.2; do
    # shellcheck disable=SC2086
    for gaps in "${all[@]}"; do arrangement $k $gaps; done
  done
}

[ $# -gt 0 ] || set -- order larger rows along along_fine phases map
for group; do
  "$group" >"$group.part"
  mv "$group.part" "$group.jsonl"
done
