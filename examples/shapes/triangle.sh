#!/bin/bash
# A triangle whose sides change their lengths in turn rotates and does not move.
#   examples/shapes/triangle.sh [FOLDER]
source "$(dirname "$0")/shape.sh"

run_and_predict --orientation 1,1,0,0   # turns the y axis of the type onto z
print_motion "rotates by" "-.angular_velocity[1] * .period * 180 / 3.14159265" "degrees about -y"
