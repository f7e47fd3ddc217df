# Prints the table of docs/choosing-a-model.md from plan-check.jsonl:  jq -rs -f plan-check.jq plan-check.jsonl
# Ratios of expected to measured numbers, as geometric means, below the table with ranges of all scenes. Measured errors below 0.3 %, the
# uncertainty of the references, count as 0.3 %.
def least: 0.003;
def two: if . >= 9.95 then round | tostring elif . >= 0.995 then . * 10 | round / 10 | tostring else . * 100 | round / 100 | tostring end;
def percent: if . == null then "" else . * 1000 | round / 10 | tostring end;
def ratio($expected; $measured): ([$expected, least] | max) / ([$measured, least] | max);
def mean_ratio: if length == 0 then "no runs" else map(log) | add / length | exp | two end;
def of_ratios: if length == 0 then "" else
  "geometric mean \(map(log) | add / length | exp | two), range \(min | two) to \(max | two)" end;
def largest: [.velocity] + .arm_amplitudes | max;
def lattices: select(.flags | startswith("--model lbm"));
def mobilities: select(.flags | startswith("--model lbm") | not);
def made: .runs[] | select(.measured);
def velocity: ratio(.expected.error.velocity; .measured.error.velocity);
def arms: ratio(.expected.error.arm_amplitudes | max; .measured.error.arm_amplitudes | max);
# Judges the choice for one tolerance by its measured error and by the cheapest measured run within the tolerance.
def judged($scene): . as {$tolerance, $choice}
  | [$scene | made | select(.measured.error | largest <= $tolerance)] | min_by(.measured.core_seconds) as $cheapest
  | if $choice == null then {kind: (if $cheapest then "cautious" else "right" end)}
    else ($choice | sub(" --precision single"; "")) as $flags | [$scene | made | select(.flags == $flags)][0] as $run
      | if $run == null then {kind: "not measured"}
        else {error: ($run.measured.error | largest), excess: ($run.measured.core_seconds / ($cheapest.measured.core_seconds // infinite))}
          | .kind = (if .error > 1.1 * $tolerance then "wrong" elif .excess > 3 then "dear" else "right" end) end end;
def words: if .kind == "right" and .error == null then "none chosen: no run within tolerance" elif .kind == "cautious" then "none chosen: too cautious"
  elif .kind == "not measured" then .kind else "\(.error | percent)\(if .kind == "dear" then " (cost ×\(.excess | two))" else "" end)" end;
map(. as $scene | . + {judged: [.choices[] | judged($scene)]}) as $scenes | $scenes |
"| scene (l: rest length, λ: bead radius, T: period, A: driving amplitude) | expected/measured error of velocity v, lattice runs | expected/measured error of v, mobility models | measured error [%] of the run chosen for tolerance 10 % | error [%] of the run chosen for 3 % | error [%] of the run chosen for 1 % |",
"|---|---|---|---|---|---|",
(.[] | "| \(.scene | sub("^two "; "two swimmers ")) | \([made | lattices | velocity] | mean_ratio) | "
  + "\([made | mobilities | velocity] | mean_ratio) | "
  + "\(.judged | map(words) | join(" | ")) |"),
"",
([$scenes[].judged[].kind] | group_by(.) | map("\(.[0] | {cautious: "too cautious", dear: "more than 3 times as expensive as necessary"}[.] // .): \(length)") | join(", ") | "The plan's choices: \(.)."),
([$scenes[] | made | lattices | velocity] | "Expected/measured error of v, lattice runs: \(of_ratios); from 1/2 to 2: \(map(select(. >= 0.5 and . <= 2)) | length) of \(length) runs, below half: \(map(select(. < 0.5)) | length) runs."),
([$scenes[] | made | lattices | arms] | "Expected/measured error of strokes, lattice runs: \(of_ratios); from 1/2 to 2: \(map(select(. >= 0.5 and . <= 2)) | length) of \(length) runs, below half: \(map(select(. < 0.5)) | length) runs."),
([$scenes[] | made | mobilities | velocity] | "Expected/measured error of v, mobility models: \(of_ratios); below half: \(map(select(. < 0.5)) | length) of \(length) runs."),
([$scenes[] | made | mobilities | arms] | "Expected/measured error of strokes, mobility models: \(of_ratios); below half: \(map(select(. < 0.5)) | length) of \(length) runs.")
