#!/bin/bash
# Measures mobility products per cycle and errors of time steps of --model rpy, and compares them with CVODE.
#   docs/results/steps-and-errors.sh      (two minutes; build/release built)
set -euo pipefail
cd "$(dirname "$0")/../.."

# Of the program's rows: every second tolerance of CVODE with difference quotients, and 50, 100 and 200 own steps.
# Of its columns: the method, products and errors.
typical() {
  awk -F' *[|] *' '
    /^[|] by /    { print "| method | products per cycle | error of positions | of swimming |"; next }
    /^[|]---/     { print "|---|---|---|---|"; next }
    /^[|] CVODE/  { if ($2 !~ /differences, 1e-0[357]$/) next }
    /^[|] own/    { if ($2 !~ /, (50|100|200)$/) next }
    /^[|]/        { printf "| %s | %s | %s | %s |\n", $2, $4, $5, $6; next }
    { print }'
}

{
  cat <<'TEXT'
# Mobility products and errors of time steps

A mobility product evaluates the velocities of all beads from the forces on them. With the default of 100 time steps per cycle, the integrator of `libs/overdamped` ("own steps") needs 110 to 370 products per cycle and has relative errors of 2e-5 to 3e-4 in the positions. CVODE of SUNDIALS, which chooses its own step sizes, needs as many products for the same error in swarms of parallel swimmers, and fewer in dense swarms. For errors of 1e-4 to 3e-4 in swarms of parallel swimmers both need 60 to 140 products per cycle.

The tables contain errors of the time steps alone, relative to CVODE at tolerance 1e-10.

- "Error of positions": root mean square error of the bead positions, divided by the root mean square displacement of the beads.
- "Of swimming": relative error of the swarm's mean displacement.
- CVODE: backward differences of orders 1 to 5, with the stated tolerance for the local error in units of the arm rest length; GMRES with one preconditioner block per swimmer.
- Products: evaluated to a tolerance of 1e-4. All are counted, including those of the start.

`docs/results/steps-and-errors.sh` repeats the measurement.
TEXT
  build/release/bin/overdamped_steps_and_errors --product-tolerance 1e-4 | typical
} >docs/results/steps-and-errors.md
