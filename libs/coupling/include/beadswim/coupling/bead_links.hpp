#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim {

/// A link: the line between the centres of a covered cell (its centre lies in a bead) and an adjacent fluid
/// cell. The surface of the bead cuts this line. Both cells lie in the block or its halo, and at least one of
/// them belongs to the block. Let c be the direction from the covered cell to the fluid cell x. The fluid
/// cell x + c is called the cell *behind* x; the second cell behind is x + 2 c.
struct BeadLink {
  std::array<std::int16_t, 3> from_low;  ///< local coordinates of the covered cell minus BeadImage::low
  std::uint8_t out : 5;                  ///< direction from the covered cell to the fluid cell
  /// Number of consecutive cells behind the fluid cell that are fluid, at most cells_behind(scheme).
  std::uint8_t fluid_behind : 2;
  /// True if the fluid cell belongs to the block. Otherwise another rank applies the boundary condition.
  bool fluid_is_own : 1;
  double outgoing = 0;  ///< population that left the fluid cell towards the bead in the last step
};

/// Consecutive links [first, end) of one image of a bead. The step processes them together.
struct LinkSegment {
  int first, end;  ///< indices into the links of the image
  int image;       ///< index into CoveredImages::images
};

/// Returns the kind of halo content that the links of a scheme read.
constexpr HaloContent halo_content(BeadScheme scheme) {
  return cells_behind(scheme) > 1 ? HaloContent::behind : HaloContent::entering;
}

/// All links of a block, sorted by the row before which the step processes them.
///
/// A link reads and writes incoming populations of its covered cell, of its fluid cell and of the cells
/// behind that the scheme reads. The scheme mr also reads incoming populations of all cells around the fluid
/// cell. The step processes a segment just before it sweeps the first row whose populations the segment uses.
/// The populations that the segment loads into the cache are then used by the sweep.
///
/// A bead moves by a fraction of a cell per step. Most links therefore remain unchanged from one step to the
/// next.
class BeadLinks {
 public:
  explicit BeadLinks(BeadScheme scheme) : scheme_(scheme) {}

  BeadScheme scheme() const { return scheme_; }

  /// Finds the links after an update of the coverage. Does not search again for links next to rows in which
  /// an image covers the same cells as before.
  void find(const Coverage& coverage);

  /// Returns all segments in the order in which the step processes them.
  std::span<const LinkSegment> segments() const { return by_row_; }

  /// Return the range of segments that the step processes before it sweeps row (y, z) of the block.
  int first_segment_of(int y, int z) const { return first_of_row_[place_of_row(y, z)]; }
  int end_segment_of(int y, int z) const { return first_of_row_[place_of_row(y, z) + 1]; }

  std::span<BeadLink> links(const LinkSegment& segment) {
    return std::span(images_[segment.image].links).subspan(segment.first, segment.end - segment.first);
  }

  /// Calls visit(link) for every link of the covered cell (x, y, z) of the image with index `image`.
  template <class Visit>
  void for_each_link_of(int image, int x, int y, int z, Visit&& visit) const {
    const ImageLinks& image_links = images_[image];
    const Index3 cell = Index3(x, y, z) - image_links.box.low;
    const auto visit_in = [&](int segment) {
      for (int n = image_links.first_of_segment[segment]; n < image_links.first_of_segment[segment + 1];
           ++n) {
        const BeadLink& link = image_links.links[n];
        if (link.from_low[0] == cell[0] && link.from_low[1] == cell[1] && link.from_low[2] == cell[2])
          visit(link);
      }
    };
    visit_in(image_links.segment(y, z, 0));
    for (const auto& [dy, dz] : later_rows) visit_in(image_links.segment(y - dy, z - dz, 1));
  }

 private:
  /// Offsets (dy, dz) from a row to the adjacent rows that come later in the order of z, then y. Links can
  /// join a cell of a row to cells of these rows.
  static constexpr std::array<std::array<int, 2>, 4> later_rows{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

  /// The links of one image, in two segments per row:
  /// - Segment 0 (downwards = 0): links from covered cells of the row to fluid cells of the same row and of
  ///   later rows.
  /// - Segment 1 (downwards = 1): links from covered cells of later rows to fluid cells of the row.
  ///
  /// If the box of the image is [low, high), the rows have low_y - 1 <= y <= high_y and low_z - 1 <= z <
  /// high_z.
  struct ImageLinks {
    BeadImage box;
    bool is_alone = false;         ///< true if no other image and no wall can affect the links
    std::vector<CoveredRun> runs;  ///< covered cells of each row, from which the links were found
    /// Index of the first link of each segment. The last entry is the number of links.
    std::vector<int> first_of_segment;
    /// Position in the sweep order, place_of_row(), of the row before which each segment is processed.
    std::vector<int> place_of_segment;
    std::vector<BeadLink> links;

    int rows_y() const { return box.high[1] - box.low[1] + 2; }
    int segment(int y, int z, int downwards) const {
      return 2 * (y - box.low[1] + 1 + rows_y() * (z - box.low[2] + 1)) + downwards;
    }
  };

  void find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone, ImageLinks& known);
  int place_of_row(int y, int z) const { return y + block_[1] * order_of_plane(z, block_[2]); }
  int place_of_segment(int y, int z, int downwards) const;
  template <class Visit>
  void for_each_segment(Visit&& visit) const;
  void sort_by_row();

  BeadScheme scheme_;
  Index3 block_;  ///< size of the block
  std::vector<ImageLinks> images_;
  std::vector<LinkSegment> by_row_;
  std::vector<int> first_of_row_, next_of_row_;
  std::vector<BeadLink> found_;  ///< links of one image during the search
  std::vector<int> first_found_;
};

}  // namespace beadswim
