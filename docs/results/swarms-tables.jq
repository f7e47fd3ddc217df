# The tables of docs/swarm-figures.md, from all records of swarms.sh, slurped.
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p | if . == 0 then 0 else . end;
def row: "| " + (map(tostring) | join(" | ")) + " |";
def table($head): [($head | row), ($head | map("---") | row)] + map(row) | .[];
def bound: if . == 0 then "0" elif . < 1e-6 then "< 1e-6" else rounded(4) end;
def setting: "\(.cells_per_radius), \(.precision)";
def outcome: if .status == "finished" then "\(.cycles)" else "\(.cycles), then \(.status)" end;
def at_cycle($n): .kept_cycles | index($n);
def end_of(f): f | .[-1];
# In degrees, of the sine.
def degrees: . * 57.29578;
def largest_tilt: map(fabs) | max | degrees | rounded(2);
# How often the sign changes, where a twentieth of the largest and less has none.
def turns: (map(fabs) | max / 20) as $least | [.[] | select(fabs > $least) | . > 0] | [.[:-1], .[1:]] | transpose
  | map(select(.[0] != .[1])) | length;

(map(select(.swimmers == 1 or (.name | startswith("nine"))))) as $uniform
| (map(select(.swimmers == 9 and (.name | startswith("nine") | not)))) as $defect
| "",
"### The uniform swarm",
"",
($uniform | map([.name, setting, outcome,
   (.paths["0"].velocity_x | (.mean, .least, .most) | . * 1e5 | rounded(2)),
   (.largest | (.y | bound), (.z | bound), (.tilt | degrees | bound)), 
   (.off_the_lattice | if . then (.at_start, .at_end | map(tostring) | join(", ")) else ("", "") end)])
 | table(["run", "cells a radius", "cycles", "v_x [1e-5], mean from the third cycle on", "least", "most", "largest \\|y\\|", "largest \\|z\\|",
          "largest tilt [°]", "off the lattice at the start: x, y, z", "at the end"])),
"",
"### The defect swarm",
"",
($defect | map(
   if .cycles == 0 then [.name, setting, outcome] + [range(8) | ""] else
   [.name, setting, outcome,
   ((.paths["0"], .paths["3"], .paths["4"]) | .velocity_x.mean * 1e5 | rounded(1)),
   (end_of(.paths["0"].x) - end_of(.paths["3"].x) | rounded(2)),
   (end_of(.paths["0"].z) | rounded(2)), (end_of(.paths["3"].y) | rounded(2)),
   (.paths["0"].tilt_z | "\(largest_tilt), \(turns)"),
   (.paths["3"].tilt_y | "\(largest_tilt), \(turns)")] end)
 | table(["run", "cells a radius", "cycles", "v_x of A [1e-5]", "B", "centre", "x of A less B", "z of A", "y of B",
          "A in x-z: largest tilt [°], changes of sign", "B in x-y"])),
"",
"### Symmetries",
"",
($defect | map(select(.cycles > 0) | [.name, setting,
   ([.paths["0"].y, .paths["0"].z] | transpose | map(.[0] - .[1] | fabs) | max | bound),
   (.paths["3"].z | map(fabs) | max | bound), (.paths["3"].tilt_z | largest_tilt),
   (.paths["4"] | (.y, .z) | map(fabs) | max | bound)])
 | table(["run", "cells a radius", "A: y and z apart", "B: largest \\|z\\|", "B: largest tilt in x-z [°]", "centre: largest \\|y\\|", "\\|z\\|"])),
"",
"### Resolution",
"",
($defect | map(select(.name == "reference") | (8, 20) as $n | at_cycle($n) as $i | select($i) | [setting, $n,
   (.paths["0"].x[$i], .paths["3"].x[$i], .paths["4"].x[$i], .paths["0"].z[$i], .paths["3"].y[$i] | rounded(3)),
   (.paths["0"].tilt_z[$i], .paths["3"].tilt_y[$i] | degrees | rounded(3))])
 | table(["cells a radius", "after cycle", "x of A", "x of B", "x of the centre", "z of A", "y of B", "tilt of A in x-z [°]", "tilt of B in x-y [°]"]))
