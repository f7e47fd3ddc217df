#!/bin/bash
# Runs eight scenes of several swimmers (memory-scenes.py) on the lattice with two resolutions.
#   docs/results/memory-scenes.py | docs/results/memory-scenes.sh LATTICE >memory-scenes-lattice.jsonl    (the programs on PATH; an hour on one core)
#   docs/results/memory-scenes.py | docs/results/memory-scenes.sh MODELS >memory-scenes-models.jsonl      (three minutes)
# Prints one line per scene: flags, cost, and for each swimmer in the last cycle [velocity relative to the fluid, arm amplitudes].
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
what=${1:?LATTICE or MODELS}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

runs_of() {
  if [ "$what" = LATTICE ]; then
    for cells in 3 5; do echo "--model lbm --cells-per-radius $cells --relaxation-time 0.8 --precision single"; done
  else
    printf '%s\n' "--model rpy" "--model rpy+near" "--model multipole --multipole-order 2"
    for order in 0 1 2; do echo "--model unsteady --multipole-order $order"; done
    echo "--model unsteady --multipole-order 2 --reynolds-stress off"
  fi
}

while read -r scene; do
  jq .layout <<<"$scene" >"$work/layout.json"
  runs_of | while read -r flags; do
    # shellcheck disable=SC2086  # flags
    beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none --cycles "$(jq .cycles <<<"$scene")" $flags \
      >"$work/run.json" 2>"$work/run.err" </dev/null || { cat "$work/run.err" >&2; echo '{}' >"$work/run.json"; }
    jq -c --arg flags "$flags" '{flags: $flags, core_seconds: .cost.core_seconds, swimmers: [(.swimmers // [])[].cycles[-1] |
      [.velocity, .mean_flow // [0, 0, 0]] as [$v, $u] | [range(3) | $v[.] - $u[.]] + .arm_amplitudes]}' "$work/run.json"
  done >"$work/runs.jsonl"
  jq -c --slurpfile runs "$work/runs.jsonl" '{period: .layout.types.a.driving.period, swimmers: (.layout.swimmers | length), runs: $runs}' <<<"$scene"
done
