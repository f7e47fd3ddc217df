#!/bin/bash
# Searches the swimmers of docs/optimise.md.
#   docs/results/best-swimmers.sh FOLDER [known|unknown]    with the programs on PATH; half a minute, and ten minutes for the unknown one
# Writes FOLDER/best-swimmers-known.jsonl and FOLDER/best-swimmers-unknown.jsonl: the study of each layout that was found, with
# the question and the method.
set -euo pipefail

folder=$(realpath "${1:?usage: best-swimmers.sh FOLDER [known|unknown]}")
part=${2:-known}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

best() { # QUESTION METHOD LAYOUT FLAGS...
  local question=$1 method=$2 layout=$3 flag=--method
  shift 3
  case $method in rpy | multipole) flag=--model ;; esac
  beadswim-optimise "$layout" $flag "$method" "$@" 2>"said" |
    jq -c --arg question "$question" --arg by "$method" '{question: $question, by: $by} + .study'
  sed "s/^/$question, $method: /" said >&2
}

swimmer() { beadswim-layout swimmer --preset paper-single --unbounded "$@"; }
swimmer >paper.json
swimmer --phase 0 --amplitude 0.02,0.01 >unequal.json

# Efficiency by exact Stokes flow of the swimmer that a line of records has found, as a layout of version 1.
exact() { # QUESTION JQ-FILTER-OF-THE-STUDY
  local values
  values=$(jq -r "$2"' | "--amplitude \(.forces) --arm \(20 + .at),\(20 - .at) --phase \(.phase // 1.5707963267948966) --stiffness \(.stiffness // 0.0347)"')
  swimmer $values | beadswim-theory --method multipole-ode | # as words
    jq -c --arg question "$1" '{question: $question, by: "multipole-ode"} + (.predictions[0] | {power, efficiency})'
}
of_line='{at: .["/types/line/beads/1/at/0"], forces: .["/types/line/driving/forces/0/harmonics/0/amplitude"],
  phase: .["/types/line/driving/forces/1/harmonics/1/phase"], stiffness: .["/types/line/bonds/0/stiffness"]}'

# Three beads on a line, whose middle bead moves between the outer ones: springs without a rest length have that of the beads.
jq -n '{schema: "beadswim/layout/2", units: "lattice", fluid: {density: 1, kinematic_viscosity: (1/3)}, domain: null,
  types: {line: {
    beads: [[-20, 0, 0], [0, 0, 0], [20, 0, 0]] | map({radius: 4, density: 1, at: .}),
    bonds: [[1, 2], [2, 3]] | map({beads: ., stiffness: 0.0347}),
    driving: {period: 4800, forces: [
      {bead: 1, direction: [1, 0, 0], harmonics: [{amplitude: 0.1, phase: 0}]},
      {bead: 2, direction: [-1, 0, 0], harmonics: [{amplitude: 0.1, phase: 0}, {amplitude: 0.1, phase: (2 * (1 | atan))}]},
      {bead: 3, direction: [1, 0, 0], harmonics: [{amplitude: 0.1, phase: (2 * (1 | atan))}]}]}}},
  swimmers: [{id: 0, type: "line", position: [0, 0, 0], orientation: [1, 0, 0, 0]}]}' >line.json
forces=/types/line/driving/forces
amplitudes=$forces/0/harmonics/0/amplitude,$forces/1/harmonics/0/amplitude,$forces/1/harmonics/1/amplitude,$forces/2/harmonics/0/amplitude
phases=$forces/1/harmonics/1/phase,$forces/2/harmonics/0/phase
stiffnesses=/types/line/bonds/0/stiffness,/types/line/bonds/1/stiffness
efficient=(--free /types/line/beads/1/at/0=-12:12 --free "$amplitudes=0.02:0.4" --maximise efficiency
  --subject-to power=:2e-4 --subject-to gap=4:)

if [ "$part" = known ]; then
  for method in oseen-force-closed rpy-ode multipole-ode; do
    best "phase of greatest speed" $method paper.json --free phase=0:180deg --maximise velocity
    best "stiffness of greatest speed" $method unequal.json --free stiffness=0.001:1 --maximise velocity
  done
  best "most efficient arm ratio" rpy-ode line.json "${efficient[@]}"
  best "most efficient arm ratio" multipole line.json "${efficient[@]}" --cycles 4 >ratio.jsonl
  cat ratio.jsonl
  exact "these arms, exactly" "$of_line" <ratio.jsonl
  exact "equal arms of the same power, exactly" '{at: 0, forces: 0.1093}' <<<null
else
  for seed in 1 2; do
    best "most efficient swimmer, seed $seed" multipole line.json "${efficient[@]}" --free "$phases=0:180deg" --free "$stiffnesses=0.005:0.5" \
      --cycles 4 --evaluations 2000 --seed $seed --verify-by rpy-ode >unknown.jsonl
    cat unknown.jsonl
  done
  exact "this swimmer, exactly" "$of_line" <unknown.jsonl
  for seed in 1 2 3; do
    best "most efficient swimmer, seed $seed" rpy-ode line.json "${efficient[@]}" --free "$phases=0:180deg" --free "$stiffnesses=0.005:0.5" \
      --evaluations 2000 --seed $seed
  done
fi >"$folder/best-swimmers-$part.jsonl"
