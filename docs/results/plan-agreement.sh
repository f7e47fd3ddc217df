#!/bin/bash
# Compares plans with runs, for scenes chosen by a seed: one swimmer in a periodic box, with random arms, stroke, period, stiffness,
# phase, box and tolerance. Each scene is planned, the chosen run is made, and its result is compared with a lattice run of higher
# resolution. Writes FOLDER/plan-agreement.jsonl: parameters, choice, predicted and measured cost, predicted and measured error.
#   docs/results/plan-agreement.sh FOLDER [SEED [SCENES]]        (default: seed 1, 20 scenes; takes some 20 minutes on one core)
# Needs an idle machine, because costs are measured.
set -euo pipefail
folder=$1 seed=${2:-1} scenes=${3:-20}
mkdir -p "$folder"
cd "$folder"

# Prints number, arm, stiffness, amplitude, period, phase, box and tolerance of each scene. Bead radius 4, nu = 1/3, density 1.
random_scenes() {
  awk -v seed="$seed" -v scenes="$scenes" '
    function uniform(low, high) { return low + (high - low) * rand() }
    function logarithmic(low, high) { return exp(uniform(log(low), log(high))) }
    function edge(length_) { return 4 * int(length_ / 4 + 0.5) }
    BEGIN {
      srand(seed); pi = atan2(0, -1); radius = 4; nu = 1 / 3
      for (n = 1; n <= scenes; ++n) {
        depth = radius / logarithmic(0.15, 0.5)  # penetration depth
        period = pi * depth ^ 2 / nu
        arm = radius * uniform(4, 8)
        drag = 6 * pi * nu * radius * 2 * pi / period
        stiffness = drag / logarithmic(0.3, 3)
        stroke = (arm - 2 * radius) * uniform(0.1, 0.4)
        amplitude = stroke * sqrt(stiffness ^ 2 + drag ^ 2)
        split("0.1 0.03 0.01", tolerance, " ")
        printf "%d %.4g %.4g %.4g %.5g %.3gdeg %d,%d,%d %s\n", n, arm, stiffness, amplitude, period, uniform(40, 140),
          edge((2 * arm + 2 * radius) * uniform(1.3, 2.2)), edge(radius * uniform(6, 10)), edge(radius * uniform(6, 10)),
          tolerance[1 + n % 3]
      }
    }'
}

velocity='.swimmers[0].cycles[-1] | .velocity[0] - .mean_flow[0]'
strokes='.swimmers[0].cycles[-1].arm_amplitudes'
while read -r n arm stiffness amplitude period phase box tolerance; do
  beadswim-layout swimmer --preset paper-single --arm "$arm" --stiffness "$stiffness" --amplitude "$amplitude" --period "$period" \
    --phase "$phase" --box "$box" --boundary periodic >"scene-$n.json"
  beadswim-run "scene-$n.json" --plan --tolerance "$tolerance" --cycles 4 >"plan-$n.json" 2>"plan-$n.txt" || continue
  choice=$(jq -r .choice "plan-$n.json")
  # shellcheck disable=SC2086
  beadswim-run "scene-$n.json" $choice --cycles 4 --progress none -o "run-$n.h5md" >"run-$n.json" 2>/dev/null || continue
  beadswim-run "scene-$n.json" --model lbm --cells-per-radius 4 --relaxation-time 1 --bead-boundary mr --cycles 4 --progress none \
    -o "reference-$n.h5md" >"reference-$n.json" 2>/dev/null || continue
  jq -nc --slurpfile plan "plan-$n.json" --slurpfile run "run-$n.json" --slurpfile reference "reference-$n.json" --argjson scene "$n" \
    --arg parameters "arm $arm, stiffness $stiffness, amplitude $amplitude, period $period, phase $phase, box $box" "
    (\$plan[0] as \$p | \$p.runs[] | select(.flags == \$p.choice)) as \$chosen | (\$run[0]) as \$r | (\$reference[0]) as \$s |
    {scene: \$scene, parameters: \$parameters, tolerance: \$plan[0].tolerance, choice: \$plan[0].choice,
     cost: {predicted: \$chosen.cost.core_seconds, measured: \$r.cost.core_seconds},
     velocity_error: {predicted: \$chosen.error.velocity, measured: ((\$r | $velocity) / (\$s | $velocity) - 1)},
     stroke_error: {predicted: (\$chosen.error.arm_amplitudes | max),
                    measured: ((\$r | $strokes) as \$a | (\$s | $strokes) as \$b |
                      [range(2) | (\$a[.] / \$b[.] - 1) | fabs] | max)},
     reference_cost: \$s.cost.core_seconds}"
done < <(random_scenes) | tee plan-agreement.jsonl
