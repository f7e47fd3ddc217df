#!/bin/bash
# Measures two swimmers side by side: velocities along and across, by lattice and mobility.
#   docs/results/neighbours.sh > neighbours.jsonl     (a few minutes; the programs on PATH)
#   for period in 2000 8000; do docs/results/neighbours-theory.py $period; done >> neighbours.jsonl
# Prints one line per run: distance of the axes [bead radius], phase offset of the second swimmer [radian], flags, and for the last
# cycle of each swimmer [velocity along the axis, velocity away from the other swimmer], relative to the velocity of a lone swimmer in
# the same box by the same flags.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

lone() { # PERIOD   the paper's swimmer in the box of the pairs, off the planes of the lattice
  beadswim-layout swimmer --preset paper-single --box 60,80,40 --boundary periodic --period "$1" --amplitude 0.2
}
pair() { # PERIOD DISTANCE PHASE
  lone "$1" | jq --argjson distance "$2" --argjson phase "$3" '.swimmers[0] as $one | .swimmers =
    [$one | .position[1] -= $distance / 2] + [$one | .id = 1 | .position[1] += $distance / 2 | .driving = {phase_offset: $phase}]'
}
velocities() { # FLAGS...   standard input: layout
  beadswim-run - -o "$work/run.h5md" --cycles 4 --progress none "$@" 2>/dev/null |
    jq -c '[.swimmers[].cycles[-1] | [range(3) as $a | .velocity[$a] - .mean_flow[$a]]]'
}

for period in 2000 8000; do
  for flags in "--cells-per-radius 3 --relaxation-time 1" "--model rpy+near" "--model rpy"; do
    # A quarter of the frequency with a quarter of the stiffness: the same strokes with a quarter of the inertia.
    soft() { if [ "$period" = 8000 ]; then jq '.types.a.springs[].stiffness /= 4 | .types.a.driving.amplitude = [0.05, 0.05]'; else cat; fi; }
    # shellcheck disable=SC2086  # flags
    alone=$(lone $period | soft | velocities $flags | jq '.[0][0]')
    for distance in 12 20 32; do
      for phase in 0 1.5707963267948966; do
        # shellcheck disable=SC2086  # flags
        pair $period $distance $phase | soft | velocities $flags |
          jq -c --argjson distance "$distance" --argjson phase "$phase" --argjson period $period --arg flags "$flags" --argjson alone "$alone" \
            '{period: $period, distance: ($distance / 4), phase: $phase, flags: $flags, lone: $alone,
              swimmers: [[.[0][0], -.[0][1]], [.[1][0], .[1][1]] | map(. / $alone)]}'
      done
    done
  done
done
