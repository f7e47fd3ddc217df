#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/figure/swarm_picture.hpp"

namespace beadswim {

enum class SwarmColours {
  blocks,    ///< of neighbouring swimmers, in turn
  swimmers,  ///< each its own, in turn
  types,     ///< of the layout
};

template <>
inline constexpr auto name_table<SwarmColours> = std::to_array<NamedValue<SwarmColours>>(
    {{SwarmColours::blocks, "blocks"}, {SwarmColours::swimmers, "swimmers"}, {SwarmColours::types, "types"}});

/// A swimmer that the picture names.
struct SwimmerMark {
  std::string name;
  int id = 0;
};

struct SwarmFigureOptions {
  std::optional<std::size_t> frame{};  ///< from 0; none: the last
  SwarmColours colours = SwarmColours::blocks;
  std::vector<int> block_swimmers{1, 3, 3};  ///< along each axis; or one number: by id, so many to a block
  std::array<int, 3> repeat{1, 1, 1};        ///< periodic copies along each axis
  std::vector<SwimmerMark> marks{};
  bool distances = false;  ///< between neighbours; of layouts alone
};

/// The swarm of a layout, or at one frame of a trajectory, each swimmer with its middle bead in the box.
/// Blocks of so many swimmers along each axis go by the layers in which middle beads stand in the layout, in
/// a checkerboard of two colours. Throws InputError.
SwarmPicture swarm_figure(const std::vector<std::string>& files, const SwarmFigureOptions& options);

}  // namespace beadswim
