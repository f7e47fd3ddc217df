# Prints the tables of docs/speed-against-error.md from the records of speed-against-error.sh and an extrapolated reference:
# errors relative to the reference (v: mean ± standard deviation over positions within a cell) and core-seconds per cycle, for
# runs in double precision with τ up to 2 (bead boundaries other than mr: τ = 1.5).
include "percentages";
$reference[0].predictions[0] as $r
| def v: .v / $r.velocity - 1; def d2: .d2 / $r.arm_amplitudes[1] - 1;
def numbers: map(seen) | "\(map(v) | percent_and_spread), \(map(d2) | mean | percent); \(map(.cost) | median | two_digits)";
def row: "| " + join(" | ") + " |";
map(select(.resolution == null)) as $models
| map(select(.resolution | .precision == "double" and .cells_per_radius <= 6 and .relaxation_time < 2.5
    and (.bead_boundary == "mr" or .relaxation_time > 1.2))) as $lattices
| ($lattices | map(.resolution.cells_per_radius) | unique) as $cells
| "| mobility model | error of velocity v, arm amplitude d2 [%]; core-seconds per cycle |", "|---|---|",
($models | group_by([.model, .mobility.multipole_order])[]
  | ["`\(.[0].model)`" + (.[0].mobility.multipole_order | if . then ", order \(.)" else "" end), numbers] | row),
(["bead boundary, relaxation time τ"] + ($cells | map("\(.) cells per radius") | .[0] += ": error of v ± SD, d2 [%]; core-seconds per cycle") | row, (map("---") | "|" + join("|") + "|")),
($lattices | group_by([(.resolution.bead_boundary | {"staircase": 1, "cli": 2, "psm": 3, "mr": 4}[.]), -(.resolution.relaxation_time * 10 | round)])[]
  | . as $runs | ["\(.[0].resolution | "\(.bead_boundary), \(.relaxation_time * 10 | round / 10)")"]
    + ($cells | map(. as $n | $runs | map(select(.resolution.cells_per_radius == $n)) | if . == [] then "-" else numbers end)) | row)
