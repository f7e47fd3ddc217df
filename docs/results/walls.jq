# Table of docs/walls.md: velocities and angular velocities of the paper's swimmer over a wall, against multipole order 2. The last
# columns extrapolate the lattice's difference from the periods 24000 and 48000 to an infinite period, linear in its inverse.
#   jq -rs -f docs/results/walls.jq docs/results/walls.jsonl
def digits($n): . as $x | pow(10; $n) as $p | ($x * $p | round) / $p;
def signed: digits(1) as $value | if $value > 0 then "+\($value)" else "\($value)" end;
def percent($reference): 100 * (. / $reference - 1) | signed;

map(select(.model)) | group_by(.height_over_radius) | map(
  (map(select(.period == 48000) | {key: .model, value: .}) | from_entries) as $runs | $runs["multipole order 2"] as $best
  | (map(select(.period == 24000) | {key: .model, value: .}) | from_entries) as $short
  | def without_inertia(f): 2 * 100 * (($runs.lbm | f) / ($best | f) - 1) - 100 * (($short.lbm | f) / ($short["multipole order 2"] | f) - 1) | signed;
    "| \($best.height_over_radius) | \($best.velocity * 1e5 | digits(3)) | \($best.angular_velocity * 1e8 | digits(2)) | "
    + (["multipole order 1", "rpy+near", "rpy"] | map($runs[.].velocity | percent($best.velocity)) | join(" | ")) + " | "
    + (if $runs.lbm then ($runs.lbm.velocity | percent($best.velocity)) + " | " + ($runs.lbm.angular_velocity | percent($best.angular_velocity))
         + " | \(without_inertia(.velocity)), \(without_inertia(.angular_velocity))" else " |  | " end) + " |")
| ["| height/radius | v [10⁻⁵] | Ω [10⁻⁸] | order 1: v [%] | `rpy+near`: v [%] | `rpy`: v [%] | `lbm`: v [%] | `lbm`: Ω [%] | `lbm` without inertia: v, Ω [%] |", "|---|---|---|---|---|---|---|---|---|"] + . | .[]
