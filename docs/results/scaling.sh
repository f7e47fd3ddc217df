#!/bin/bash
# Prints the records of docs/scaling.md, one line per run.
#   docs/results/scaling.sh [weak|strong|largest]... >docs/results/scaling.jsonl     (weak and strong a minute on 2 cores; 20 GiB for
#   the largest; the programs on PATH)
# Weak scaling: the paper's block of nine swimmers per rank; strong scaling: eight blocks in total. Each run is made three times,
# in turn with the other sizes. Runs with more ranks than cores show numbers of messages, not speed.
set -euo pipefail
here=$(realpath "$(dirname "$0")")
command -v beadswim-run >/dev/null || PATH=$(realpath "$here/../..")/build/release/bin:$PATH
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

measure() { # GROUP RANKS BLOCKS FLAG...
  local group=$1 ranks=$2 blocks=$3 swimmers cells
  shift 3
  beadswim-layout swarm --preset paper-uniform --blocks "$blocks" >"$work/layout.json"
  echo "$group, $ranks ranks, blocks $blocks $*" >&2
  mpirun -n "$ranks" beadswim-run "$work/layout.json" -o "$work/run.h5md" --frames-per-cycle 4 --progress none "$@" >"$work/run.json"
  swimmers=$(jq '.swimmers | length' "$work/layout.json")
  cells=$(jq --slurpfile layouts "$work/layout.json" \
    '.resolution.cell_size as $cell | $layouts[0].domain.lengths | map(. / $cell | round) | .[0] * .[1] * .[2]' "$work/run.json")
  jq -c --arg group "$group" --argjson ranks "$ranks" --argjson swimmers "$swimmers" --argjson cells "$cells" \
    -f "$here/scaling.jq" "$work/run.json"
}
weak() {
  for _ in 1 2 3; do
    measure weak 1 1,1,1 --cells-per-radius 3 --cycles 0.4
    measure weak 2 1,1,2 --cells-per-radius 3 --cycles 0.4
    measure weak 4 1,2,2 --cells-per-radius 3 --cycles 0.2
    measure weak 8 2,2,2 --cells-per-radius 3 --cycles 0.1
  done
}
strong() {
  for _ in 1 2 3; do
    for ranks in 1 2 4 8; do measure strong $ranks 2,2,2 --cells-per-radius 3 --cycles 0.1; done
  done
}
largest() {
  measure "the paper's swarm" 2 8,16,10 --cells-per-radius 3 --precision single --cycles 0.02
  measure largest 2 5,7,8 --cells-per-radius 6 --precision single --cycles 0.005
}

groups=("$@")
[ ${#groups[@]} -gt 0 ] || groups=(weak strong largest)
for group in "${groups[@]}"; do "$group"; done
