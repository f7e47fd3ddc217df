# The table of docs/resolution.md, from the records of resolution.sh.
def mean: add / length;
def spread: mean as $m | (map(. - $m | . * .) | add) / (length - 1) | sqrt;  # of one, not of the mean
def median: sort | (.[(length - 1) / 2 | floor] + .[length / 2 | floor]) / 2;
def two_digits: . * 100 | round | "\(. / 100 | floor).\("0\(. % 100)" | .[-2:])";
def percent: (if . < 0 then "-" else "+" end) + (100 * fabs | two_digits);
def percent_and_spread: "\(mean | percent)" + (if length > 1 then " ± \(100 * spread | two_digits)" else "" end);

# What a run says: velocity against the mean flow, strokes, sine of the phase shift, core seconds a cycle.
def seen: .swimmers[0].cycles[-1] as $c | {
  v: ($c.velocity[0] - $c.mean_flow[0]), d1: $c.arm_amplitudes[0], d2: $c.arm_amplitudes[1],
  sine: ($c.arm_phases[0] - $c.arm_phases[1] | sin), cost: (.cost.core_seconds / $c.index) };
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
