# Extracts the data for docs/swarm-figures.md from the run record of a swarm.
#   jq -c --arg name NAME --argjson layout LAYOUT -f swarms.jq RUN.json
# Lengths are in units of the layout. Displacements are displacements of the mean bead position since the start. Tilts are the
# components of the axis along y and z, averaged over a cycle: the sines of the angles in the planes x-y and x-z.
def rounded(digits): pow(10; digits) as $p | . * $p | round / $p;
def rms_about_mean: (add / length) as $mean | map(. - $mean | . * .) | add / length | sqrt | rounded(3);
# Returns the rms distances of nine swimmers of the uniform swarm from their regular sites, along x, y and z [length].
def off_the_lattice($displacements): [.swimmers | sort_by(.id) | map([.id, .position]) | [., $displacements] | transpose[]
    | .[1] as $moved | .[0] as [$id, $at]
    | [$at[0], $at[1] - 32 * ($id % 3), $at[2] - 32 * ($id / 3 | floor)] | [., $moved] | transpose | map(add)]
  | transpose | map(rms_about_mean);
def path($T): [foreach .cycles[] as $c ([0, 0, 0]; [., $c.velocity] | transpose | map(.[0] + $T * .[1]))];

.driving.period as $T
| .swimmers as $all
| ($all[0].cycles | length) as $n
| ([range(3; $n; 4)] + [$n - 1] | unique) as $kept
| {name: $name, status, reason,
   cells_per_radius: .resolution.cells_per_radius, precision: .resolution.precision,
   bead_boundary: .resolution.bead_boundary, wall_seconds: (.cost.wall_seconds | rounded(0)),
   type: ($layout.types | to_entries[0].value | {k: .springs[0].stiffness, c: .springs[0].damping, K_A: .angular_stiffness,
                                                  density: .beads[0].density}),
   swimmers: ($all | length), cycles: $n}
+ if $n == 0 then {} else
  {kept_cycles: ($kept | map(. + 1)),
   paths: ($all | map(select(.id == 0 or .id == 3 or .id == 4)
     | path($T) as $path | (.cycles | map(.axis)) as $axis
     | {key: (.id | tostring), value:
         {x: [$kept[] as $c | $path[$c][0] | rounded(3)], y: [$kept[] as $c | $path[$c][1] | rounded(4)],
          z: [$kept[] as $c | $path[$c][2] | rounded(4)],
          tilt_y: [$kept[] as $c | $axis[$c][1] | rounded(5)], tilt_z: [$kept[] as $c | $axis[$c][2] | rounded(5)],
          velocity_x: {mean: ([.cycles[2:][].velocity[0]] | if length > 0 then add / length | rounded(9) else null end),
                       least: ([.cycles[2:][].velocity[0]] | min // null | if . then rounded(9) else . end),
                       most: ([.cycles[2:][].velocity[0]] | max // null | if . then rounded(9) else . end)},
          arm_amplitudes: (.cycles[-1].arm_amplitudes | map(rounded(3)))}}) | from_entries),
   largest: {y: ($all | map(path($T)[] | .[1] | fabs) | max | rounded(9)),
             z: ($all | map(path($T)[] | .[2] | fabs) | max | rounded(9)),
             tilt: ($all | map(.cycles[].axis[1:3][] | fabs) | max | rounded(9)),
             x_apart: ($all | map(path($T)[-1][0]) | max - min | rounded(4))}}
  + if $layout.domain.lengths == [96, 96, 96] then {off_the_lattice:
      {at_start: ($layout | off_the_lattice([range(9) | [0, 0, 0]])),
       at_end: ([$all | sort_by(.id)[] | path($T)[-1]] as $last | $layout | off_the_lattice($last))}} else {} end
  end
