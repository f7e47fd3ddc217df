#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// Run of covered cells: the consecutive cells [low, high) of one row that one image of a bead covers, in
/// local coordinates. The run is empty if low >= high.
struct CoveredRun {
  int low = 0, high = 0;

  bool empty() const { return low >= high; }
  bool operator==(const CoveredRun&) const = default;
};

/// One periodic image of a bead and the cells that it covers. Its runs of covered cells are stored in
/// CoveredImages::runs, one run per row of its box.
struct CoveredImage {
  BeadImage image;
  int index;      ///< index of this image in CoveredImages::images
  int bead;       ///< index into the beads passed to Coverage::update()
  Vec3 centre;    ///< centre of the bead, unwrapped [cell]
  double radius;  ///< radius of the bead [cell]
  int first_run;  ///< index in CoveredImages::runs of the first row's run; y varies fastest

  /// Returns the centre of a cell relative to the centre of the bead. It is evaluated in the unwrapped
  /// coordinates of the bead, so that every block gets the same bits.
  Vec3 from_centre(int x, int y, int z) const {
    return {x + image.shift[0] + 0.5 - centre[0], y + image.shift[1] + 0.5 - centre[1],
            z + image.shift[2] + 0.5 - centre[2]};
  }
};

/// Indices of two images, first < second.
struct ImagePair {
  int first, second;
};

/// All images of all beads in the block and in the layers of cells around it, ordered by bead, then by shift.
struct CoveredImages {
  std::vector<CoveredImage> images;
  std::vector<CoveredRun> runs;
  std::vector<ImagePair> close_pairs;  ///< pairs whose boxes are at most `close` apart

  /// Distance up to which the boxes of two images count as close [cell]. It includes all cells that a link
  /// reads, which are up to two cells from its fluid cell, and all gaps in which lubrication acts.
  static constexpr int close = 3;

  /// Returns the runs of an image, row by row.
  std::span<const CoveredRun> runs_of(const CoveredImage& covered) const {
    const Index3 rows = covered.image.high - covered.image.low;
    return std::span(runs).subspan(covered.first_run, rows[1] * rows[2]);
  }

  /// Returns the position of row (y, z) in runs_of(covered), or -1 if the row lies outside the image's box.
  static int run_index(const CoveredImage& covered, int y, int z) {
    const BeadImage& box = covered.image;
    if (y < box.low[1] || y >= box.high[1] || z < box.low[2] || z >= box.high[2]) return -1;
    return y - box.low[1] + (box.high[1] - box.low[1]) * (z - box.low[2]);
  }

  /// Returns the run of an image in row (y, z). It is empty if the row lies outside the box of the image.
  CoveredRun run(const CoveredImage& covered, int y, int z) const {
    const int index = run_index(covered, y, z);
    return index < 0 ? CoveredRun{} : runs[covered.first_run + index];
  }

  /// Calls visit(image, run, y, z) for every row of every image.
  template <class Visit>
  void for_each_run(Visit&& visit) const {
    for (const CoveredImage& covered : images) {
      const BeadImage& box = covered.image;
      for (int z = box.low[2]; z < box.high[2]; ++z) {
        for (int y = box.low[1]; y < box.high[1]; ++y) visit(covered, run(covered, y, z), y, z);
      }
    }
  }
};

/// A cell of the block that the last Coverage::update() has newly covered or uncovered.
struct ChangedCell {
  Index3 local;
  std::ptrdiff_t cell;
  int bead;          ///< index into the beads of the update in which the bead covered the cell
  int image;         ///< index into the images of that update
  Vec3 from_centre;  ///< position relative to the centre of the bead at that update [cell]
};

/// Assigns covered cells to beads, in a block and in two layers of cells around it. A cell is covered if its
/// centre lies inside a bead. Let r be the distance of a cell from the centre of a bead, and R the radius of
/// the bead. A cell in the overlap of two beads belongs to the bead with the smaller r^2 - R^2. This rule
/// divides the overlap along the plane of the circle in which the two surfaces intersect.
class Coverage {
 public:
  Coverage(const BlockInLattice& lattice_block, const Populations& populations);

