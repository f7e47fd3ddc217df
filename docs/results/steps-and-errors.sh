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

The default of 100 own steps per cycle (`libs/overdamped`) costs 110 to 370 mobility products and leaves relative errors of 2e-5 to 3e-4 in the positions. CVODE of SUNDIALS, which chooses its steps, needs as many products for the same error in straight swarms and fewer in dense ones. For errors of 1e-4 to 3e-4 in straight swarms both take 60 to 140 products per cycle.

The tables hold errors of time steps alone, relative to CVODE at tolerance 1e-10. "Positions" is the root mean square error of the bead positions, divided by that of their displacement. "Of swimming" is the error of the swarm's mean displacement, divided by it. CVODE uses backward differences of orders 1 to 5 with a tolerance for the local error in arm rest lengths, and GMRES with one preconditioner block per swimmer. Products are evaluated to 1e-4; all are counted, including those of the start. `docs/results/steps-and-errors.sh` repeats this; the program `overdamped_steps_and_errors` also prints steps, times, more tolerances and CVODE with constant mobility in its Jacobian, which needs as many products.
TEXT
  build/release/bin/overdamped_steps_and_errors --product-tolerance 1e-4 | typical
} >docs/results/steps-and-errors.md
