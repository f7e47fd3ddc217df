#!/bin/bash
# Installs what is missing, builds and runs the tests; ends with ctest's summary.
#   tests/run.sh        (about the build's time, and ten minutes)
set -euo pipefail
cd "$(dirname "$0")/.."

.ci/install-packages.sh
cmake --preset release
cmake --build --preset release
ctest --preset release
