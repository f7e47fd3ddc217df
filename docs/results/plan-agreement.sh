#!/bin/bash
# Compares plans with runs, for scenes chosen by a seed: one swimmer in a periodic box, with random arms, stroke, period, stiffness,
# phase, box and tolerance. Each scene is planned, and the chosen run is made, on the lattice at four places within a cell. Prints for
# each scene: parameters, choice, predicted and measured cost, predicted (limit and typical) and measured error, and the errors of all
# mobility models that the plan did not refuse: [flags, then limit, typical, measured error of velocity and strokes]. Measured errors
# of the chosen run are root mean squares relative to lattice runs with 3 and 4 cells per radius, extrapolated to zero cell size. If
# the chosen run is not within the tolerance of this reference, the reference is repeated with 4 and 6 cells.
#   docs/results/plan-agreement.sh FOLDER [SEED [SCENES [FIRST STRIDE]]] >plan-agreement.jsonl   (default: seed 1, 20 scenes; the page has seed 2)
# FIRST and STRIDE select every STRIDE-th scene. Takes an hour on one core. Costs are measured: nothing else should run.
set -euo pipefail
folder=$1 seed=${2:-1} scenes=${3:-20} first=${4:-1} stride=${5:-1}
results=$(realpath "$(dirname "$0")")
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

simulate() { # NAME FLAGS...   prints the record
  beadswim-run "$1.json" -o "$1.h5md" --cycles 4 --progress none "${@:2}" </dev/null 2>/dev/null
}

# Prints the line of a scene, with the variables of the loop below.
compare() {
  jq -nc --slurpfile plan "plan-$n.json" --slurpfile runs "runs-$n.jsonl" --slurpfile reference "reference-$n.json" \
    --slurpfile models "models-$n.jsonl" --argjson seed "$seed" --argjson scene "$n" --arg cells "$reference_cells" --argjson tolerance "$tolerance" --arg parameters "arm $arm, stiffness $stiffness, amplitude $amplitude, period $period, phase $phase, box $box" '
    def velocity: .velocity[0] - (.mean_flow[0] // 0);
    def rms: map(. * .) | add / length | sqrt;
    def strokes: .arm_amplitudes | max;
    ($plan[0] | .choice as $flags | [.runs[] | select(.flags == $flags)][0]) as $chosen
    | $reference[0].swimmers[0] as $r | $r.cycles[-1] as $exact | [$runs[].swimmers[0].cycles[-1]] as $found
    | def velocity_error: velocity / ($exact | velocity) - 1;
      def stroke_errors: . as $cycle | [range(2) | $cycle.arm_amplitudes[.] / $exact.arm_amplitudes[.] - 1];
    if $found == [] then {seed: $seed, scene: $scene, parameters: $parameters, tolerance: $tolerance, choice: $plan[0].choice} else
      {seed: $seed, scene: $scene, parameters: $parameters, tolerance: $tolerance, choice: $plan[0].choice, reference_cells: $cells,
       cost: {predicted: $chosen.cost.core_seconds, measured: ([$runs[].cost.core_seconds] | sort | .[(length - 1) / 2 | floor])},
       velocity: {limit: $chosen.error.velocity, typical: $chosen.typical_error.velocity, measured: ($found | map(velocity_error) | rms),
                  reference: $r.uncertainty.velocity.total},
       strokes: {limit: ($chosen.error | strokes), typical: ($chosen.typical_error | strokes),
                 measured: ($found | map(stroke_errors) | transpose | map(rms) | max), reference: $r.uncertainty.arm_amplitudes.total},
       models: [$models[] | .flags as $flags | first($plan[0].runs[] | select(.flags == $flags)) as $run | .swimmers[0].cycles[-1]
         | [$flags, $run.error.velocity, $run.typical_error.velocity, (velocity_error | fabs), ($run.error | strokes),
            ($run.typical_error | strokes), (stroke_errors | map(fabs) | max)]]} end'
}

# Succeeds if the chosen run is within the tolerance.
is_right() { # FILE
  jq -rs -f "$results/plan-agreement.jq" "$1" 2>/dev/null | grep -q '^Within the tolerance: 1 '
}

while read -r n arm stiffness amplitude period phase box tolerance; do
  (((n - first) % stride == 0)) || continue
  beadswim-layout swimmer --preset paper-single --arm "$arm" --stiffness "$stiffness" --amplitude "$amplitude" --period "$period" \
    --phase "$phase" --box "$box" --boundary periodic >"scene-$n.json"
  beadswim-run "scene-$n.json" --plan --tolerance "$tolerance" --cycles 4 >"plan-$n.json" 2>"plan-$n.txt" || true
  read -ra choice <<<"$(jq -r '.choice // ""' "plan-$n.json")"
  : >"runs-$n.jsonl"
  places=1
  [[ " ${choice[*]} " == *" lbm "* ]] && places=4
  ((${#choice[@]} > 0)) && for place in $(seq $places); do
    jq --argjson n "$place" '.swimmers[0].position |= (. as $p | [0.8191725, 0.6710436, 0.5497005] | to_entries
      | map($p[.key] + 2 * (.value * $n | . - floor)))' "scene-$n.json" >"placed-$n.json"
    simulate "placed-$n" "${choice[@]}" >>"runs-$n.jsonl" || echo "scene $n: the chosen run has no result" >&2
  done
  jq -r '.runs[]? | select(.model != "lbm" and .refused == null).flags' "plan-$n.json" | while read -r flags; do
    # shellcheck disable=SC2086  # flags
    simulate "scene-$n" $flags | jq -c --arg flags "$flags" '{flags: $flags, swimmers}' || echo "scene $n: $flags has no result" >&2
  done >"models-$n.jsonl"
  rm -f "cells-$n-"*.json
  for reference_cells in "3 4" "4 6"; do
    for cells in $reference_cells; do
      [ -s "cells-$n-$cells.json" ] ||
        simulate "scene-$n" --model lbm --cells-per-radius "$cells" --relaxation-time 1 --precision single >"cells-$n-$cells.json"
      cat "cells-$n-$cells.json"
    done | jq -s -f "$results/extrapolated-record.jq" >"reference-$n.json"
    compare >"line-$n.json"
    if ((${#choice[@]} == 0)) || is_right "line-$n.json"; then break; fi
  done
  cat "line-$n.json"
done < <(random_scenes)
