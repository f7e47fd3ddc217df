#!/bin/bash
# An elastic chain whose end is driven from side to side.
#   examples/shapes/flagellum.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict --orientation 1,1,0,0   # turns the y axis of the type onto z
compare_velocities 0.01   # after six cycles, it still turns slowly into its final orientation
print_motion "moves by" ".along * .period" "along its axis"
