# Prints the table of docs/fluid-inertia.md:
#   jq -rn -f memory-scenes.jq --slurpfile lattice memory-scenes-lattice.jsonl --slurpfile models memory-scenes-models.jsonl
# The reference of a scene is extrapolated from runs with 3 and 5 cells per radius: the error is proportional to the square of the cell.
def extrapolated: [.runs[0].swimmers, .runs[1].swimmers] | transpose | map(transpose | map(.[1] + (.[1] - .[0]) * 9 / 16));
def error($found; $reference; $from; $to):
  [$found, $reference] | transpose | map([.[0][$from:$to], .[1][$from:$to]] | transpose[])
  | (map((.[0] - .[1]) * (.[0] - .[1])) | add) / (map(.[1] * .[1]) | add) | sqrt * 100;
def digits($n): pow(10; $n) as $p | . * $p | round / $p | tostring;
def both($found; $reference): "\(error($found; $reference; 0; 3) | digits(1)), \(error($found; $reference; 3; 5) | digits(2))";
"| period, swimmers | lattice, 5 cells per radius | `rpy` | `rpy+near` | `multipole`, order 2 | `unsteady`, order 0 | order 1 | order 2 | order 2 without Reynolds stress |",
"|---|---|---|---|---|---|---|---|---|",
(range($lattice | length) | $lattice[.] as $l | $models[.] as $m | ($l | extrapolated) as $reference
  | ["\($l.period), \($l.swimmers)", both($l.runs[1].swimmers; $reference), ($m.runs[] | both(.swimmers; $reference))]
  | "| \(join(" | ")) |"),
"| core-seconds | \([$lattice[].runs[1].core_seconds] | min | round) to \([$lattice[].runs[1].core_seconds] | max | round) | \([range(7) as $k | [$models[].runs[$k].core_seconds] | "\(min | digits(1)) to \(max | digits(1))"] | join(" | ")) |"
