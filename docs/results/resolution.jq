# Prints the table of docs/resolution.md from the records of resolution.sh: runs at τ = 1.5 in double precision, with and without
# corrections. docs/speed-against-error.md has the other settings.
include "percentages";
def errors($quantity): map(seen[$quantity] / ($reference[0] | seen[$quantity]) - 1);
def numbers: [("v", "d1") as $q | errors($q) | percent_and_spread] + [errors("sine") | mean | percent] | join(", ");
def row: "| " + join(" | ") + " |";

map(select(.resolution | .precision == "double" and .relaxation_time == 1.5 and .cells_per_radius <= 4))
| (map(.resolution.cells_per_radius) | unique) as $cells
| (["bead boundary", "corrections of radius and delay"] + ($cells | map("\(.) cells per radius") | .[0] += ": error of v ± SD, d1 ± SD, sin β [%]") | row, (map("---") | "|" + join("|") + "|")),
(group_by([(.resolution.bead_boundary | {"staircase": 0, "cli": 1, "psm": 2, "mr": 3}[.]), .resolution.density_on_lattice != 1])[]
  | . as $runs | .[0].resolution as $r
  | [$r.bead_boundary, (if $r.density_on_lattice == 1 then "off" else "on" end)]
    + ($cells | map(. as $n | $runs | map(select(.resolution.cells_per_radius == $n)) | numbers)) | row)
