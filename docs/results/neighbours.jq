# Prints the table of docs/swarms.md:  jq -rs -f docs/results/neighbours.jq neighbours.jsonl
# Means over both swimmers, T = 2000: along the axis; away from the other swimmer (equal phases) or of the second swimmer, ahead by pi/2.
def two: . * 100 | round / 100;
def cell($phase): . as $s | if $phase == 0 then "\(($s[0][0] + $s[1][0]) / 2 | two), \(($s[0][1] + $s[1][1]) / 2 | two)"
  else "\(($s[0][0] + $s[1][0]) / 2 | two), \(($s[1][1] - $s[0][1]) / 2 | two)" end;
def model: if startswith("--model") then .[8:] elif . == "theory" then . else "lbm" end;
"| distance of the axes [bead radius] | phase difference | `lbm`: along, sideways | theory | `rpy+near` | `rpy` |",
"|---|---|---|---|---|---|",
(map(select(.period == 2000)) | group_by(.phase)[] | group_by(.distance)[]
 | (map({(.flags | model): .}) | add) as $runs
 | "| \(.[0].distance) | \(if .[0].phase == 0 then "0" else "π/2" end) | \([$runs["lbm", "theory", "rpy+near", "rpy"] | .phase as $p | .swimmers | cell($p)] | join(" | ")) |")
