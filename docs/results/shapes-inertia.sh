#!/bin/bash
# Measures how inertia changes the motion of two shapes of the gallery: triangle and prescribed-three-bead, by lattice and mobility in
# the same periodic box, at growing periods.
#   docs/results/shapes-inertia.sh > shapes-inertia.jsonl     (ten minutes on one core; the programs on PATH)
#   docs/results/shapes-theory.py >> shapes-inertia.jsonl
#   jq -rs -f docs/results/shapes-inertia.jq shapes-inertia.jsonl     # the table of docs/method/motion-of-shapes.md
# Prints one line per run: kind, edges of the box, flags, period, and for each of three cycles the rotation about z [radian] and the
# displacement along x relative to the mean flow [length] per period. Mobility models have the same motion at every period.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

row() { # KIND PERIOD BOX-FLAGS RUN-FLAGS
  # shellcheck disable=SC2086  # flags
  beadswim-layout shape "$1" --period "$2" $3 >"$work/layout.json"
  # shellcheck disable=SC2086  # flags
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles 3 --progress none $4 2>/dev/null |
    jq -c --arg kind "$1" --argjson period "$2" --arg box "$3" --arg flags "$4" '{kind: $kind, period: $period, box: $box, flags: $flags,
      turn: [.swimmers[0].cycles[] | .angular_velocity[2] * $period],
      displacement: [.swimmers[0].cycles[] | (.velocity[0] - .mean_flow[0]) * $period]}'
}

for kind in triangle prescribed-three-bead; do
  box="--box 80,80,60"
  [ $kind = triangle ] || box="--box 100,60,60"
  for model in rpy rpy+near; do
    row $kind 4800 "$box" "--model $model"
    row $kind 4800 --unbounded "--model $model"
  done
  for cells in 2 3; do
    for period in 2400 4800 9600 19200; do
      row $kind $period "$box" "--model lbm --cells-per-radius $cells --relaxation-time 1"
    done
  done
done
