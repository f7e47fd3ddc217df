#!/bin/bash
# Installs what is missing, builds with warnings as errors and runs the tests; ends with ctest's summary.
#   tests/run.sh        (about the build's time, and some minutes)
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
cmake --preset ci
cmake --build --preset ci
ctest --preset ci
