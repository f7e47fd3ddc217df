#!/bin/bash
# Prints the tables of docs/scaling.md from its records:  docs/results/scaling-tables.sh docs/results/scaling.jsonl
# Times are medians over runs of the same group and number of ranks.
set -euo pipefail
records=${1:?name the records}

jq -rs '
  def median: sort | .[(length - 1) / 2 | floor];
  def short: if . >= 100 then round elif . >= 10 then (. * 10 | round) / 10 else (. * 100 | round) / 100 end;
  def medians: group_by([.group, .ranks]) | map(.[0] + {time: (map(.seconds / .steps) | median)}) | sort_by(.ranks);
  map(select(.group == "weak" or .group == "strong")) | medians as $all
  | (["weak", "strong"][] as $group
     | ($all | map(select(.group == $group))) as $rows
     | "### \(if $group == "weak" then "Weak: nine swimmers and 48³ cells per rank" else "Strong: 72 swimmers and 96³ cells" end)\n\n"
       + "| ranks | time per step [ms] | cells per second relative to 1 rank | sent per rank and step: messages, kB |\n|---|---|---|---|\n"
       + ($rows | map("| \(.ranks) | \(.time * 1e3 | short) | \((.cells / .time) / ($rows[0].cells / $rows[0].time) | short) | \(.messages_per_step | round), \(.bytes_per_step / 1e3 | round) |") | join("\n")) + "\n")' "$records"

jq -rs '
  map(select(.group != "weak" and .group != "strong"))
  | "### Largest, on two ranks in single precision\n\n| scene | number of swimmers | number of cells | memory [GiB] | bytes per cell | time per step [s] |\n|---|---|---|---|---|---|\n"
    + (map("| \(if .group == "largest" then "largest scene, 6" else .group + ", 3" end) cells per radius | \(.swimmers) | \(.cells) | \(.memory / 1073741824 * 10 | round / 10) | \(.memory / .cells * 10 | round / 10) | \(.seconds / .steps * 100 | round / 100) |") | join("\n"))' "$records"

# Time of a step by the model of the page, with nine swimmers in 96^3 cells on each rank.
jq -rs '
  def median: sort | .[(length - 1) / 2 | floor];
  (map(select(.group == "weak" and .ranks == 2)) | map(.cells / (.seconds / .steps) / 2) | median) as $speed
  | {cells: 884736, swimmers: 9, halo: (3 * 2 * 98 * 98 * 15 * 8), messages: 64, latency: 2e-6, bandwidth: 1e9, frames: 40,
     steps: 2000, state: 844, root: 1e9} as $m
  | "\n### Model\n\n| ranks | time per step [ms]: cells and beads, messages, frames | parallel efficiency [%] |\n|---|---|---|\n"
    + ([1, 1280, 100000] | map(
        . as $ranks
        | ($m.cells / $speed) as $work
        | (if $ranks == 1 then 0 else $m.halo / $m.bandwidth + $m.messages * $m.latency end) as $send
        | ($m.swimmers * $ranks * $m.state * $m.frames / $m.steps / $m.root) as $frames
        | ($work + $send + $frames) as $all
        | "| \($ranks) | \($work * 1e4 | round / 10), \($send * 1e4 | round / 10), \($frames * 1e4 | round / 10) | \($work / $all * 100 | round) |") | join("\n"))' "$records"
