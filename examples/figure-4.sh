#!/bin/bash
# Draws figure 4 of the paper: the setup of a swarm, with the distances of neighbours and the swimmers A and B.
#   examples/figure-4.sh [FOLDER [FLAGS of beadswim-layout swarm...]]   writes to FOLDER (default: out/figure-4):
#     swarm.json     the layout: one block of 1 x 3 x 3 swimmers in a periodic box
#     figure-4.svg   the block and the neighbouring blocks
# With --preset paper-uniform it draws the uniform swarm.
set -euo pipefail

preset=paper-defect
copies=2,2,2      # copies of the block; a single block would not show the distance D between blocks
A=0               # id of swimmer A, at y = z = 23; ids increase along y first
B=3               # id of swimmer B, at y = 23, z = 60

out=${1:-out/figure-4}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH
[[ " $* " == *" --preset "* ]] || set -- --preset "$preset" "$@"

beadswim-layout swarm "$@" |
  tee "$out/swarm.json" |
  beadswim-plot swarm - --repeat "$copies" --distances --mark "A=$A,B=$B" -o "$out/figure-4.svg"
echo "$out/figure-4.svg" >&2
