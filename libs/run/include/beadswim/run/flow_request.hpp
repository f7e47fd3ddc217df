#pragma once

#include <optional>
#include <vector>

#include "beadswim/io/vti.hpp"
#include "beadswim/run/run_settings.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Where a run writes the flow, and over which time it is averaged.
struct FlowRequest {
  std::optional<int> mean_cycles{};  ///< mean over the last base cycles of the run; nullopt: present flow
  std::optional<int> swimmer{};      ///< id of the swimmer in whose frame the places are; nullopt: the box
  bool is_on_lattice = false;        ///< on the cells of the lattice, with all levels; then no other places
  bool is_grid = true;               ///< at the centres of `cells`, otherwise at `points`
  VtiCells cells{};                  ///< [length]
  std::vector<Vec3> points{};        ///< [length]; of a grid too, x fastest
};

/// Throws InputError if region or frame have no meaning in any layout.
void require_flow_syntax(const RunSettings& settings);

/// Returns what the settings ask for; nullopt if they ask for no flow. `spacing`: usual edge of a cell
/// [length]. Throws InputError if a setting is invalid or does nothing, if places lie outside the fluid, or
/// if there are too many. Reads the file of points.
std::optional<FlowRequest> flow_request(const RunSettings& settings, const Layout& layout, double spacing);

}  // namespace beadswim
