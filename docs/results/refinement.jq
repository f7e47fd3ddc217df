# Prints the table of docs/refinement.md from refinement.jsonl:  jq -rs -f refinement.jq refinement.jsonl
def digits(n): . * pow(10; n) | round / pow(10; n) | tostring;
"| swimmers | levels that `auto` chooses | share of the box in the finest level [%] | core-seconds with cells of one size | with levels | ratio |", "|---|---|---|---|---|---|",
(.[] | (.levels == 1) as $one | "| \(.swimmers) | \(.levels) | \(if $one then "-" else 100 * .share | digits(1) end) | \(.seconds_uniform | digits(2)) | \(if $one then "-" else .seconds_levels | digits(2) end) | \(if $one then "-" else .seconds_uniform / .seconds_levels | digits(1) end) |")
