# Prints the numbers of plans from the records of plan-costs.sh.
def runs($scene; $flags): map(select(.scene == $scene and .flags == $flags)) | sort_by(.steps);
def products($scene; $flags): runs($scene; $flags) | (.[-1].steps - .[0].steps) as $steps | .[0] as $first
  | "\($scene), \($flags): \($first.products) products in the first \($first.steps) steps, then \(
    (.[-1].products - $first.products) / $steps * 100 | round / 100) products\(
    if $first.iterations then " with \((.[-1].iterations - $first.iterations) / $steps * 100 | round / 100) iterations" else "" end) per step";
products("alone"; "--model rpy"), products("one in a box"; "--model rpy"), products("swarm"; "--model rpy+near"),
products("swarm with dashpots"; "--model rpy"), products("swarm with random phases"; "--model rpy"),
(range(3) as $n | products("swarm with memory"; "--model unsteady --multipole-order \($n)")),
"memory of the program: \(map(select(.scene == "alone"))[0].peak_memory_bytes / 1e6 | round) MB",
(runs("large swarm"; "--model rpy")[0] as $rpy | range(1; 3) as $n | runs("large swarm"; "--model multipole --multipole-order \($n)")[0]
  | "moments of order \($n): \((.peak_memory_bytes - $rpy.peak_memory_bytes) / .beads | round) bytes per bead")
