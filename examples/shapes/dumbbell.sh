#!/bin/bash
# A dumbbell does not swim without inertia: Purcell's scallop theorem.
#   examples/shapes/dumbbell.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict
print_motion "moves by" ".along * .period" "along its axis"
