#!/bin/bash
# A chain that settles across its axis.
#   examples/shapes/chain.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict --direction 0,0,-1
print_motion "settles by" "-.velocity[2] * .period" "along -z"
