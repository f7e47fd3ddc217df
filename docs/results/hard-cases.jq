# The table of docs/hard-cases.md from hard-cases.jsonl:  jq -rs -f hard-cases.jq hard-cases.jsonl
def percent: if . == null then "" else . * 1000 | round / 10 | if . > 0 then "+\(.)" else "\(.)" end end;
def over(other): if . == null or other == null or other == 0 then null else . / other - 1 end;
def errors: .cycle as $c | .reference.cycle as $r
  | if $c == null or $r == null then ""
    else [$c.speed_along_axis | over($r.speed_along_axis)]
      + [[$c.arm_amplitudes, $r.arm_amplitudes] | transpose[] | . as [$a, $b] | $a | over($b)] | map(percent) | join(", ") end;
def planned: .plan as $p | if $p == null then "" elif $p.refused then "refuses" elif $p.error == null then ""
  else [$p.error.velocity, $p.error.arm_amplitudes[]] | map(if . > 10 then "> 1000" else . * 1000 | round / 10 | tostring end) | join(", ") end;
def outcome: if .status == "finished" then "runs" + (if .warned then ", warns" else "" end) else .status end;
# Cases that the page shows, by group.
def shown: {
  "bead density": "^(0.1 times|0.[13], τ|100 times)",
  "contact at the start": "R/4, 4|0.1 R, 4|e-05 R, 4",
  "driving": "^A = 1.2|A = 10$",
  "narrow box": "^1[02] wide, 4",
  "places": "diagonal, across",
  "relaxation time": "^τ = (0.52|1.5|4|6|0.51, psm)$",
  "rest": "mr$",
  "small beads": "1 cells.*(mr|psm|staircase)$",
  "speed": "^A = (10|20|40),",
  "springs": "stiffness (times 1e[26]|1e9)|times 1e4, oblique",
  "turning over": "^3"}[.];
"| group | case | outcome | v, d1, d2: error [%] | expected by the plan [%] |", "|---|---|---|---|---|",
(group_by(.group)[] | map(select(.group as $group | .case | test($group | shown))) | to_entries[]
  | "| \(if .key == 0 then .value.group else "" end) | " + (.value
    | "\(.case | sub("cells a radius"; "cells per radius")) | \(outcome) | \(errors) | \(planned) |"))
