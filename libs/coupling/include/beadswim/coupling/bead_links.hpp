#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/coverage.hpp"

namespace beadswim {

/// A link from a covered cell to a fluid cell of the block or its halo, one of them at least the block's own.
struct BeadLink {
  int x, y, z;          ///< the covered cell, local
  std::int8_t out;      ///< direction from the covered cell into the fluid
  bool fluid_is_own;    ///< whether the fluid cell is the block's own; else its owner reflects
  double outgoing = 0;  ///< what the fluid sent along the link in the last step
};

/// Links of one image of a bead between cells of one row and of the same or later rows.
struct LinkSegment {
  int first, end;  ///< links
  int image;       ///< index into CoveredImages::images
};

/// All links of a block, by the row at which the sweep comes to them.
///
/// A link reads a place among the incoming populations of its covered cell and writes one among those of its
/// fluid cell. It belongs to the earlier of their two rows, so that links of row after row can be done just
/// before the sweep of that row, while its populations are on their way into the cache anyway.
class BeadLinks {
 public:
  /// Finds the links anew for a coverage that has been updated.
  void find(const Coverage& coverage);

  /// Segments, all in order of their rows.
  std::span<const LinkSegment> segments() const { return by_row_; }

  /// The range of segments to be done before row (y, z) of the block is swept.
  int first_segment_of(int y, int z) const { return first_of_row_[y + rows_y_ * z]; }
  int end_segment_of(int y, int z) const { return first_of_row_[y + rows_y_ * z + 1]; }

  std::span<BeadLink> links(const LinkSegment& segment) {
    return std::span(links_).subspan(segment.first, segment.end - segment.first);
  }

  /// Calls visit(link) for every link of the covered cell (x, y, z) in the image of this index.
  template <class Visit>
  void for_each_link_of(int image, int x, int y, int z, Visit&& visit) const {
    constexpr std::array<std::array<int, 2>, 5> from_rows{{{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    for (const auto& [dy, dz] : from_rows) {  // its own row and those before it
      const LinkSegment& segment = by_image_[boxes_[image].segment_of(y - dy, z - dz)];
      for (int n = segment.first; n < segment.end; ++n) {
        const BeadLink& link = links_[n];
        if (link.x == x && link.y == y && link.z == z) visit(link);
      }
    }
  }

 private:
  /// Rows that the links of one image may belong to.
  struct Box {
    int low_y, low_z, rows_y;
    int first_segment;

    int segment_of(int y, int z) const { return first_segment + y - low_y + rows_y * (z - low_z); }
  };

  void find_between_rows(const Coverage& coverage, const CoveredImage& covered, int y, int z);
  void sort_by_row(const Index3& block);

  std::vector<BeadLink> links_;
  std::vector<LinkSegment> by_image_, by_row_;
  std::vector<int> row_of_segment_;  ///< of those in by_image_
  std::vector<Box> boxes_;           ///< of each image
  std::vector<int> first_of_row_, next_of_row_;
  int rows_y_ = 0;
};

}  // namespace beadswim
