#!/bin/bash
# Installs missing packages, builds Beadswim and runs the tests. The output ends with the summary of ctest.
#   tests/run.sh
# Takes about 15 minutes on two cores, two thirds of them for the build, and 2 more minutes if packages are missing.
# The environment variable BEADSWIM_PRESET selects a preset of CMakePresets.json (default: release).
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
preset=${BEADSWIM_PRESET:-release}
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --label-exclude slow   # tests/extended.sh runs the slow tests
