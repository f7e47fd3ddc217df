# The tables of docs/swarm-figures.md, from all records of swarms.sh, slurped.
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p | if . == 0 then 0 else . end;
def row: "| " + (map(tostring) | join(" | ")) + " |";
def table($head): [($head | row), ($head | map("---") | row)] + map(row) | .[];
def bound: if . == 0 then "0" elif . < 1e-6 then "< 1e-6" else rounded(4) end;
def setting: "\(.cells_per_radius), \(.precision)";
def run: if .status == "finished" then .name else "\(.name), \(.status)" end;
def end_of(f): f | .[-1];
# Angle in degrees from its sine.
def degrees: . * 57.29578;
def largest_tilt: map(fabs) | max | degrees | rounded(2);
# Number of changes of sign; values up to a twentieth of the largest do not count.
def turns: (map(fabs) | max / 20) as $least | [.[] | select(fabs > $least) | . > 0] | [.[:-1], .[1:]] | transpose
  | map(select(.[0] != .[1])) | length;

def shown: IN("reference", "k = 0.0347", "k = 0.1", "staircase beads");  # runs in the table

(map(select((.swimmers == 1 or (.name | startswith("nine, "))) and .cells_per_radius >= 3))) as $uniform
| (map(select(.swimmers == 9 and (.name | startswith("nine") | not)))) as $defect
| "",
"### Uniform swarm",
"",
($uniform | map([run, setting,
   (.paths["0"].velocity_x | [.mean, .least, .most] | map(. * 1e5 | rounded(2) | tostring) | join(", ")),
   (.largest | ([.y, .z] | map(bound | tostring) | join(", ")), (.tilt | degrees | bound)),
   (.off_the_lattice | if . then .at_end | map(tostring) | join(", ") else "" end)])
 | table(["run", "cells per radius", "v_x [1e-5]: mean, min, max", "max displacement: \\|y\\|, \\|z\\|", "max tilt [°]", "distance from regular sites at the end: x, y, z"])),
"",
"### Defect swarm",
"",
($defect | map(select(.name | shown) | select(.name != "k = 0.0347" or .cells_per_radius == 3)
   | [run, .cells_per_radius, ([.paths["0", "3", "4"].velocity_x.mean * 1e5 | rounded(1) | tostring] | join(", ")),
      (end_of(.paths["0"].x) - end_of(.paths["3"].x) | rounded(2)),
      ([end_of(.paths["0"].z), end_of(.paths["3"].y)] | map(rounded(2) | tostring) | join(", ")),
      (.paths["0"].tilt_z | "\(largest_tilt), \(turns)"),
      (.paths["3"].tilt_y | "\(largest_tilt), \(turns)")])
 | table(["run", "cells per radius", "v_x [1e-5]: A, B, block centre", "x of A minus x of B", "z of A, y of B",
          "tilt of A in x-z: max [°], changes of sign", "tilt of B in x-y: max [°], changes of sign"])),
"",
"### Symmetry",
"",
($defect | map(select(.cells_per_radius >= 3 and [.name, .cells_per_radius] != ["reference", 3]) | [run, .cells_per_radius,
   ([.paths["0"].y, .paths["0"].z] | transpose | map(.[0] - .[1] | fabs) | max | bound),
   (.paths["3"].z | map(fabs) | max | bound)])
 | table(["run", "cells per radius", "A: max \\|y - z\\|", "B: max \\|z\\|"]))
