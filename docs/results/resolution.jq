# The table of docs/resolution.md, from the records of resolution.sh.
include "percentages";
def errors($quantity): map(seen[$quantity] / ($reference[0] | seen[$quantity]) - 1) | percent_and_spread;

"| bead boundary | τ | precision | corrections | cells a radius | v [%] | d1 [%] | d2 [%] | sin β [%] | core s a cycle |",
"|---|---|---|---|---|---|---|---|---|---|",
(group_by([(.resolution.bead_boundary | {"staircase": 0, "cli": 1, "psm": 2, "mr": 3}[.]),
           .resolution.density_on_lattice != 1, .resolution.precision, -(.resolution.relaxation_time * 10 | round),
           .resolution.cells_per_radius])[]
  | .[0].resolution as $r
  | "| \($r.bead_boundary) | \($r.relaxation_time * 10 | round / 10) | \($r.precision) | "
    + (if $r.density_on_lattice == 1 then "off" else "on" end)
    + " | \($r.cells_per_radius) | \(errors("v")) | \(errors("d1")) | \(errors("d2")) | \(errors("sine")) | "
    + "\(map(seen.cost) | median | two_digits) |")
