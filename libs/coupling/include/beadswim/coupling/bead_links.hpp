#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/coverage.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim {

/// A link from a covered cell to a fluid cell of the block or its halo, one of them at least the block's own.
struct BeadLink {
  std::array<std::int16_t, 3> from_low;  ///< the covered cell, from the low corner of the image
  std::int8_t out;                       ///< direction from the covered cell into the fluid
  bool fluid_is_own;    ///< whether the fluid cell is the block's own; else its owner reflects
  double outgoing = 0;  ///< what the fluid sent along the link in the last step
};

/// Links of one image of a bead between cells of one row and of the same or later rows.
struct LinkSegment {
  int first, end;  ///< among the links of the image
  int image;       ///< index into CoveredImages::images
};

/// All links of a block, by the row at which the sweep comes to them.
///
/// A link reads a place among the incoming populations of its covered cell and writes one among those of its
/// fluid cell. It is done before the first of their two rows that the step comes to, so that links of row
/// after row can be done just before the sweep of that row, while its populations are on their way into the
/// cache anyway.
///
/// Beads cross a few cells a step at most, so that most links are those of the step before.
class BeadLinks {
 public:
  /// Finds the links for a coverage that has been updated. Those next to rows of which the same image covers
  /// the same cells as before are kept.
  void find(const Coverage& coverage);

  /// Segments, all in order of their rows.
  std::span<const LinkSegment> segments() const { return by_row_; }

  /// The range of segments to be done before row (y, z) of the block is swept.
  int first_segment_of(int y, int z) const { return first_of_row_[place_of_row(y, z)]; }
  int end_segment_of(int y, int z) const { return first_of_row_[place_of_row(y, z) + 1]; }

  std::span<BeadLink> links(const LinkSegment& segment) {
    return std::span(images_[segment.image].links).subspan(segment.first, segment.end - segment.first);
  }

  /// Calls visit(link) for every link of the covered cell (x, y, z) in the image of this index.
  template <class Visit>
  void for_each_link_of(int image, int x, int y, int z, Visit&& visit) const {
    constexpr std::array<std::array<int, 2>, 5> from_rows{{{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    const ImageLinks& of = images_[image];
    const Index3 cell = Index3(x, y, z) - of.box.low;
    for (const auto& [dy, dz] : from_rows) {  // its own row and those before it
      const int row = of.row(y - dy, z - dz);
      for (int n = of.first_of_row[row]; n < of.first_of_row[row + 1]; ++n) {
        const BeadLink& link = of.links[n];
        if (link.from_low[0] == cell[0] && link.from_low[1] == cell[1] && link.from_low[2] == cell[2])
          visit(link);
      }
    }
  }

 private:
  /// The links of one image, by rows from one before its box to the last in it along z, to one after it along
  /// y.
  struct ImageLinks {
    BeadImage box;
    bool is_alone = false;          ///< no other image within a cell, so that its own runs say all
    std::vector<CoveredRun> runs;   ///< from which the links were found
    std::vector<int> first_of_row;  ///< among the links; one more than rows
    std::vector<BeadLink> links;

    int rows_y() const { return box.high[1] - box.low[1] + 2; }
    int rows_z() const { return box.high[2] - box.low[2] + 1; }
    int row(int y, int z) const { return y - box.low[1] + 1 + rows_y() * (z - box.low[2] + 1); }
  };

  int place_of_row(int y, int z) const { return y + block_[1] * place_in_order(z, block_[2]); }
  void find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone, ImageLinks& known);
  void sort_by_row(const Index3& block);

  std::vector<ImageLinks> images_;
  std::vector<LinkSegment> by_row_;
  std::vector<int> first_of_row_, next_of_row_;
  Index3 block_;                 ///< its size
  std::vector<BeadLink> found_;  ///< of one image, while they are being found
  std::vector<int> first_found_;
};

}  // namespace beadswim
