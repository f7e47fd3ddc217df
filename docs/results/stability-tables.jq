# Prints the tables of docs/swarm-stability.md from all records of stability.sh (jq -s).
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p | if . == 0 then 0 else . end;
def row: "| " + (map(tostring) | join(" | ")) + " |";
def table($head): [($head | row), "|" + ($head | map("---|") | add)] + map(row) | .[];
def rms: map(. * .) | add / length | sqrt;
def both: map(tostring) | join(", ");
def words: sub("abreast"; "swimmers side by side") | sub("ahead"; "ahead by 1e-3") | sub("k = "; "stiffness ");
# Returns the growth rate: the least-squares slope of ln y against the cycle.
def growth($cycles; $y): [$cycles, ($y | map(log))] | transpose
  | (map(.[0]) | add / length) as $a | (map(.[1]) | add / length) as $b
  | (map((.[0] - $a) * (.[1] - $b)) | add) / (map(.[0] - $a | . * .) | add);
def rate($y): [[.kept, $y] | transpose[] | select(.[0] >= 10)] | transpose | growth(.[0]; .[1]) | rounded(3);
# Returns the amplitude of a mode at the stored cycles, as root mean square over equivalent pairs of wave and axis.
def mode(pairs): .modes as $modes | [pairs] as $pairs
  | [range(1; .modes_kept | length) as $i | [$pairs[] as [$wave, $axis] | $modes[] | select(.wave == $wave) | .amplitudes[$i][$axis]] | rms];
# Returns the growth rate of a mode from cycle 5 to the end, or until the amplitude has fallen to a tenth: below that, modes
# that the lattice mixes in are as large.
def mode_rate(pairs): .modes_kept[1:] as $cycles | mode(pairs) as $y
  | if $y == [] or ($y[0] == null) or $y[0] == 0 then null else
    ([range($y | length) | select(. < 2 or ($y[:. + 1] | min) > 0.1 * $y[0])] | last + 1) as $n
    | growth($cycles[:$n]; $y[:$n]) end;
# Returns the growth rate of a mode in the second half of the run.
def late_rate(pairs): (.modes_kept[-1] / 2) as $from | ([.modes_kept[1:] | to_entries[] | select(.value >= $from) | .key]) as $at
  | .modes_kept[1:] as $cycles | [pairs] as $pairs
  | ([.modes[].wave]) as $waves | ([$pairs[] | select(.[0] as $w | $waves | index([$w]))]) as $here
  | if $here == [] then "" else mode($here[]) as $y
    | if any($at[]; $y[.] == 0) then "" else growth([$at[] | $cycles[.]]; [$at[] | $y[.]]) | rounded(3) end end;
def against($mean): if . == null then "" else . - $mean | rounded(3) end;

(map(select(.off and (.phases | not) and (.name | test("^[0-9]+ (swimmers|abreast)"))))) as $moved
| (map(select(.name | test("D_x")))) as $map
| "",
"### Several swimmers",
"",
($moved | map(select(.name | test("^((8|27) swimmers|16 abreast), k = [0-9.]+(, seed 1)?$"))
   | . as $run | [(.name | words), .cycles]
     + [$run.off.x, $run.off.across | . as $y | $run | rate($y)])
 | table(["run", "cycles", "growth rate of departure per cycle along x", "across x"])),
"",
"### Modes across x",
"",
($moved | map(select(.name | test("^8 swimmers, k = [0-9.]+, seed 1$"))
   | (mode_rate(["000", 1], ["000", 2])) as $mean
   | [.stiffness, ($mean | rounded(3))]
     + ([mode_rate(["010", 1], ["001", 2]), mode_rate(["010", 2], ["001", 1]), mode_rate(["100", 1], ["100", 2]),
         mode_rate(["110", 1], ["101", 2]), mode_rate(["110", 2], ["101", 1]), mode_rate(["011", 1], ["011", 2]),
         mode_rate(["111", 1], ["111", 2])] | map(against($mean))))
 | table(["stiffness", "growth rate per cycle: mean displacement", "mode 010 close up (relative to mean)", "mode 010 shear", "mode 100", "mode 110 close up", "mode 110 shear", "mode 011", "mode 111"])),
"",
"### Modes along x",
"",
("Two swimmers side by side, one ahead by 1e-3. With eight swimmers the growth rate at 3 cells per radius is " +
  ($moved | map(select(.modes and (.name | test("^8 swimmers, k = [0-9.]+, seed 1$")))
    | "\(late_rate(["010", 0], ["001", 0])) (stiffness \(.stiffness))") | join(" and ")) + "."),
"",
($moved | map(select(.modes and (.name | test("one ahead, k = 0.(2|0347)$")))
   | [.stiffness, .cells_per_radius, late_rate(["010", 0], ["001", 0])])
 | table(["stiffness", "cells per radius", "growth rate per cycle of mode 010"])),
"",
"### Other gaps",
"",
($map | map(select(.name | test("C = 24, D_x = 16, D_y = 46|C = 36, D_x = 16"))
   | [.stiffness, (.name | capture("C = (?<c>[0-9]+), D_x = (?<x>[0-9]+), D_y = (?<y>[0-9]+)") | "\(.c), \(.x), \(.y)"),
      ([.off.across[0, -1] | rounded(3)] | both), (.off.x[-1] | rounded(2)), (.smallest_gap // ""),
      ([if .status != "finished" then .status else empty end,
          if .off.across[-1] < 0.8 * .off.across[0] then
            if .off.across[-1] > 1.25 * (.off.across | min) then "distances equalise, separate again" else "distances equalise" end
          elif .off.across[-1] > 1.25 * .off.across[0] then "breaks up" else "distances stay unequal" end,
          if .off.x[-1] > 1 then "rows shift along x" else empty end, if .off.tilt[-1] > 0.0873 then "turns" else empty end] | join(", "))])
 | table(["stiffness", "distances C, D_x, D_y", "departure from equal distances across x: start, end", "departure along x at the end", "smallest bead gap", "outcome"]))
