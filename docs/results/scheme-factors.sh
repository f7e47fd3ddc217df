#!/bin/bash
# Measures how much the velocity depends on the place of the beads within a cell, for every bead boundary.
#   docs/results/scheme-factors.sh > scheme-factors.jsonl     (some minutes; the programs on PATH)
#   jq -rs -f docs/results/scheme-factors.jq scheme-factors.jsonl     prints the factors of libs/plan/src/model_errors.cpp
# The paper's swimmer as in resolution.sh, at 2 cells per radius and a relaxation time of 1, with beads on planes of the lattice and off
# them, at eight places along its axis. Prints a line per run: bead boundary, planes, velocity in the third cycle.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

for scheme in mr staircase cli psm; do
  for across in 20,20 20.6,20.2; do
    for eighth in 0 1 2 3 4 5 6 7; do
      beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 \
        --position "$(jq -n "30.1 + $eighth / 4"),$across" >layout.json
      beadswim-run layout.json -o run.h5md --bead-boundary $scheme --cells-per-radius 2 --relaxation-time 1 --cycles 3 --progress none 2>/dev/null </dev/null |
        jq -c --arg scheme $scheme --arg across $across '{scheme: $scheme, on_planes: ($across == "20,20"),
          velocity: (.swimmers[0].cycles[-1] | .speed_along_axis - .mean_flow[0])}'
    done
  done
done
