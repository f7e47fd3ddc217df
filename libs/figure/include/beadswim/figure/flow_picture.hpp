#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/figure/drawing.hpp"
#include "beadswim/figure/streamlines.hpp"

// Picture of the flow in a plane across a coordinate axis, as SVG: a map of one quantity, streamlines or
// arrows, and the outlines of beads. Equal pictures have equal bytes.

namespace beadswim {

enum class FlowQuantity { speed, ux, uy, uz };

template <>
inline constexpr auto name_table<FlowQuantity> =
    std::to_array<NamedValue<FlowQuantity>>({{FlowQuantity::speed, "speed"},
                                             {FlowQuantity::ux, "ux"},
                                             {FlowQuantity::uy, "uy"},
                                             {FlowQuantity::uz, "uz"}});

enum class FlowStyle { streamlines, arrows };

template <>
inline constexpr auto name_table<FlowStyle> = std::to_array<NamedValue<FlowStyle>>(
    {{FlowStyle::streamlines, "streamlines"}, {FlowStyle::arrows, "arrows"}});

/// Flow on a layer of square cells in the plane. Cells are numbered along the first axis of the plane first.
struct FlowLayer {
  PlanePoint origin = PlanePoint::Zero();         ///< corner of the first cell [length]
  double spacing = 1;                             ///< edge of a cell [length]
  Eigen::Array2i cells = Eigen::Array2i::Zero();  ///< number of cells along both axes
  std::vector<Vec3> velocity;                     ///< components along x, y, z [length/time]
  std::vector<double> covered{};                  ///< part of the time in which a bead covers the cell
  std::vector<bool> hidden{};                     ///< true for a cell without flow; empty: there is none

  Eigen::AlignedBox2d extent() const { return {origin, origin + spacing * cells.cast<double>().matrix()}; }
  PlanePoint centre(int x, int y) const { return origin + spacing * PlanePoint(x + 0.5, y + 0.5); }
  bool is_hidden(std::size_t index) const { return !hidden.empty() && hidden[index]; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * cells.x() + x; }
};

struct BeadOutline {
  PlanePoint centre = PlanePoint::Zero();  ///< [length]
  double radius = 0;  ///< of the section, or of a bead that the plane does not cut [length]
  bool is_cut = true;
};

struct FlowPicture {
  std::string title;
  int across = 2;                 ///< axis across the plane: 0, 1, 2 for x, y, z
  double coordinate = 0;          ///< place of the plane along this axis [length]
  std::vector<FlowLayer> layers;  ///< at least one; a later one counts where several are not hidden
  FlowQuantity quantity = FlowQuantity::speed;
  FlowStyle style = FlowStyle::streamlines;
  std::vector<BeadOutline> beads{};
  bool shows_covered_cells = false;  ///< draws the cells in beads, for beads without outlines
  std::string length_unit{}, velocity_unit{};
  std::vector<Note> notes{};

  /// Returns the axes of the plane, to the right and upwards.
  std::array<int, 2> axes() const { return {across == 0 ? 1 : 0, across == 2 ? 1 : 2}; }
};

/// Draws the picture, whose size does not depend on the number of cells. Its numbers are place and velocity
/// of all cells.
Drawing draw(const FlowPicture& picture);

}  // namespace beadswim
