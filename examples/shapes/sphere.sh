#!/bin/bash
# A towed bead moves by Stokes' law.
#   examples/shapes/sphere.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict
compare_velocities 0.001
print_motion "moves by" ".along * .period" "along its axis"
