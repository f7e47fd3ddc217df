# Extracts the data for docs/scaling.md from a run record. $group, $ranks, $swimmers, $cells describe the run.
{group: $group, ranks: $ranks, swimmers: $swimmers, precision: .resolution.precision, cells: $cells,
 steps: (.cost.cell_updates / $cells), seconds: .cost.wall_seconds, memory: .cost.peak_memory_bytes} + .cost.communication
