#!/bin/bash
# Makes the records of docs/swarm-figures.md.
#   docs/results/swarms.sh FOLDER [GROUP...]     (two hours on one core; the programs on PATH)
# Groups: uniform, defect: figures 5 and 6 at several resolutions; sensitivity: the defect swarm with other springs, dampers,
# beads and initial positions; fine: the defect swarm at the paper's resolution; inertia: both swarms by models without a lattice
# (40 minutes). Existing files are kept.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
folder=${1:?name a folder for the records}
shift
mkdir -p "$folder"
cd "$folder"
command -v beadswim-run >/dev/null || PATH=$(realpath "$here/../..")/build/release/bin:$PATH

# Runs a layout and prints a record as one line. A run that stops or fails with a record (exit status 3 or 4) is a result too.
simulate() { # NAME FLAGS...   the layout on standard input
  local name=$1 status=0
  shift
  cat >layout.json
  echo "$name $*" >&2
  beadswim-run layout.json -o run.h5md --progress none "$@" >run.json 2>run.err || status=$?
  [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || [ "$status" -eq 4 ] || { cat run.err >&2; return 1; }
  jq -c --arg name "$name" --slurpfile layouts layout.json '$layouts[0] as $layout | '"$(cat "$here/swarms.jq")" run.json
}
uniform_swarm() { beadswim-layout swarm --preset paper-uniform "$@"; }
uniform_cell() { uniform_swarm "$@" | beadswim-layout reduce 2>/dev/null; }
defect_swarm() { beadswim-layout swarm --preset paper-defect "$@"; }

uniform() {
  local cells
  uniform_cell | simulate 'one cell' --cycles 124 --cells-per-radius 3
  uniform_cell | simulate 'one cell' --cycles 124 --cells-per-radius 6 --precision single
  uniform_swarm | simulate 'nine swimmers' --cycles 124 --cells-per-radius 2
  uniform_swarm | simulate 'nine swimmers' --cycles 124 --cells-per-radius 3 --precision single
  for cells in 2 3; do
    uniform_swarm | beadswim-layout defect jitter --sigma 0.5 |
      simulate 'nine, each moved by 0.5' --cycles 124 --cells-per-radius $cells --precision single
  done
  uniform_cell --stiffness 0.0347 | simulate 'one cell, k = 0.0347' --cycles 124 --cells-per-radius 3 --precision single
  uniform_swarm --stiffness 0.0347 | simulate 'nine swimmers, k = 0.0347' --cycles 124 --cells-per-radius 3 --precision single
  uniform_swarm --stiffness 0.0347 | beadswim-layout defect jitter --sigma 0.5 |
    simulate 'nine, each moved by 0.5, k = 0.0347' --cycles 124 --cells-per-radius 3 --precision single
}
defect() {
  defect_swarm | simulate reference --cycles 124 --cells-per-radius 2 --precision single
  # The flags of examples/figure-6.sh.
  local fine=(--cycles 124 --cells-per-radius 3 --precision single --frames-per-cycle 12)
  defect_swarm | simulate reference "${fine[@]}"
  defect_swarm --stiffness 0.0347 | simulate 'k = 0.0347' "${fine[@]}"
}
sensitivity() {
  local coarse=(--cycles 124 --cells-per-radius 2 --precision single) value
  for value in 0.0347 0.1 0.4; do defect_swarm --stiffness $value | simulate "k = $value" "${coarse[@]}"; done
  for value in 10 40; do defect_swarm --damping $value | simulate "c = $value" "${coarse[@]}"; done
  for value in 0.5 2 4; do defect_swarm --bead-density $value | simulate "density $value" "${coarse[@]}"; done
  for value in 2.048 204.8 20480; do defect_swarm --angular-stiffness $value | simulate "K_A = $value" "${coarse[@]}"; done
  defect_swarm | simulate 'staircase beads' "${coarse[@]}" --bead-boundary staircase --radius-correction off --delay-correction off
  defect_swarm | beadswim-layout defect jitter --sigma 0.5 | simulate 'each moved by 0.5' "${coarse[@]}"
}
inertia() {
  local model stiffness
  for model in "rpy" "multipole --multipole-order 2" "unsteady --multipole-order 0" "unsteady --multipole-order 1" \
    "unsteady --multipole-order 2" "unsteady --multipole-order 2 --reynolds-stress off"; do
    # shellcheck disable=SC2086  # flags
    uniform_cell | simulate "one cell, $model" --cycles 124 --model $model
    for stiffness in 0.2 0.0347; do
      # shellcheck disable=SC2086  # flags
      defect_swarm --stiffness $stiffness | simulate "k = $stiffness, $model" --cycles 124 --frames-per-cycle 12 --model $model
    done
  done
}
fine() { defect_swarm | simulate reference --cycles 124 --cells-per-radius 6 --precision single --frames-per-cycle 12; }

[ $# -gt 0 ] || set -- uniform defect sensitivity fine
for group; do
  [ ! -e "$group.jsonl" ] || continue
  "$group" >"$group.part"
  mv "$group.part" "$group.jsonl"
done
rm -f layout.json run.json run.err run.h5md{,.xdmf2}