  /// Number of layers of cells around the block for which the coverage is known.
  static constexpr int margin = 2;

  /// Evaluates the coverage for the present positions of `beads`.
  void update(std::span<const BeadOnLattice> beads);

  bool is_covered(int x, int y, int z) const { return state(x, y, z) == State::covered; }

  /// Returns true if the cell is neither covered nor behind a no-slip wall. A cell behind a free-slip wall
  /// counts as fluid if its mirror image is not covered.
  bool is_fluid(const Index3& cell) const;

  /// Returns true if a cell at most `distance` cells from the box of the image may lie behind a wall.
  bool is_near_wall(const BeadImage& image, int distance) const;

  const CoveredImages& images() const { return now_; }

  /// Return the cells of the block that the last update() has newly covered, or uncovered.
  std::span<const ChangedCell> newly_covered() const { return newly_covered_; }
  std::span<const ChangedCell> uncovered() const { return uncovered_; }

  /// Calls visit(cell, bead index, centre of the cell relative to the centre of the bead) for every covered
  /// cell of the block.
  template <class Visit>
  void for_each_own_covered_cell(Visit&& visit) const {
    now_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int y, int z) {
      for (int x = run.low; x < run.high; ++x) {
        if (is_own(x, y, z)) visit(cell(x, y, z), covered.bead, covered.from_centre(x, y, z));
      }
    });
  }

  bool is_own(int x, int y, int z) const {
    const Index3& n = block_in_lattice_.block.size;
    return x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
  }
  bool is_own_or_halo(int x, int y, int z) const {
    const Index3& n = block_in_lattice_.block.size;
    return x >= -1 && x <= n[0] && y >= -1 && y <= n[1] && z >= -1 && z <= n[2];
  }

  std::ptrdiff_t cell(int x, int y, int z) const { return origin_ + x + pitch_y_ * y + pitch_z_ * z; }
  const Index3& block_size() const { return block_in_lattice_.block.size; }

  /// Returns the index of the cell from which populations of `cell`, with the local coordinate x, must be
  /// read. If x is periodic and not divided among ranks (RowEnds::wrapped) and `cell` lies beyond an end of
  /// its row, this is the cell of the row whose periodic image is `cell`, because not all populations of the
  /// halo are filled there. Otherwise it is `cell` itself.
  std::ptrdiff_t wrapped_along_x(std::ptrdiff_t cell, int x) const {
    const int cells = block_in_lattice_.block.size[0];
    if (!block_in_lattice_.is_periodic(0) || cells != block_in_lattice_.cells[0] || (x >= 0 && x < cells))
      return cell;
    return x < 0 ? cell + cells : cell - cells;
  }

 private:
  /// State of a cell during update(). just_left: the cell was covered before this update, and no bead has
  /// been found yet that covers it now.
  enum class State : std::uint8_t { fluid, covered, just_left };

  std::size_t place_of_state(int x, int y, int z) const {
    const Index3& n = block_in_lattice_.block.size;
    return x + margin +
           (n[0] + 2 * margin) * (y + margin + static_cast<std::size_t>(n[1] + 2 * margin) * (z + margin));
  }
  State state(int x, int y, int z) const { return state_[place_of_state(x, y, z)]; }
  State& state(int x, int y, int z) { return state_[place_of_state(x, y, z)]; }

  ChangedCell changed_cell(const CoveredImage& covered, int x, int y, int z) const {
    return {.local = {x, y, z},
            .cell = cell(x, y, z),
            .bead = covered.bead,
            .image = covered.index,
            .from_centre = covered.from_centre(x, y, z)};
  }
  void find_runs(std::span<const BeadOnLattice> beads);
  void part(const CoveredImage& first, const CoveredImage& second);
  void cover_run(const CoveredImage& covered, const CoveredRun& run, int y, int z);

  BlockInLattice block_in_lattice_;
  std::ptrdiff_t pitch_y_, pitch_z_, origin_;
  std::vector<State> state_;  ///< one byte per cell, x fastest
  CoveredImages now_, before_;
  std::vector<ChangedCell> newly_covered_, uncovered_;
};

}  // namespace beadswim
