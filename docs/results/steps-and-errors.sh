#!/bin/bash
# Measures mobility products per cycle and errors of time steps of --model rpy, and compares them with CVODE.
#   docs/results/steps-and-errors.sh      (two minutes; build/release built)
set -euo pipefail
cd "$(dirname "$0")/../.."

# Selects rows (every second tolerance of CVODE with difference quotients; 100 and 200 steps of libs/overdamped) and columns
# (method, products and errors) of the program's tables.
typical() {
  awk -F' *[|] *' '
    /^## turned/  { print "## turned: three such swimmers with different axes, which bend"; next }
    /^## cell/    { print "## cell: one swimmer in the unit cell of the paper\047s uniform swarm"; next }
    /^## dense/   { sub(/, 16 apart, disturbed/, " at a distance of 16, slightly displaced and tilted") }
    /^From rest/  { sub(/From rest over 1 cycle: beads displaced by/, "In one cycle from rest, beads move by"); sub(/the swarm by/, "the swarm moves by") }
    /^[|] by /    { print "| method | mobility products per cycle | relative error of bead positions | relative error of swarm displacement |"; next }
    /^[|]---/     { print "|---|---|---|---|"; next }
    /^[|] CVODE/  { if ($2 !~ /differences, 1e-0[357]$/) next }
    /^[|] own/    { if ($2 !~ /, (100|200)$/) next }
    /^[|]/        { sub(/differences, /, "tolerance "); if (sub(/own steps/, "`libs/overdamped`")) sub(/, [0-9]+/, "& steps") }
    /^[|]/        { printf "| %s | %s | %s | %s |\n", $2, $4, $5, $6; next }
    { print }'
}

{
  cat <<'TEXT'
# Mobility products and errors of time steps

With 100 time steps per cycle, the integrator of `libs/overdamped` needs 110 to 370 [mobility products](../method/mobility-product.md) per cycle, and the relative errors of the bead positions are 2e-5 to 3e-4. CVODE of SUNDIALS, which chooses its step sizes, needs as many products for the same error in swarms of parallel swimmers, and fewer in dense swarms.

The tables contain errors of time integration alone, relative to CVODE at tolerance 1e-10.

- "Relative error of bead positions": root mean square error of the bead positions, divided by the root mean square displacement of the beads.
- "CVODE, tolerance": backward differences of orders 1 to 5; the tolerance limits the local error, in units of the arm rest length. The Jacobian is evaluated by difference quotients, the linear solver is GMRES with one preconditioner block per swimmer.
- Products are evaluated to a tolerance of 1e-4; the number includes the products of the first step.

`docs/results/steps-and-errors.sh` repeats the measurement.
TEXT
  build/release/bin/overdamped_steps_and_errors open turned cell dense-16 --product-tolerance 1e-4 | typical
} >docs/results/steps-and-errors.md
