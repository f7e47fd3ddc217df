# The tables of docs/swarm-stability.md, from all records of stability.sh, slurped.
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p | if . == 0 then 0 else . end;
def row: "| " + (map(tostring) | join(" | ")) + " |";
def table($head): [($head | row), ($head | map("---") | row)] + map(row) | .[];
def rms: map(. * .) | add / length | sqrt;
def setting: "\(.cells_per_radius), \(.precision)";
def small: if . == 0 then "0" elif . < 1e-9 then "< 1e-9" else "\(.)" end;
# Slope of ln y against the cycle, by least squares.
def growth($cycles; $y): [$cycles, ($y | map(log))] | transpose
  | (map(.[0]) | add / length) as $a | (map(.[1]) | add / length) as $b
  | (map((.[0] - $a) * (.[1] - $b)) | add) / (map(.[0] - $a | . * .) | add);
def rate($y): [[.kept, $y] | transpose[] | select(.[0] >= 10)] | transpose | growth(.[0]; .[1]) | rounded(3);
# A mode's size at the kept cycles: c lists pairs of wave and axis, alike by symmetry.
def mode(pairs): .modes as $modes | [pairs] as $pairs
  | [range(1; .modes_kept | length) as $i | [$pairs[] as [$wave, $axis] | $modes[] | select(.wave == $wave) | .amplitudes[$i][$axis]] | rms];
# From cycle 5 to the end, or until a tenth is left, where other modes that beads' places within cells mix in are as large.
def mode_rate(pairs): .modes_kept[1:] as $cycles | mode(pairs) as $y
  | if $y == [] or ($y[0] == null) or $y[0] == 0 then null else
    ([range($y | length) | select(. < 2 or ($y[:. + 1] | min) > 0.1 * $y[0])] | last + 1) as $n
    | growth($cycles[:$n]; $y[:$n]) end;
# In the second half of the run.
def late_rate(pairs): (.modes_kept[-1] / 2) as $from | ([.modes_kept[1:] | to_entries[] | select(.value >= $from) | .key]) as $at
  | .modes_kept[1:] as $cycles | [pairs] as $pairs
  | ([.modes[].wave]) as $waves | ([$pairs[] | select(.[0] as $w | $waves | index([$w]))]) as $here
  | if $here == [] then "" else mode($here[]) as $y
    | if any($at[]; $y[.] == 0) then "" else growth([$at[] | $cycles[.]]; [$at[] | $y[.]]) | rounded(3) end end;
def against($mean): if . == null then "" else . - $mean | rounded(3) end;

(map(select(.off and (.phases | not) and (.name | test("^[0-9]+ (swimmers|abreast|in a row)"))))) as $moved
| (map(select(.name | test("D_x")))) as $map
| (map(select(.phases))) as $phases
| "",
"### Departures from the lattice",
"",
($moved | map([.name, setting, .cycles, (.off.x[0, -1], .off.across[0, -1], .off.tilt[-1] | small)]
   + (if .off.across[-1] < 1e-7 then ["", ""] else . as $run | [$run.off.x, $run.off.across | . as $y | $run | rate($y)] end))
 | table(["run", "cells a radius", "cycles", "off along x, at the start", "at the end", "off across x, at the start", "at the end", "tilt at the end",
          "rate along x", "rate across x"])),
"",
"### Modes across x",
"",
($moved | map(select(.modes and .modes_kept[-1] >= 20 and .off.across[-1] > 1e-7)
   | (mode_rate(["000", 1], ["000", 2])) as $mean
   | [.name, setting, "5 to \(.modes_kept[-1])", ($mean | rounded(3))]
     + (if .swimmers == 8 then
          [mode_rate(["010", 1], ["001", 2]), mode_rate(["010", 2], ["001", 1]), mode_rate(["100", 1], ["100", 2]),
           mode_rate(["110", 1], ["101", 2]), mode_rate(["110", 2], ["101", 1]), mode_rate(["011", 1], ["011", 2]),
           mode_rate(["111", 1], ["111", 2])]
        else [mode_rate(["010", 1]), mode_rate(["010", 2]), null, null, null, null, null] end | map(against($mean))))
 | table(["run", "cells a radius", "cycles", "mean of all", "rows close up", "rows shear", "100", "110 close up", "110 shear", "011", "111"])),
"",
"### Modes along x",
"",
($moved | map(select(.modes and .modes_kept[-1] >= 20 and .off.x[-1] > 1e-7)
   | [.name, setting, "\(.modes_kept[-1] / 2) to \(.modes_kept[-1])"]
     + [late_rate(["010", 0], ["001", 0]), late_rate(["100", 0]), late_rate(["110", 0], ["101", 0]), late_rate(["011", 0]), late_rate(["111", 0])])
 | table(["run", "cells a radius", "cycles", "010", "100", "110", "011", "111"])),
"",
"### Other gaps",
"",
($map | map([.stiffness, (.name | capture("C = (?<c>[0-9]+), D_x = (?<x>[0-9]+), D_y = (?<y>[0-9]+)") | .c, .x, .y),
     (if .status == "finished" then "\(.cycles)" else "\(.cycles), then \(.status)" end)]
   + (if .cycles < 2 then [range(7) | ""] else
     [(.off.across[0], (.off.across | min), .off.across[-1] | rounded(3)), (.off.x[-1] | rounded(2)), (.off.tilt[-1] * 57.29578 | rounded(2)), (.smallest_gap // ""),
      # Departures of 0.01 from even rows the lattice itself may change by exp(0.05 x 20).
      (if .off.across[0] < 0.1 then [0.37, 2.7] else [0.8, 1.25] end) as [$less, $more]
      | ([if .off.across[-1] < $less * .off.across[0] then
           if .off.across[-1] > 1.25 * (.off.across | min) then "heals, parts again" else "heals" end elif .off.across[-1] > $more * .off.across[0] then "breaks up" else "stays" end,
        if .off.x[-1] > 1 then "shears" else empty end] + [if .off.tilt[-1] > 0.0873 then "turns" else empty end] | join(", "))] end))
 | table(["k", "C", "D_x", "D_y", "cycles", "off even rows at the start", "least", "at the end", "off along x at the end", "tilt [°]", "smallest gap",
          "outcome"])),
"",
"### Phases",
"",
(($phases | map(select(.name | startswith("all in step")) | {key: (.stiffness | tostring), value: .phases[-1]}) | from_entries) as $step
 | $phases | map($step[.stiffness | tostring] as $lone | . as $run
   | [.name, .cycles, (.orders[-1].driving // ""), (.orders[-1].arms | if . then map(tostring) | join(", ") else "" end)]
     + [.phases[] as $at | [0, 1 | . as $arm | $at.arms[$arm] | map(. - $lone.arms[$arm][0]) | map(fabs) | max | rounded(3) | tostring] | join(", ")]
     + [[0, 1 | . as $arm | [$run.phases[0].arms[$arm], $run.phases[1].arms[$arm]] | transpose | map(.[1] - .[0] | fabs) | max | rounded(3) | tostring] | join(", ")]
     + [([0, 1 | . as $arm | $run.phases[1].amplitudes[$arm] | if min == max then "\(min)" else "\(min) to \(max)" end] | join(", ")),
        (.velocity * 1e5 | rounded(1)), (if .off then (.off.x[-1], .off.across[-1] | rounded(2)) else "", "" end)])
 | table(["run", "cycles", "order of the drivings at the end", "of both arms", "largest pull after 5 cycles [rad], both arms", "at the end",
          "largest change between", "strokes", "v_x [1e-5]", "off along x at the end", "across"]))
