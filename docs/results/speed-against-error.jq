# Prints the tables of docs/speed-against-error.md:
#   speed-against-error-tables.sh FOLDER [CELLS]
# The second table has the lattice runs with $cells cells per radius and without levels, or all of them if $cells is null. Runs in
# single precision have a row of their own only if a scene was run in both precisions.
# Input: one object per scene, {title, runs: [records], reference: record}. Errors are root mean squares over
# swimmers, divided by that of the reference, and root mean squares of these over runs and arms; costs are medians, in core-seconds per cycle.
include "percentages";
def axial: .speed_along_axis - ([.mean_flow, .axis] | transpose | map(.[0] * .[1]) | add);
def rms: map(. * .) | mean | sqrt;
def norm: map(. * .) | add | sqrt;
def error($found; $reference): ([$found, $reference] | transpose | map(.[0] - .[1]) | norm) / ($reference | norm);
def cycle: .swimmers | map(.cycles[-1]);
def name: if .resolution then (.resolution | "`\(.bead_boundary)`, τ = \(.relaxation_time * 10 | round / 10), \(.cells_per_radius) cells"
      + (if .precision == "single" then ", single" else "" end) + (if (.levels | length) > 1 then ", levels" else "" end))
  else "`\(.model)`" + (.mobility.multipole_order | if . then ", order \(.)" else "" end) end;
def rank: if .resolution then .resolution | [1, ({"staircase": 1, "cli": 2, "psm": 3, "mr": 4}[.bead_boundary]), -(.relaxation_time * 10 | round), .precision, (.levels | length), .cells_per_radius]
  else [0, .model, .mobility.multipole_order] end;
def number: if . >= 9.95 then round else (if . >= 0.995 then 10 else 100 end) as $n | . * $n | round / $n end | tostring;
def percents: 100 * . | number;
# Returns the settings of a scene, each with its errors and its cost.
def settings: (.reference | cycle) as $reference | .runs | group_by(rank)
  | map({name: (.[0] | name), rank: (.[0] | rank),
         v: (map(error(cycle | map(axial); $reference | map(axial))) | rms),
         arms: (map(range(2) as $arm | error(cycle | map(.arm_amplitudes[$arm]); $reference | map(.arm_amplitudes[$arm]))) | rms),
         cost: (map(.cost.core_seconds / .swimmers[0].cycles[-1].index) | median)});
def uncertainty: (.reference.swimmers | map(.cycles[-1] | axial)) as $v
  | ([.reference.swimmers | map(.uncertainty.velocity.total), $v] | transpose | map(.[0] * .[1]) | norm) / ($v | norm);
def row: "| " + join(" | ") + " |";
def head: row, (map("---") | "|" + join("|") + "|");

map(. + {settings: settings, uncertainty: uncertainty}) as $scenes
| (["scene"] + ([10, 3, 1, 0.3] | map("\(.) %")) + ["uncertainty of the reference"] | head),
  ($scenes[] | [.title] + (. as $scene | [0.1, 0.03, 0.01, 0.003] | map(. as $tolerance
      | (if $scene.uncertainty <= 1.5 * $tolerance then [$tolerance, $scene.uncertainty] | max else $tolerance end) as $limit
      | [$scene.settings[] | select(([.v, .arms] | max) <= $limit)] | min_by(.cost)
      | if . then "\(.name): \(.cost | number) s" + (if $limit > $tolerance then " (\($scene.uncertainty | percents) %)" else "" end)
        else "none" end)) + ["\(.uncertainty | percents) %"] | row),
  "",
  (["run"] + ($scenes | map(.title)) | head),
  ([$scenes[] | .title as $title | .settings[] | . + {title: $title} | select($cells == null or (.rank | .[0] == 0 or (.[-1] == $cells and .[-2] < 2)))]
    | group_by(.rank | if .[0] == 1 then del(.[3]) else . end)[]
    | if (map(.title) | unique | length) == length then . else group_by(.rank)[] end | sort_by(.rank) | . as $runs
    | [.[0].name | sub(", \($cells) cells"; "")] + ($scenes | map(.title as $title | [$runs[] | select(.title == $title)][0]
        | if . then "\(.v | percents), \(.arms | percents); \(.cost | number)" + (if .rank[3] != $runs[0].rank[3] then " (single)" else "" end) else "-" end)) | row)
