# The table of docs/hard-cases.md from hard-cases.jsonl:  jq -rs -f hard-cases.jq hard-cases.jsonl
def percent: if . == null then "" else . * 1000 | round / 10 | if . > 0 then "+\(.) %" else "\(.) %" end end;
def over(other): if . == null or other == null or other == 0 then null else . / other - 1 end;
def rounded(digits): if . == null then "" elif . == 0 then "0"
  else (. | fabs | log10 | floor) as $e | (digits - 1 - $e) as $n
    | if $n > 15 then "\(. * 1e12 | round / 1e12)" else . * pow(10; $n) | round / pow(10; $n) | tostring end end;
def errors: .cycle as $c | .reference.cycle as $r
  | if $c == null or $r == null then ""
    else [$c.speed_along_axis | over($r.speed_along_axis)]
      + [[$c.arm_amplitudes, $r.arm_amplitudes] | transpose[] | . as [$a, $b] | $a | over($b)] | map(percent) | join(", ") end;
def planned: .plan as $p | if $p == null then "" elif $p.refused then "refuses" elif $p.error == null then ""
  else [$p.error.velocity, $p.error.arm_amplitudes[]] | map(if . > 10 then "> 1000 %" else . * 1000 | round / 10 | "\(.) %" end) | join(", ") end;
def outcome: if .status == "finished" then "runs" + (if .warned then ", warns" else "" end) else .status end;
group_by(.group)[] | (
  "\n## \(.[0].group | .[0:1] | ascii_upcase)\(.[0].group[1:])\n",
  "| case | outcome | v, d1, d2 against the reference | the plan expects | smallest gap | Mach |", "|---|---|---|---|---|---|",
  (.[] | "| \(.case) | \(outcome) | \(errors) | \(planned) | \(.gap | rounded(2)) | \(.mach | rounded(2)) |"),
  "", (map(select(.reason != "")) | unique_by(.reason | gsub("[0-9.e+-]+"; "#"))[] | "- \(.case): \(.reason)"))
