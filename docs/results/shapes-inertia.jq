# Prints the table of docs/method/motion-of-shapes.md:  jq -rs -f docs/results/shapes-inertia.jq shapes-inertia.jsonl
# Means over the second and third cycle, divided by those of rpy in the same box; rotation of the triangle, displacement of three beads.
def motion: (if .kind == "triangle" then .turn else .displacement end) | if type == "array" then (.[1] + .[2]) / 2 else . end;
def three: . * 1000 | round / 1000;
def run($kind; $flags; $box): map(select(.kind == $kind and .flags == $flags and ((.box == "--unbounded") == ($box == "--unbounded")))) | first | motion;
def theory($kind): map(select(.kind == $kind and .theory)) | (.[1] | motion) / (.[0] | motion);
def lattice($kind; $cells; $period): . as $all | map(select(.kind == $kind and .period == $period
    and .flags == "--model lbm --cells-per-radius \($cells) --relaxation-time 1")) | first | motion / ($all | run($kind; "--model rpy"; "box")) | three;
def near($kind): run($kind; "--model rpy+near"; "--unbounded") / run($kind; "--model rpy"; "--unbounded") | three;
["triangle", "prescribed-three-bead"] as $kinds | . as $all |
"| Divided by `rpy` | Rotation of a triangle: 2, 3 cells per radius | Displacement of three beads: 2, 3 cells per radius |",
"|---|---|---|",
((2400, 4800, 9600, 19200) as $period | "| lattice, T = \($period), δ = \($period / 9600 * 2.546 | sqrt * 100 | round / 100) arm lengths | \([$kinds[] as $kind |
  [2, 3] | map(. as $cells | $all | lattice($kind; $cells; $period)) | join(", ")] | join(" | ")) |"),
"| theory: beads that resist strain | \($kinds | map(. as $kind | $all | theory($kind) | three) | join(" | ")) |",
"| `rpy+near`, exact for beads on a line | \($kinds | map(. as $kind | $all | near($kind)) | join(" | ")) |"
