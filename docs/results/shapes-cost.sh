#!/bin/bash
# Measures the cost of mobility runs of swimmers with 3 to 64 beads, for docs/performance.md.
#   docs/results/shapes-cost.sh >docs/results/shapes-cost.jsonl
# Each line: beads per swimmer, swimmers, beads, core-seconds per time step and bead [microseconds], seconds per cycle on this
# machine. All swimmers are in periodic boxes with the same volume per bead. Takes ten minutes on an idle machine with 2 cores.
set -euo pipefail

ranks=2
steps=100   # per cycle
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi

# Places copies of the swimmer of a layout on a grid of NX x NY x NZ cells with the edges DX, DY, DZ.
grid() { # LAYOUT NX NY NZ DX DY DZ
  jq -c --argjson n "[$2, $3, $4]" --argjson d "[$5, $6, $7]" '.swimmers[0] as $one | .schema = "beadswim/layout/2"
    | .domain = {lengths: [range(3) as $a | $n[$a] * $d[$a]], boundary: ["periodic", "periodic", "periodic"]}
    | .swimmers = [range($n[0]) as $x | range($n[1]) as $y | range($n[2]) as $z | (($x * $n[1] + $y) * $n[2] + $z) as $id
        | $one + {id: $id, position: [($x + 0.5) * $d[0], ($y + 0.5) * $d[1], ($z + 0.5) * $d[2]]}]' "$1"
}

measure() { # LAYOUT CYCLES
  mpirun -n "$ranks" beadswim-run "$1" -o "$folder/run.h5md" --model rpy --cycles "$2" --steps-per-cycle "$steps" --frames-per-cycle 10 --progress none 2>/dev/null |
    jq -c --slurpfile layout "$1" --argjson cycles "$2" --argjson steps "$steps" 'if .status == "finished" then .cost else error("the run was stopped") end | . as $cost | $layout[0]
      | (.types[] | .beads | length) as $n | (.swimmers | length) as $swimmers
      | {beads_per_swimmer: $n, swimmers: $swimmers, beads: ($n * $swimmers), microseconds_per_step_and_bead: ($cost.core_seconds / ($cycles * $steps * $n * $swimmers) * 1e6),
         seconds_per_cycle: ($cost.wall_seconds / $cycles)}'
}

# The swimmer of N beads: the three-bead swimmer with a prescribed stroke, or a flagellum.
swimmer() { # N SHARE   of the default driving forces of a flagellum
  if [ "$1" -eq 3 ]; then beadswim-layout shape prescribed-three-bead; else
    beadswim-layout shape flagellum --beads "$1" | jq --argjson share "$2" '.types[].driving.forces[].harmonics[].amplitude *= $share'
  fi
}

# About 6100 beads: how the implicit solution of a time step grows with the beads of a swimmer. Weak forces: long flagella would
# need shorter time steps otherwise.
cycles=1
for row in "3 16 12 11 72 41.8 41.8" "4 16 10 10 56 54.8 54.8" "8 10 9 9 96 59.2 59.2" "16 8 7 7 176 61.8 61.8" \
  "32 5 6 6 336 63.2 63.2" "64 4 5 5 656 64 64"; do
  read -r n nx ny nz dx dy dz <<<"$row"
  swimmer "$n" 0.1 >"$folder/one.json"
  grid "$folder/one.json" "$nx" "$ny" "$nz" "$dx" "$dy" "$dz" >"$folder/scene.json"
  measure "$folder/scene.json" "$cycles"
done

# 2000 flagella of 16 beads, and as many beads in three-bead swimmers.
swimmer 16 1 >"$folder/one.json"
grid "$folder/one.json" 10 10 20 176 61.8 61.8 >"$folder/scene.json"
measure "$folder/scene.json" "$cycles"
swimmer 3 1 >"$folder/one.json"
grid "$folder/one.json" 22 22 22 72 41.8 41.8 >"$folder/scene.json"
measure "$folder/scene.json" "$cycles"
