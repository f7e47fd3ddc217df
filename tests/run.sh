#!/bin/bash
# Installs what is missing, builds and runs the tests; ends with ctest's summary.
#   tests/run.sh        (13 minutes on two cores, 8 of them for the build; 2 more for packages)
# BEADSWIM_PRESET: the preset of CMakePresets.json, if another than release.
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
preset=${BEADSWIM_PRESET:-release}
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" --label-exclude slow   # those are run by tests/extended.sh
