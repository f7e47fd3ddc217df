# Prints the numbers of plans from the records of plan-costs.sh.
def runs($scene; $flags): map(select(.scene == $scene and .flags == $flags)) | sort_by(.steps, .beads);
def products($scene; $flags): runs($scene; $flags) | (.[-1].steps - .[0].steps) as $steps | .[0] as $first
  | "\($scene), \($flags): \($first.products) products in the first \($first.steps) steps, then \(
    (.[-1].products - $first.products) / $steps * 100 | round / 100) products\(
    if $first.iterations then " with \((.[-1].iterations - $first.iterations) / $steps * 100 | round / 100) iterations" else "" end) per step";
# Memory of the mesh of a fluid with memory: the difference of two swarms, without 800 bytes per bead and the bytes of moments.
def mesh($flags; $moments): runs("large swarm"; "--model unsteady " + $flags)
  | "mesh, \($flags): \((.[1].peak_memory_bytes - .[0].peak_memory_bytes - (800 + $moments) * (.[1].beads - .[0].beads)) / (.[1].mesh_points - .[0].mesh_points) | round) bytes per point";
products("alone"; "--model rpy"), products("one in a box"; "--model rpy"), products("swarm"; "--model rpy+near"),
products("swarm with dashpots"; "--model rpy"), products("swarm with random phases"; "--model rpy"),
(range(3) as $n | products("swarm with memory"; "--model unsteady --multipole-order \($n)")),
"memory of the program: \(map(select(.scene == "alone"))[0].peak_memory_bytes / 1e6 | round) MB",
(runs("large swarm"; "--model rpy")[0] as $rpy | range(1; 3) as $n | runs("large swarm"; "--model multipole --multipole-order \($n)")[0]
  | "moments of order \($n): \((.peak_memory_bytes - $rpy.peak_memory_bytes) / .beads | round) bytes per bead"),
mesh("--multipole-order 0 --reynolds-stress off"; 0), mesh("--multipole-order 0"; 0), mesh("--multipole-order 1"; 4400), mesh("--multipole-order 2"; 6600),
(runs("alone"; "--model rpy --frames-per-cycle 10") | "beside products: \((.[1].user_seconds - .[0].user_seconds) / (.[1].steps - .[0].steps) * 1e6 | round) microseconds per step of one swimmer"),
"start of a run: \(map(select(.steps == 2 and .scene == "alone"))[0].core_seconds) core-seconds with the first two steps",
(.[] | select(.steps == 120 and .scene != "alone") | "\(.scene), \(.flags), a cycle of \(.beads) beads: \(.core_seconds / .expected_seconds * 100 | round / 100) times the expected cost")
