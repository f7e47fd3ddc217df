# A table of docs/speed-against-error.md, from the records of speed-against-error.sh and an extrapolated reference:
# errors from it, mean ± scatter over places within a cell, and core-seconds a cycle.
include "percentages";
$reference[0].predictions[0] as $r
| def v: .v / $r.velocity - 1; def d1: .d1 / $r.arm_amplitudes[0] - 1; def d2: .d2 / $r.arm_amplitudes[1] - 1;
"| model | τ | precision | cells a radius | v [%] | d1 [%] | d2 [%] | core s a cycle |",
"|---|---|---|---|---|---|---|---|",
(group_by([(.resolution.bead_boundary // "" | {"": 0, "staircase": 1, "cli": 2, "psm": 3, "mr": 4}[.]), .model,
           .resolution.precision, -(.resolution.relaxation_time // 0 | . * 10 | round), .resolution.cells_per_radius])[]
  | .[0] as $first | map(seen)
  | (if $first.resolution then
       $first.resolution | "| \(.bead_boundary) | \(.relaxation_time * 10 | round / 10) | \(.precision) | \(.cells_per_radius)"
     else "| `\($first.model)` | | |" end)
    + " | \(map(v) | percent_and_spread) | \(map(d1) | percent_and_spread) | \(map(d2) | percent_and_spread)"
    + " | \(map(.cost) | median | two_digits) |")
