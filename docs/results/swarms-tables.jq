# Prints the tables of docs/swarm-figures.md from all records of swarms.sh (jq -s).
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p | if . == 0 then 0 else . end;
def row: "| " + (map(tostring) | join(" | ")) + " |";
def table($head): [($head | row), "|" + ($head | map("---|") | add)] + map(row) | .[];
def bound: if . == 0 then "0" elif . < 1e-6 then "< 1e-6" else rounded(4) end;
def setting: "\(.cells_per_radius), \(.precision)";
def words: sub("^one cell"; "one swimmer in its unit cell") | sub("^nine, each moved by"; "nine swimmers, each displaced by") | sub("^reference"; "k = 0.2") | sub("k = "; "stiffness ");
def run: if .status == "finished" then .name | words else "\(.name), \(.status)" end;
def end_of(f): f | .[-1];
# Converts the sine of a small angle to the angle in degrees.
def degrees: . * 57.29578;
def largest_tilt: map(fabs) | max | degrees | rounded(2);
# Counts changes of sign; values up to a twentieth of the largest do not count.
def turns: (map(fabs) | max / 20) as $least | [.[] | select(fabs > $least) | . > 0] | [.[:-1], .[1:]] | transpose
  | map(select(.[0] != .[1])) | length;

# Returns velocities, displacements and tilts of A and B, as text.
def of_a_and_b: .paths | [.["0"], .["3"]] as [$a, $b]
  | [([$a, $b] | map(.velocity_x.mean * 1e5 | rounded(1) | tostring) | join(", ")),
     ([end_of($a.z), end_of($b.y)] | map(rounded(2) | tostring) | join(", ")),
     ([($a.tilt_z | largest_tilt), ($b.tilt_y | largest_tilt)] | map(tostring) | join(", "))];
# Returns the row of a model from its three runs: one cell, defect swarm with stiff and with soft springs.
def inertia_row($model; $cell; $stiff; $soft): [$model, ($cell.paths["0"].velocity_x.mean * 1e5 | rounded(2))] + ($stiff | of_a_and_b) + ($soft | of_a_and_b);

def shown: IN("reference", "k = 0.0347", "staircase beads");  # selects the runs of the table

. as $all
| (map(select((.swimmers == 1 or (.name | startswith("nine, "))) and .cells_per_radius >= 3))) as $uniform
| (map(select(.swimmers == 9 and (.name | startswith("nine") | not)))) as $defect
| "",
"### Uniform swarm",
"",
($uniform | map([run, setting,
   (.paths["0"].velocity_x | [.mean, .least, .most] | map(. * 1e5 | rounded(2) | tostring) | join(", ")),
   (.largest | ([.y, .z] | map(bound | tostring) | join(", ")), (.tilt | degrees | bound)),
   (.off_the_lattice | if . then .at_end | map(tostring) | join(", ") else "-" end)])
 | table(["run", "cells per radius, precision", "velocity of swimmer 0 along x [1e-5 cell/step]: mean, min, max over cycles", "max displacement of a swimmer: \\|y\\|, \\|z\\|", "max tilt [°]", "rms distance from regular sites at the end: x, y, z"])),
"",
"### Defect swarm",
"",
($defect | map(select(.name | shown) | select(.name != "k = 0.0347" or .cells_per_radius == 3)
   | [run, .cells_per_radius, ([.paths["0", "3", "4"].velocity_x.mean * 1e5 | rounded(1) | tostring] | join(", ")),
      (end_of(.paths["0"].x) - end_of(.paths["3"].x) | rounded(2)),
      ([end_of(.paths["0"].z), end_of(.paths["3"].y)] | map(rounded(2) | tostring) | join(", ")),
      (.paths["0"].tilt_z | "\(largest_tilt), \(turns)"),
      (.paths["3"].tilt_y | "\(largest_tilt), \(turns)")])
 | table(["run", "cells per radius", "mean velocity along x [1e-5 cell/step] of A, B, swimmer at block centre", "displacement along x, A minus B", "displacement of A along z, of B along y",
          "tilt of A in x-z: max [°], number of sign changes", "tilt of B in x-y: max [°], number of sign changes"])),
"",
"### Inertia or finite size",
"",
([inertia_row("lattice, 6 cells per radius (softer springs: 3)"; ($all[] | select(.name == "one cell" and .cells_per_radius == 6));
   ($all[] | select(.name == "reference" and .cells_per_radius == 6)); ($all[] | select(.name == "k = 0.0347" and .cells_per_radius == 3)))]
  + [$all[] | .name | select(startswith("one cell, ") and (contains("0.0347") | not)) | sub("one cell, "; "") | . as $model
     | inertia_row("`\($model | sub(" --reynolds"; "`, `--reynolds"))`"; ($all[] | select(.name == "one cell, \($model)"));
         ($all[] | select(.name == "k = 0.2, \($model)")); ($all[] | select(.name == "k = 0.0347, \($model)")))]
 | table(["model", "uniform swarm: velocity [1e-5]", "defect swarm: velocity of A, B [1e-5]", "displacement of A along z, of B along y", "max tilt of A in x-z, of B in x-y [°]",
          "stiffness 0.0347: velocity of A, B", "displacement of A along z, of B along y", "max tilt of A, of B [°]"]))
