#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim {

/// A link between a covered cell and a fluid cell of the block or its halo. At least one of the two cells
/// belongs to the block.
struct BeadLink {
  std::array<std::int16_t, 3> from_low;  ///< covered cell relative to the low corner of the image
  std::uint8_t out : 5;                  ///< direction from the covered cell to the fluid cell
  std::uint8_t fluid_behind : 2;  ///< number of fluid cells behind the fluid cell that the scheme reads
  bool fluid_is_own : 1;  ///< true if the fluid cell belongs to the block; otherwise its owner reflects
  double outgoing = 0;    ///< population that left the fluid cell along the link in the last step
};

/// Links [first, end) of one image of a bead that are processed together.
struct LinkSegment {
  int first, end;  ///< indices into the links of the image
  int image;       ///< index into CoveredImages::images
};

/// Returns the populations that a scheme needs in the halo.
constexpr HaloContent halo_content(BeadScheme scheme) {
  return cells_behind(scheme) > 1 ? HaloContent::behind : HaloContent::entering;
}

/// All links of a block, sorted by the row before which the step processes them.
///
/// A link reads and writes incoming populations of its covered cell, of its fluid cell and of the fluid cells
/// behind that the scheme reads. The scheme mr also reads incoming populations of all cells around the fluid
/// cell. The step processes a segment just before it sweeps the first row that the segment uses. The sweep
/// needs the same populations in the cache.
///
/// A bead moves by a fraction of a cell per step, so that most links persist from one step to the next.
class BeadLinks {
 public:
  explicit BeadLinks(BeadScheme scheme) : scheme_(scheme) {}

  BeadScheme scheme() const { return scheme_; }

  /// Finds the links after an update of the coverage. Keeps the links next to rows in which an image covers
  /// the same cells as before.
  void find(const Coverage& coverage);

  /// Returns all segments in the order of the step.
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
  /// Offsets (dy, dz) of the rows that follow a row in the order of z, then y, and that can have links with
  /// its cells.
  static constexpr std::array<std::array<int, 2>, 4> later_rows{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

  /// The links of one image, in two segments per row. Segment `downwards` = 0 has the links from covered
  /// cells of the row to fluid cells of the same row and of later rows. Segment 1 has the links from covered
  /// cells of later rows to fluid cells of the row. The rows extend from one row before the box of the image
  /// to its last row along z, and to one row after it along y.
  struct ImageLinks {
    BeadImage box;
    bool is_alone = false;         ///< no other image or wall can affect the links: the runs determine them
    std::vector<CoveredRun> runs;  ///< runs from which the links were found
    std::vector<int> first_of_segment;  ///< first link of each segment; last entry: number of links
    std::vector<int> place_of_segment;  ///< position of each segment in the order of the step
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
