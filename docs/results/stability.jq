# Extracts the data for docs/swarm-stability.md from the run record of a swarm.
#   jq -c --arg name NAME --argjson exit STATUS --slurpfile layouts LAYOUT.json --slurpfile lattices LATTICE.json -f stability.jq RUN.json
# Lengths are in units of the layout. A departure is the displacement of a swimmer from its regular site, minus the mean
# displacement. "off" contains root mean squares over swimmers: departures along x and across x, and tilts of axes from the mean.
def significant: if . == 0 then 0 else pow(10; 3 - (fabs | log10 | floor)) as $p | . * $p | round / $p end;
def rms: map(. * .) | add / length | sqrt;
def less_mean: (add / length) as $mean | map(. - $mean);
def wrapped: . / 6.283185307179586 | . - round | . * 6.283185307179586;
def order: [map(cos), map(sin)] | map(add / length) | rms * (2 | sqrt);
def minus($b): [., $b] | transpose | map(.[0] - .[1]);

$layouts[0] as $layout | ($lattices[0].swimmers | map({key: (.id | tostring), value: .position}) | from_entries) as $lattice
| (.swimmers | sort_by(.id)) as $all
| ($layout.swimmers | map({key: (.id | tostring), value: .}) | from_entries) as $start
| .driving.period as $T
| ($all | map(.cycles | length) | min) as $n
| ($all | map($start[.id | tostring].driving.phase_offset // 0)) as $offsets
| ($all | map($start[.id | tostring].driving.period // $T)) as $periods
| ($all | map(.id | tostring)) as $ids
| ([range(0; $n + 1; 2)] + [$n] | unique) as $kept
# [cycle][swimmer][x, y, z]
| ([$all, $periods, ($ids | map(. as $id | $start[$id].position | minus($lattice[$id])))] | transpose
   | map(.[0].cycles[:$n] as $cycles | .[1] as $period | .[2] as $off
     | [$off, foreach $cycles[] as $c ($off; [., $c.velocity] | transpose | map(.[0] + $period * .[1]))]) | transpose) as $places
| ($places | map(transpose | map(less_mean))) as $departures
| {name: $name, exit: $exit, status, reason, swimmers: ($all | length), cycles: $n, stiffness: ($layout.types | to_entries[0].value.springs[0].stiffness),
   cells_per_radius: .resolution.cells_per_radius, cell: .resolution.cell_size, precision: .resolution.precision,
   smallest_gap: (.near_contact.smallest_gap | if . then significant else . end), wall_seconds: (.cost.wall_seconds | round)}
+ if $n == 0 then {} else
  {arms: ($all | map(.cycles[-1].arm_amplitudes) | transpose | map(add / length | significant)),
   velocity: ([$all[].cycles[([2, $n - 1] | min):$n][].velocity[0]] | add / length | significant)}
+ if $periods == ($periods | map($T)) and ($all | length) > 1 then
  {kept: $kept,
   off: {x: [$kept[] as $k | $departures[$k][0] | rms | significant],
         across: [$kept[] as $k | $departures[$k][1:] | map(rms) | (.[0] * .[0] + .[1] * .[1]) | sqrt | significant],
         tilt: [$kept[] as $k | if $k == 0 then 0 else
           [$all[].cycles[$k - 1].axis[1:]] | transpose | map(less_mean | rms) | (.[0] * .[0] + .[1] * .[1]) | sqrt | significant end]}}
# Modes of a swarm of at most two swimmers along each axis, by signs + and - along x, y, z. Mode 000 is the mean displacement,
# which would stay constant in a fluid without cells.
+ if ($name | test("^(8 swimmers|2 abreast|1 swimmer|4 abreast)")) then
  ($ids | map($lattice[.]) | transpose | map(min as $least | map(if . > $least + 1 then -1 else 1 end))) as $signs
  | {modes_kept: [range(0; $n + 1; 5)],
     modes: [range(0; 8) as $m | [$m % 2, ($m / 2 | floor) % 2, ($m / 4 | floor)] as $wave
       | ($signs | transpose | map([., $wave] | transpose | map(if .[1] == 1 then .[0] else 1 end) | .[0] * .[1] * .[2])) as $sign
       | {wave: ($wave | map(tostring) | add),
          amplitudes: [range(0; $n + 1; 5) as $k | $places[$k] | transpose | map([., $sign] | transpose | map(.[0] * .[1]) | add / length | significant)]}
       | select($m == 0 or ([$sign[] | . < 0] | any)) | select($signs as $s | $wave | [., ($s | map(min < 0))] | transpose | map(.[0] == 0 or .[1]) | all)]}
  else {} end else {} end
# Phases of both arms relative to the driving of the swimmer, after 5 cycles and after the last cycle.
+ if ($name | test("phase|frequenc|step|alone")) then
  {offsets: ($offsets | map(significant)), periods: ($periods | map(. / $T | . * 1e5 | round / 1e5)),
   phases: [([5, $n] | min | ., $n) as $k | {cycle: $k,
     arms: [0, 1 | . as $arm | [$all, $offsets] | transpose
       | map(.[0].cycles[$k - 1].arm_phases[$arm] - .[1] | wrapped | . * 1e5 | round / 1e5)],
     amplitudes: [0, 1 | . as $arm | $all | map(.cycles[$k - 1].arm_amplitudes[$arm] | significant)]}],
   # Phase order of the drivings and of both arms, at the ends of cycles 5, 10, ... n of the first swimmer.
   orders: [([range(5; $n + 1; 5)] + [$n] | unique[]) as $k | ($k * $periods[0]) as $t
     | ([$offsets, $periods] | transpose | map(.[0] + 6.283185307179586 * $t / .[1])) as $driven
     | {cycle: $k, driving: ($driven | order | significant),
        arms: [0, 1 | . as $arm | [$all, $driven, $offsets] | transpose
          | map(.[1] + .[0].cycles[$k - 1].arm_phases[$arm] - .[2]) | order | significant]}]}
  else {} end end
