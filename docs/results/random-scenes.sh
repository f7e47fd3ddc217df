#!/bin/bash
# Measures what runs of random scenes give, to be compared with what predictions and plans state.
#   docs/results/random-scenes.py 60 28 | docs/results/random-scenes.sh > random-scenes.jsonl     (the programs on PATH)
# An hour on one core. Prints one line per scene: the flags of its layout, and the runs, the reference run first:
# flags, cost, and for each cycle [velocity along the axis relative to the fluid, arm amplitude d1, arm amplitude d2]. A run that
# stops has no cycles.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

measure() { # CYCLES FLAGS...
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none --cycles "$@" >"$work/run.json" 2>/dev/null </dev/null ||
    echo '{}' >"$work/run.json"
  jq -c --arg flags "${*:2}" --argjson periodic "$periodic" '
    {flags: $flags, core_seconds: .cost.core_seconds,
     cycles: [.swimmers[0].cycles // [] | .[] | [.speed_along_axis - (if $periodic then (.mean_flow // [0])[0] else 0 end)] + .arm_amplitudes]}' \
    "$work/run.json"
}

while read -r scene; do
  # shellcheck disable=SC2046  # flags
  beadswim-layout swimmer $(jq -r .layout <<<"$scene") >"$work/layout.json"
  periodic=$(jq '.domain.boundary[0] == "periodic"' "$work/layout.json")
  cycles=$(jq .cycles <<<"$scene")
  jq -r '.reference, .tested[], "--model rpy", "--model rpy+near", "--model oseen"' <<<"$scene" | while read -r flags; do
    # shellcheck disable=SC2086  # flags
    measure "$cycles" $flags
  done >"$work/runs.jsonl"
  jq -c --slurpfile runs "$work/runs.jsonl" '{scene, layout, number_of_cycles: .cycles, runs: $runs}' <<<"$scene"
done
