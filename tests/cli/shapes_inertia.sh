#!/bin/bash
# Tests the lattice with shapes of the gallery against mobility in the same periodic box, at growing periods: inertia explains the
# difference, apart from the known error of Rotne-Prager. docs/results/shapes-inertia.sh repeats this with smaller cells.
source "$(dirname "$0")/harness.sh"

# Prints rotation about z [radian] and displacement along x relative to the mean flow [length] in the second cycle, as [turn, displacement].
motion() { # PERIOD FLAGS...   standard input: layout
  local period=$1
  shift
  beadswim-run - -o run.h5md --cycles 2 --progress none "$@" 2>err |
    jq -c --argjson period "$period" '.swimmers[0].cycles[1] | [.angular_velocity[2], .velocity[0] - .mean_flow[0]] | map(. * $period)'
}

# Writes the motion by rpy and, for three periods, by the lattice to the file KIND.
measure() { # KIND BOX
  beadswim-layout shape "$1" --box "$2" | motion 4800 --model rpy >"$1"
  for period in 4800 9600 19200; do
    beadswim-layout shape "$1" --box "$2" --period $period | motion $period --model lbm --cells-per-radius 2 --relaxation-time 1.5 >>"$1"
  done
}
measure triangle 80,80,60
measure prescribed-three-bead 100,60,60

# The motion by the lattice, divided by that by rpy, is r(T) = r + c T^-p, where p is 3/2 in unbounded fluid and 2 in boxes that are
# small for the penetration depth: its steps, of 0.1 to 2 %, fall by factors of 2.8 to 4. Beads take the same places within cells at all
# periods, so errors by cells hardly change the steps.
ratios='[.[1:][][$part] / .[0][$part]]'
falls="$ratios | (.[0] - .[1]) / (.[1] - .[2]) | . > 2 and . < 5"
check "the inertia of a triangle falls as its period grows" holds -s --argjson part 0 "$falls" triangle
check "the inertia of three beads falls as their period grows" holds -s --argjson part 1 "$falls" prescribed-three-bead
check "inertia accelerates the rotation" holds -s --argjson part 0 "$ratios | .[0] > .[1] and .[1] > .[2]" triangle
check "inertia slows three beads down" holds -s --argjson part 1 "$ratios | .[0] < .[1] and .[1] < .[2]" prescribed-three-bead

# Without inertia, beads that resist strain rotate by 0.215008 per period, by Rotne-Prager by 0.212742 (docs/results/shapes-theory.py),
# and three beads in line move exactly as by rpy+near. With 2 cells per radius, errors of velocities are 2 % (docs/limits.md).
limit="$ratios | .[2] + (.[2] - .[1]) / (pow(2; 1.5) - 1) | . / \$reference - 1 | fabs < 0.02"
check "the rest is the error of Rotne-Prager, for a triangle" holds -s --argjson part 0 --argjson reference 1.01065 "$limit" triangle
for model in rpy rpy+near; do beadswim-layout shape prescribed-three-bead --unbounded | motion 4800 --model $model; done >unbounded
check "and for three beads" holds -s --argjson part 1 --argjson reference "$(jq -s '.[1][1] / .[0][1]' unbounded)" "$limit" prescribed-three-bead

finish
