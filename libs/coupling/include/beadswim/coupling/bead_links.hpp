#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/coupling/coverage.hpp"
#include "beadswim/coupling/impulse_sums.hpp"
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

/// Evaluates the returned mass: the fluid mass that each link of a bead returns to the fluid in one step,
/// divided by the weight w_i of the link. held_mass: fluid mass beyond density 1 that the bead has taken up.
/// link_weight: sum of w_i over all links of the bead; 0 if the bead has no links.
///
/// The bead returns a tenth of held_mass per step, in proportion to the weights w_i. The returned mass
/// changes the mass that interpolated links take up in the following steps. If the bead returned all of
/// held_mass in one step, held_mass would therefore change its sign and grow from step to step.
constexpr double returned_mass(double held_mass, double link_weight) {
  constexpr double returned_part = 0.1;
  return link_weight > 0 ? returned_part * held_mass / link_weight : 0;
}

/// All links of a block, in segments. A segment contains the links of the fluid cells of one row.
///
/// A link reads and writes incoming populations of its covered cell, of its fluid cell and of the cells
/// behind that the scheme reads. The scheme mr also reads incoming populations of all cells around the fluid
/// cell. The step processes a segment just before it sweeps the first plane whose populations the segment
/// uses. The populations that the segment loads into the cache are then used by the sweep.
///
/// A bead moves by a fraction of a cell per step. Most links therefore remain unchanged from one step to the
/// next.
class BeadLinks {
 public:
  /// `rates`: relaxation rates of the fluid.
  BeadLinks(BeadScheme scheme, const RelaxationRates& rates) : scheme_(scheme), rates_(rates) {}

  BeadScheme scheme() const { return scheme_; }

  /// Finds the links after an update of the coverage. Does not search again for links next to rows in which
  /// an image covers the same cells as before.
  void find(const Coverage& coverage);

  /// Bounces populations back at all links that must be processed before plane z of the block is swept (laws:
  /// link_laws.hpp). step_fluid() must call this function before each plane, in the order in which it sweeps
  /// the planes. The links then need only halo cells that are already filled. `coverage` and `beads`: those
  /// for which the links were found; adds to the stress of their impulse.
  void bounce_back_before_plane(Populations& populations, const Coverage& coverage,
                                std::span<BeadOnLattice> beads, int z);

  /// Adds the impulse, angular impulse, fluid mass and link weight that each bead has received from its links
  /// since the last call to BeadOnLattice::impulse.
  void transfer_impulses(std::span<BeadOnLattice> beads);

  /// Transfers mass and momentum between beads and fluid in the cells that the last Coverage::update() has
  /// changed. A bead takes up the momentum and mass of the fluid in newly covered cells. Uncovered cells are
  /// refilled with fluid (refill.hpp), and the bead loses the momentum and mass that they receive (Aidun, Lu
  /// & Ding 1998, section 3.3). Call it before find(). `beads`: beads of the last update; `beads_before`:
  /// beads of the update before it. Throws FaultError if a bead that has uncovered cells is no longer in
  /// `beads`, because it moved too far from the block in one step.
  void transfer_changed_cells(Populations& populations, const Coverage& coverage,
                              std::span<const BeadOnLattice> beads_before,
                              std::span<BeadOnLattice> beads) const;

  /// Returns all segments in the order in which the step processes them.
  std::span<const LinkSegment> segments() const { return by_plane_; }

  /// Returns the segments that the step processes before it sweeps plane z of the block.
  std::span<const LinkSegment> segments_before(int z) const {
    const int plane = order_of_plane(z, block_[2]), first = first_of_plane_[plane];
    return segments().subspan(first, first_of_plane_[plane + 1] - first);
  }

  std::span<BeadLink> links(const LinkSegment& segment) {
    return std::span(images_[segment.image].links).subspan(segment.first, segment.end - segment.first);
  }

  /// Calls visit(link) for every link of the covered cell (x, y, z) of the image with index `image`.
  template <class Visit>
  void for_each_link_of(int image, int x, int y, int z, Visit&& visit) const {
    const ImageLinks& image_links = images_[image];
    const Index3 cell = Index3(x, y, z) - image_links.box.low;
    for (const auto& [cy, cz] : steps_to_rows) {
      const int segment = image_links.segment(y + cy, z + cz);
      for (int n = image_links.first_of_segment[segment]; n < image_links.first_of_segment[segment + 1];
           ++n) {
        const BeadLink& link = image_links.links[n];
        if (link.from_low[0] == cell[0] && link.from_low[1] == cell[1] && link.from_low[2] == cell[2])
          visit(link);
      }
    }
  }

 private:
  /// Steps (y, z) from a row to itself and to the rows that links can join with it.
  static constexpr std::array<std::array<int, 2>, 9> steps_to_rows{
      {{0, 0}, {-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

  /// The links of one image. A segment contains the links of all fluid cells of one row, in the order of x,
  /// so that the links of a fluid cell follow each other. If the box of the image is [low, high), the rows
  /// have low - 1 <= y, z <= high.
  struct ImageLinks {
    BeadImage box;
    bool is_alone = false;         ///< true if no other image and no wall can affect the links
    std::vector<CoveredRun> runs;  ///< covered cells of each row, from which the links were found
    /// Index of the first link of each segment. The last entry is the number of links.
    std::vector<int> first_of_segment;
    /// Number in the sweep order, order_of_plane(), of the plane before which each segment is processed.
    std::vector<int> plane_of_segment;
    std::vector<BeadLink> links;

    int rows_y() const { return box.high[1] - box.low[1] + 2; }
    int segment(int y, int z) const { return y - box.low[1] + 1 + rows_y() * (z - box.low[2] + 1); }
  };

  void find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone, ImageLinks& known);
  int plane_before(int z, std::span<const BeadLink> links) const;
  template <class Visit>
  void for_each_segment(Visit&& visit) const;
  void sort_by_plane();

  BeadScheme scheme_;
  RelaxationRates rates_;
  Index3 block_;                ///< size of the block
  std::vector<LinkSums> sums_;  ///< one per bead; zero between steps
  std::vector<ImageLinks> images_;
  std::vector<LinkSegment> by_plane_;
  std::vector<int> first_of_plane_, next_of_plane_;
  ImageLinks found_;  ///< links of one image during the search
};

}  // namespace beadswim
