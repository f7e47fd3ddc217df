#!/bin/bash
# Compares expected and measured errors in scenes that theory simplifies: an oblique axis, no-slip walls, two unequal swimmers, and
# other shapes than three beads on a line.
#   docs/results/simplified-scenes.sh 21 12 1 > simplified-scenes.jsonl     (NUMBER SHAPES SEED; twenty minutes on one core; the programs on PATH)
# Prints a line per scene: number, layout, and per run flags, expected and measured relative errors [v, d1, d2, ...] in the third cycle,
# of several swimmers the root mean square; of flagella that of v alone, because their bonds are stiff. v of other shapes is the size of
# the velocity, and a plan expects their errors. The reference is a lattice run with 3 cells per radius and a relaxation time of 1.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
number=$1 shapes=$2 seed=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Prints commands that make layouts. Radius 4, kinematic viscosity 1/3, density 1; box edges are multiples of 4.
layouts() {
  awk -v number="$number" -v shapes="$shapes" -v seed="$seed" '
    function uniform(low, high) { return low + (high - low) * rand() }
    function logarithmic(low, high) { return exp(uniform(log(low), log(high))) }
    function edge(length_) { return 4 * int(length_ / 4 + 0.5) }
    BEGIN {
      srand(seed); pi = atan2(0, -1)
      for (n = 0; n < number; ++n) {
        period = logarithmic(600, 1600); arm = uniform(15, 22); drag = 6 * pi / 3 * 4 * 2 * pi / period
        stiffness = drag / logarithmic(0.3, 2); amplitude = (arm - 8) * uniform(0.15, 0.35) * sqrt(stiffness ^ 2 + drag ^ 2)
        type = sprintf("--period %.5g --arm %.4g --stiffness %.4g --amplitude %.4g --phase %.3gdeg", period, arm, stiffness, amplitude, uniform(50, 130))
        length_ = 2 * arm + 8
        if (n % 3 == 0) printf "beadswim-layout swimmer --preset paper-single %s --boundary periodic --frame body --axis %.3f,%.3f,%.3f --box %d,%d,%d\n",
          type, uniform(0.5, 1), uniform(0.2, 0.8), uniform(-0.5, 0.5), edge(length_ * uniform(1.1, 1.5)), edge(length_ * uniform(1, 1.3)), edge(length_ * uniform(1, 1.3))
        if (n % 3 == 1) printf "beadswim-layout swimmer --preset paper-single %s --boundary periodic,no-slip,no-slip --box %d,%d,%d\n",
          type, edge(length_ * uniform(1.3, 2)), edge(4 * uniform(6, 11)), edge(4 * uniform(6, 11))
        if (n % 3 == 2) {
          y = edge(4 * uniform(10, 16))
          printf "beadswim-layout swimmer --preset paper-single %s --boundary periodic --box %d,%d,%d | jq %s | beadswim-layout defect %s --seed %d\n", type, edge(length_ * uniform(1.2, 1.6)),
            y, edge(4 * uniform(6, 9)), sprintf("%c.swimmers += [.swimmers[0] | .id = 1 | .position[1] -= %d]%c", 39, y / 2, 39), rand() < 0.5 ? "phase --sigma 1" : "rotation --sigma 0.2", n
        }
      }
      for (n = 0; n < shapes; ++n) {
        arm = uniform(15, 22); swing = (arm - 8) * uniform(0.15, 0.35)
        if (n % 4 == 0) kind = sprintf("triangle --amplitude %.4g --phase %.3gdeg", swing, uniform(30, 110))
        if (n % 4 == 1) kind = sprintf("prescribed-three-bead --radius 4,%.3g,4 --amplitude %.4g --phase %.3gdeg", uniform(4, 5), swing, uniform(50, 130))
        if (n % 4 == 2) kind = sprintf("dumbbell --radius 4,%.3g --amplitude %.4g", uniform(4.5, 6), swing)
        if (n % 4 == 3) kind = sprintf("flagellum --beads %d --sperm-number %.3g", 4 + n % 3, uniform(2, 4))
        width = arm * (n % 4 == 3 ? 5 : 2) + 8
        printf "beadswim-layout shape %s --arm %.4g --period %.5g --boundary periodic --box %d,%d,%d\n",
          kind, arm, logarithmic(600, 1600), edge(width * uniform(1.2, 1.6)), edge(width * uniform(0.8, 1.2)), edge(4 * uniform(10, 16))
      }
    }'
}

simulate() { # FLAGS...   prints [velocity relative to the fluid, arm amplitudes] of each swimmer, or null if the run stops
  local plan=null
  if [[ $command == *" shape "* ]]; then
    plan=$({ beadswim-run "$work/layout.json" --plan --cycles 3 "$@" </dev/null 2>/dev/null || true; } | jq -c '.runs[0].error')
  fi
  beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles 3 --progress none "$@" </dev/null >"$work/run.json" 2>/dev/null || true
  jq -c --argjson walls "$walls" --argjson plan "$plan" --arg command "$command" 'if .status != "finished" then null elif $plan then
    {expected: ($plan | [.velocity] + .arm_amplitudes),
     swimmers: [.swimmers[].cycles[-1] | [[.velocity, .mean_flow] | transpose | map(.[0] - .[1] | . * .) | add | sqrt]
       + if $command | test("flagellum") then [] else .arm_amplitudes end]}
    else
    {expected: (.expected_error | [.velocity] + .arm_amplitudes),
     swimmers: [.swimmers[].cycles[-1] | [.speed_along_axis - if $walls then 0 else [.axis, .mean_flow // [0, 0, 0]] | transpose | map(.[0] * .[1]) | add end] + .arm_amplitudes]}
    end' "$work/run.json"
}

layouts | cat -n | while read -r n command; do
  bash -c "$command" >"$work/layout.json"
  walls=$(jq '.domain.boundary | any(. == "no-slip")' "$work/layout.json")
  simulate --model lbm --cells-per-radius 3 --relaxation-time 1 --precision single >"$work/reference.json"
  for flags in "--model lbm --cells-per-radius 2 --relaxation-time 1" "--model lbm --cells-per-radius 2 --relaxation-time 1.5" \
    "--model oseen" "--model rpy" "--model rpy+near"; do
    # shellcheck disable=SC2086  # flags
    simulate $flags | jq -c --arg flags "$flags" --slurpfile reference "$work/reference.json" '
      def rms: map(. * .) | add / length | sqrt;
      select(.) | {flags: $flags, expected, error: ([.swimmers, $reference[0].swimmers] | transpose
        | map(transpose | map(.[0] / .[1] - 1)) | transpose | map(rms))}'
  done >"$work/runs.jsonl"
  jq -nc --argjson n "$n" --arg layout "$command" --slurpfile runs "$work/runs.jsonl" --slurpfile reference "$work/reference.json" \
    '{scene: $n, layout: $layout, reference: $reference[0].expected, runs: $runs}'
done
