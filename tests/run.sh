#!/bin/bash
# Installs what is missing, builds and runs the tests; ends with ctest's summary.
#   tests/run.sh        (16 minutes on two cores, half of them for the build)
# BEADSWIM_PRESET: the preset of CMakePresets.json, if another than release.
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
preset=${BEADSWIM_PRESET:-release}
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --label-exclude slow   # those are run by tests/extended.sh
