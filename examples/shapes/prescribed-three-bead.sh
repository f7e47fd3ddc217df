#!/bin/bash
# The three-bead swimmer of Najafi and Golestanian with a prescribed stroke.
#   examples/shapes/prescribed-three-bead.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict
compare_velocities 0.001
print_motion "moves by" ".along * .period" "along its axis"
