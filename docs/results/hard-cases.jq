# Prints the table of docs/hard-cases.md from hard-cases.jsonl:  jq -rs -f hard-cases.jq hard-cases.jsonl
def percent: if . == null then "" else . * 1000 | round / 10 | if . > 0 then "+\(.)" elif . == 0 then "0" else "\(.)" end end;
def over(other): if . == null or other == null or other == 0 then null else . / other - 1 end;
def errors: .cycle as $c | .reference.cycle as $r
  | if $c == null or $r == null then (if $c == null then "no result" else "no reference" end)
    else [$c.speed_along_axis | over($r.speed_along_axis)]
      + [[$c.arm_amplitudes, $r.arm_amplitudes] | transpose[] | . as [$a, $b] | $a | over($b)] | map(percent) | join(", ") end;
def planned: .plan as $p | if $p == null then "no plan" elif $p.refused then "rejected" elif $p.error == null then "not estimated"
  else [$p.error.velocity, $p.error.arm_amplitudes[]] | map(if . > 10 then "> 1000" else . * 1000 | round / 10 | tostring end) | join(", ") end;
def outcome: if .status == "finished" then (if .warned then "warning" else "finished" end)
  else {refused: "rejected at the start", "stopped-speed": "stopped: beads too fast", failed: "stopped: unphysical state"}[.status] end;
# Describes a case so that its row can be read alone.
def described: sub("^(?<n>0.1|100) times the fluid's"; "\(.n) times the fluid density") | sub("^A = "; "amplitude A = ") | sub(", T = "; ", period T = ") | sub("cells a radius"; "cells per radius") | sub("^1 cells"; "1 cell") | sub("^(?<n>0[.][13]), τ"; "\(.n) times the fluid density, τ")
  | sub("^(?<n>[0-9]+) wide"; "periodic box of width \(.n)") | sub("^stiffness times (?<n>.*)"; "\(.n) times the preset's spring stiffness")
  | sub("^angular spring times (?<n>[^,]*), oblique"; "\(.n) times the preset's angular stiffness, oblique axis")
  | sub("^along a diagonal, across the corner"; "axis along a diagonal, beads across a corner of the box");
# Regular expressions of the cases that the page shows, by group.
def shown: {
  "bead density": "^(0.1, τ|100 times)",
  "contact at the start": "R/4, 4|e-05 R, 4",
  "driving": "^A = 1.2|A = 10$",
  "levels of cells": "^τ = 4$|20, T",
  "narrow box": "^1[02] wide, 4",
  "places": "diagonal, across",
  "relaxation time": "^τ = (0.52|4)$",
  "rest": "^$",
  "small beads": "1 cells.*(mr|psm|staircase)$",
  "speed": "^A = 40,",
  "springs": "stiffness times 1e6|times 1e4, oblique",
  "turning over": "^3"}[.];
"| group | case | outcome of the run | measured error of velocity v, arm amplitudes d1, d2 [%] | error of v, d1, d2 expected by `--plan` [%] |", "|---|---|---|---|---|",
(group_by(.group)[][] | select(.group as $group | .case | test($group | shown))
  | "| \(.group | {"places": "position in the box", "rest": "no driving", "speed": "fast beads", "turning over": "swimmer turns over"}[.] // .) | \(.case | described) | \(outcome) | \(errors) | \(planned) |")
