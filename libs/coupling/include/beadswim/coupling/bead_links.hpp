#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/lattice/fluid_step.hpp"

namespace beadswim {

/// A link from a covered cell to a fluid cell of the block or its halo, one of them at least the block's own.
struct BeadLink {
  std::array<std::int16_t, 3> from_low;  ///< the covered cell, from the low corner of the image
  std::uint8_t out : 5;                  ///< direction from the covered cell into the fluid
  std::uint8_t fluid_behind : 2;  ///< how many cells on along `out` are fluid too, as far as the scheme reads
  bool fluid_is_own : 1;          ///< whether the fluid cell is the block's own; else its owner reflects
  double outgoing = 0;            ///< what the fluid sent along the link in the last step
};

/// Links of one image of a bead that are done together.
struct LinkSegment {
  int first, end;  ///< among the links of the image
  int image;       ///< index into CoveredImages::images
};

/// What a scheme needs of the halo.
constexpr HaloContent halo_content(BeadScheme scheme) {
  return cells_behind(scheme) > 1 ? HaloContent::behind : HaloContent::entering;
}

/// All links of a block, by the row at which the step comes to them.
///
/// A link reads and writes places among the incoming populations of its covered cell, of its fluid cell and
/// of the fluid cells behind that the scheme reads; mr also among those of all cells around the fluid cell.
/// Its segment is done just before the first of the segment's rows that the step comes to, so that its
/// populations are on their way into the cache anyway.
///
/// Beads cross a fraction of a cell a step, so that most links are those of the step before.
class BeadLinks {
 public:
  explicit BeadLinks(BeadScheme scheme) : scheme_(scheme) {}

  BeadScheme scheme() const { return scheme_; }

  /// Finds the links for a coverage that has been updated. Those next to rows of which the same image covers
  /// the same cells as before are kept.
  void find(const Coverage& coverage);

  /// Segments, all in the order of the step.
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
    const ImageLinks& of = images_[image];
    const Index3 cell = Index3(x, y, z) - of.box.low;
    const auto visit_in = [&](int segment) {
      for (int n = of.first_of_segment[segment]; n < of.first_of_segment[segment + 1]; ++n) {
        const BeadLink& link = of.links[n];
        if (link.from_low[0] == cell[0] && link.from_low[1] == cell[1] && link.from_low[2] == cell[2])
          visit(link);
      }
    };
    visit_in(of.segment(y, z, 0));
    for (const auto& [dy, dz] : later_rows) visit_in(of.segment(y - dy, z - dz, 1));
  }

 private:
  /// Rows (y + dy, z + dz) after row (y, z), with which its cells have links.
  static constexpr std::array<std::array<int, 2>, 4> later_rows{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

  /// The links of one image in two segments a row: from covered cells of the row to fluid cells of the same
  /// and of later rows (downwards: 0), and from covered cells of later rows to fluid cells of the row (1).
  /// Rows from one before the image's box to its last along z, to one after it along y.
  struct ImageLinks {
    BeadImage box;
    bool is_alone = false;         ///< no other image or wall within reach of its links: its own runs say all
    std::vector<CoveredRun> runs;  ///< from which the links were found
    std::vector<int> first_of_segment;  ///< among the links; one more than segments
    std::vector<int> place_of_segment;  ///< in the order of the step
    std::vector<BeadLink> links;

    int rows_y() const { return box.high[1] - box.low[1] + 2; }
    int segment(int y, int z, int downwards) const {
      return 2 * (y - box.low[1] + 1 + rows_y() * (z - box.low[2] + 1)) + downwards;
    }
  };

  void find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone, ImageLinks& known);
  int place_of_row(int y, int z) const { return y + block_[1] * place_in_order(z, block_[2]); }
  int place_of_segment(int y, int z, int downwards) const;
  template <class Visit>
  void for_each_segment(Visit&& visit) const;
  void sort_by_row();

  BeadScheme scheme_;
  Index3 block_;  ///< its size
  std::vector<ImageLinks> images_;
  std::vector<LinkSegment> by_row_;
  std::vector<int> first_of_row_, next_of_row_;
  std::vector<BeadLink> found_;  ///< of one image, while they are being found
  std::vector<int> first_found_;
};

}  // namespace beadswim
