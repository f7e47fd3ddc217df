# What docs/scaling.md keeps of a run's record. $group, $ranks, $swimmers, $cells: of the run.
{group: $group, ranks: $ranks, swimmers: $swimmers, precision: .resolution.precision, cells: $cells,
 steps: (.cost.cell_updates / $cells), seconds: .cost.wall_seconds, memory: .cost.peak_memory_bytes} + .cost.communication
