#!/bin/bash
# Compares what predictions and runs state about their errors with the measured errors of random scenes.
#   docs/results/stated-uncertainty.sh < random-scenes.jsonl > stated-uncertainty.jsonl     (ten minutes; the programs on PATH)
# Prints one line per scene. Errors and uncertainties are relative to the reference run; quantities are [v, d1, d2].
#   reference     uncertainty: that of resolution and wander, as the record states it, and of the transient
#   prediction    error and stated uncertainty of inertia-corrected
#   runs          flags, error and expected error of each other run
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The error that a run expects does not depend on its length: a few steps show it.
expected() { # FLAGS...
  { beadswim-run "$work/layout.json" -o "$work/run.h5md" --progress none --cycles 0.004 "$@" 2>/dev/null </dev/null || echo '{}'; } |
    jq -c '.expected_error | if . then [.velocity] + .arm_amplitudes else null end'
}

while read -r scene; do
  # shellcheck disable=SC2046  # flags
  beadswim-layout swimmer $(jq -r .layout <<<"$scene") >"$work/layout.json"
  beadswim-theory "$work/layout.json" --method inertia-corrected >"$work/theory.json"
  jq -r '.runs[].flags' <<<"$scene" | while read -r flags; do
    # shellcheck disable=SC2086  # flags
    expected $flags
  done >"$work/expected.jsonl"
  jq -c --slurpfile theory "$work/theory.json" --slurpfile expected "$work/expected.jsonl" '
    # What will still change after the last cycle, as run records estimate it.
    def transient: . as $cycles | [range(3) as $k | [$cycles[][$k]] | . as $all | $all[-1] as $last | (.[-1] - .[-2]) as $change
      | (if length > 2 and .[-2] != .[-3] and $change / (.[-2] - .[-3]) < 1 then [[$change / (.[-2] - .[-3]), 0.5] | max, 0.9] | min
         else 0.5 end) | . / (1 - .) * ($change / $last | fabs)];
    .runs[0].cycles as $cycles | $cycles[-1] as $reference | $theory[0].predictions[0] as $p
    | {scene, layout,
       reference: {flags: .runs[0].flags, uncertainty: ([$expected[0], ($cycles | transient)] | transpose | map(map(. * .) | add | sqrt))},
       prediction: {error: ([[$p.velocity] + $p.arm_amplitudes, $reference] | transpose | map(.[0] / .[1] - 1)),
                    stated: ([[$p.velocity * $p.uncertainty] + [[$p.arm_amplitudes, $p.stroke_uncertainty.arm_amplitudes] | transpose[] | .[0] * .[1]],
                              $reference] | transpose | map(.[0] / .[1] | fabs))},
       runs: ([.runs, $expected] | transpose[1:] | map({flags: .[0].flags, expected: .[1],
         error: (if .[0].cycles == [] then null else [.[0].cycles[-1], $reference] | transpose | map(.[0] / .[1] - 1) end)}))}' <<<"$scene"
done
