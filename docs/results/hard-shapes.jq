# Prints the table of docs/hard-cases.md from hard-shapes.jsonl:  jq -rs -f hard-shapes.jq hard-shapes.jsonl
# Errors: |v - reference| over |reference|; largest change of an arm amplitude over the largest amplitude. Amplitudes below 0.01
# bead radii (0.04), as those of stiff bonds, are not compared.
def norm: map(. * .) | add | sqrt;
def velocity: .cycle.velocity as $v | .reference.cycle.velocity as $r
  | if $v == null or $r == null or ($r | norm) == 0 then null else ([$v, $r] | transpose | map(.[0] - .[1]) | norm) / ($r | norm) end;
def stroke: (.cycle.arm_amplitudes // []) as $a | (.reference.cycle.arm_amplitudes // []) as $r
  | if $r == [] or $a == [] or ($r | max) < 0.04 then null else ([$a, $r] | transpose | map(.[0] - .[1] | fabs) | max) / ($r | max) end;
def percent: if . == null then "-" elif . < 5e-7 then "0" else 100 * . | (if . >= 10 then 1 elif . >= 1 then 10 elif . >= 0.1 then 100 else 10000 end) as $n
  | . * $n | round / $n | tostring end;
def outcome: if .status == "finished" then (if .warned then "warning" else "finished" end)
  else {refused: "rejected", "stopped-speed": "stopped: beads too fast", failed: "stopped: unphysical state"}[.status] end;
def row: "| \(.case)\(if .group == "collisions" then ": beads collide" else "" end) | `\(.flags | sub("--model "; "") | sub("--multipole-order "; "") | sub(" --.*"; ""))` | \(outcome) | \(velocity | percent), \(stroke | percent) | \(.reference.description // "-" | sub("8 times as many steps"; "finer steps")) |";
# False for cases that repeat others, and for rejected scenes, which the page lists in its text.
def is_shown: .status != "refused" and ([.group, .case, .flags] | map(tostring) | join(" ") | test("1e4 times.*(oseen|rpy )|1e8 times.*(oseen|rpy )|amplitude 1.5 .*multipole|gap of 0.1 radii, along|number (0.1|1|30) |chain of 64 beads|half-space .*lbm|hairpin|of 64 beads|four times a cycle|strong shear|stiffness 1e-6|dashpots of 1e4|into the wall|gaps of 0.01 radii|1, 4, 1.*order 1") | not);
"| case | model, order | outcome of the run | error of velocity, strokes [%] | reference |", "|---|---|---|---|---|", (group_by(.group)[][] | select(is_shown) | row)
