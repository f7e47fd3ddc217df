#!/bin/bash
# Tests beadswim-bench: its JSON document on 1 and 2 ranks, its table, and the input that it refuses. Speeds are not tested.
source "$(dirname "$0")/harness.sh"

accepts beadswim-bench --help
for flag in edge precision bead-boundary rounds json; do out_has "--$flag"; done
accepts beadswim-bench --version

run mpirun -n 2 beadswim-bench --json --edge 32,40 --rounds 1
has_status 0
err_has 'measurement 4 of 4: lattice edge of 40 cells, 2 ranks'
cp out bench.json
check "schema" test "$(jq -r .schema bench.json)" = beadswim/bench/1
check "a row each of 6 cases, 2 precisions, 2 edges, 1 and 2 ranks" \
  holds '[.rows[] | [.case, .precision, .edge, .ranks]] | unique | length == 48' bench.json
check "rates are positive" holds '.rows | map(.mlups > 0 and .mlups_best >= .mlups) | all' bench.json
check "the yardstick is its own measure" \
  holds '.rows | map(select(.case == "stream-yardstick")) | map(.fraction_of_yardstick == 1 and has("layout")) | all' bench.json
check "bytes" holds '.rows | map(.bytes_per_update == (if .precision == "double" then 304 else 152 end)) | all' bench.json
check "bandwidth" holds '.bandwidth.in_place_gb_s > 0 and .bandwidth.copy_gb_s > 0' bench.json
check "bandwidth by ranks" test "$(jq -c '[.bandwidth.by_ranks[].ranks]' bench.json)" = "[1,2]"
valid bench bench.json

check "beads are the paper's" test "$(jq -r .bead_boundary bench.json)" = staircase
run beadswim-bench --edge 32 --precision single --rounds 1 --bead-boundary mr
has_status 0
out_has 'mr beads'
out_has 'coupled-swarm'
check "one precision alone" test "$(grep -c double out)" = 1  # in the head of the table

run beadswim-bench --json --beads 1500 --rounds 1 --tolerance 1e-3 --multipole-order 1
has_status 0
check "moments need iterations, and their product is as accurate as asked" \
  holds '.mobility_products | length == 2 and all(.[]; .multipole_order == 1 and .iterations > 1 and .error < 1e-3)' out
run mpirun -n 2 beadswim-bench --json --beads 150 --rounds 1 --tolerance 1e-3 --unsteady
has_status 0
check "a fluid with inertia has a mesh and ends of steps" \
  holds '.mobility_products | length == 2 and all(.[]; .surroundings == "periodic" and .mesh_seconds > 0 and .end_of_step_seconds > 0)' out
run mpirun -n 2 beadswim-bench --json --beads 150 --rounds 1 --tolerance 1e-3 --noise
has_status 0
check "noise takes time" holds '.mobility_products | length == 4 and all(.[]; .noise_seconds > 0)' out
valid bench out
refuses '--noise' beadswim-bench --beads 150 --unsteady --noise
refuses '^beadswim-bench: --unsteady: ' beadswim-bench --unsteady
refuses '^beadswim-bench: --multipole-order: ' beadswim-bench --beads 90 --multipole-order 3
run mpirun -n 2 beadswim-bench --json --beads 90,1500 --rounds 1 --tolerance 1e-3
has_status 0
cp out products.json
check "a product each of two sizes, surroundings and ranks" \
  holds '[.mobility_products[] | [.beads, .surroundings, .ranks]] | unique | length == 8' products.json
check "errors are what was asked for" holds '.mobility_products | (map(.error < 1e-3 and .seconds > 0) | all) and (map(select(.error != null)) | length == 6)' products.json
valid bench products.json
run beadswim-bench --beads 90 --rounds 1
has_status 0
out_has 'open'

refuses '--tolerance: the flag has no effect without --beads' beadswim-bench --tolerance 1e-3
refuses 'edge: the flag applies to the lattice only, but --beads measures mobility products; leave out the flag or --beads' beadswim-bench --beads 90 --edge 64
refuses '--edge: "16": the value must be a whole number from 32 to 4096' beadswim-bench --edge 16
refuses '--bead-boundary: unknown value "sphere". Valid values: staircase, cli, mr, psm' beadswim-bench --bead-boundary sphere
refuses '--precision: unknown value "half". Valid values: double, single' beadswim-bench --precision half
refuses 'did you mean --edge' beadswim-bench --egde 64
refuses 'GB that are free; use a smaller edge' beadswim-bench --edge 4096
finish
