#!/bin/bash
# What a cycle of --model rpy costs, in mobility products, and how exact it is, beside CVODE's steps.
#   docs/results/steps-and-errors.sh      (two minutes; build/release built)
set -euo pipefail
cd "$(dirname "$0")/../.."
{
  cat <<'TEXT'
# Mobility products and errors of time steps

`docs/results/steps-and-errors.sh`. Own steps: `libs/overdamped`, so many a cycle. CVODE of SUNDIALS: backward differences of orders 1 to 5, steps and orders chosen
to a tolerance, here of the local error in arms' rest lengths; GMRES, preconditioned for each swimmer alone; products with its Jacobian by difference quotients, or with
mobility held (mu K). Both count every product, those of the start too. Errors are those of time steps alone, against CVODE at 1e-10: root mean square of the beads' places over that of
their displacement, and of the displacement of the swarm's mean over that displacement. Products to 1e-4.
TEXT
  build/release/bin/overdamped_steps_and_errors --product-tolerance 1e-4
} >docs/results/steps-and-errors.md
