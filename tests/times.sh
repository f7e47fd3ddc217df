#!/bin/bash
# Prints the times of all tests that take 5 s or more, for tests/times.txt, after ctest has run in the build folder:
#   ctest --test-dir BUILD -j2 && tests/times.sh BUILD >tests/times.txt
# ctest averages over its runs in the folder; --fresh of cmake or removing BUILD/Testing begins anew.
set -euo pipefail
slow=$(ctest --test-dir "$1" -N -L slow | sed -n 's/^ *Test *#[0-9]*: //p')
echo "# Seconds, label slow or -, and name of the tests that take 5 s or more (tests/times.sh), on two cores."
sed '/^---$/q' "$1/Testing/Temporary/CTestCostData.txt" | awk 'NF == 3 && $3 >= 5 { printf "%.0f %s\n", $3, $1 }' | sort -k1,1rn -k2 |
  while read -r seconds name; do
    if grep -qxF "$name" <<<"$slow"; then label=slow; else label=-; fi
    printf '%4d %-4s %s\n' "$seconds" "$label" "$name"
  done
