#!/bin/bash
# Purcell's swimmer: three links and two hinges.
#   examples/shapes/purcell-chain.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict --orientation 1,1,0,0   # turns the y axis of the type onto z
compare_velocities 0.001
print_motion "moves by" ".along * .period" "along its axis"
