#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "beadswim/coupling/bead_images.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {

/// The cells [low, high) of a row, in local coordinates, that one image of a bead covers; none if low ==
/// high.
struct CoveredRun {
  int low = 0, high = 0;

  bool empty() const { return low >= high; }
  bool operator==(const CoveredRun&) const = default;
};

/// One image of a bead with all its runs.
struct CoveredImage {
  BeadImage image;
  int index;      ///< among the images
  int bead;       ///< index into the beads of the update
  Vec3 centre;    ///< of the bead, unwrapped
  double radius;  ///< likewise
  int first_run;  ///< of the row (image.low[1], image.low[2]); y fastest

  /// Centre of a cell relative to that of the bead. From whole numbers in the bead's own coordinates: the
  /// same bits whichever block asks.
  Vec3 from_centre(int x, int y, int z) const {
    return {x + image.shift[0] + 0.5 - centre[0], y + image.shift[1] + 0.5 - centre[1],
            z + image.shift[2] + 0.5 - centre[2]};
  }
};

/// Two images, by their indices, the first the smaller.
struct ImagePair {
  int first, second;
};

/// All images of all beads, in order of the beads and of their shifts.
struct CoveredImages {
  std::vector<CoveredImage> images;
  std::vector<CoveredRun> runs;
  std::vector<ImagePair> close_pairs;  ///< those whose boxes of cells are within `close` cells

  /// Cells between boxes of images that are close: enough for links that read two cells behind their own,
  /// and for the range of lubrication.
  static constexpr int close = 3;

  /// The runs of an image, row by row.
  std::span<const CoveredRun> runs_of(const CoveredImage& covered) const {
    const Index3 rows = covered.image.high - covered.image.low;
    return std::span(runs).subspan(covered.first_run, rows[1] * rows[2]);
  }

  /// Index of row (y, z) among the runs of an image; -1 outside it.
  static int run_index(const CoveredImage& covered, int y, int z) {
    const BeadImage& box = covered.image;
    if (y < box.low[1] || y >= box.high[1] || z < box.low[2] || z >= box.high[2]) return -1;
    return y - box.low[1] + (box.high[1] - box.low[1]) * (z - box.low[2]);
  }

  /// The row (y, z) of an image; empty outside it.
  CoveredRun run(const CoveredImage& covered, int y, int z) const {
    const int index = run_index(covered, y, z);
    return index < 0 ? CoveredRun{} : runs[covered.first_run + index];
  }
  /// The same of a row within the image's box.
  CoveredRun& run_within(const CoveredImage& covered, int y, int z) {
    return runs[covered.first_run + run_index(covered, y, z)];
  }

  /// Calls visit(image, run, y, z).
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

/// A cell of the block that has come to be covered, or no longer is.
struct ChangedCell {
  Index3 local;
  std::ptrdiff_t cell;
  int bead;          ///< index into the beads of the update that covered it
  int image;         ///< index into the images of that update
  Vec3 from_centre;  ///< at that update
};

/// The staircase: which cells of a block, and of two cells around it, are covered by which bead. A cell is
/// covered if its centre lies inside the bead; where beads overlap, by the one with the smaller r^2 - R^2,
/// which parts them along the plane through the circle in which they meet.
class Coverage {
 public:
  Coverage(const BlockInLattice& at, const Populations& populations);

  /// How many cells around the block it knows.
  static constexpr int margin = 2;

  /// Covers anew for the beads where they are now.
  void update(std::span<const BeadOnLattice> beads);

  bool is_covered(int x, int y, int z) const { return state(x, y, z) == State::covered; }

  /// Whether there is fluid, or its mirror image behind a free-slip wall: neither a bead nor the outside of a
  /// no-slip wall.
  bool is_fluid(const Index3& cell) const;

  /// Whether cells within `distance` of the image's may lie outside a wall.
  bool is_near_wall(const BeadImage& image, int distance) const;

  const CoveredImages& images() const { return now_; }

  /// What the last update changed.
  std::span<const ChangedCell> newly_covered() const { return newly_covered_; }
  std::span<const ChangedCell> uncovered() const { return uncovered_; }

  /// Calls visit(cell, bead index, centre of the cell relative to the bead's) for every own covered cell.
  template <class Visit>
  void for_each_own_covered_cell(Visit&& visit) const {
    now_.for_each_run([&](const CoveredImage& covered, const CoveredRun& run, int y, int z) {
      for (int x = run.low; x < run.high; ++x) {
        if (is_own(x, y, z)) visit(cell(x, y, z), covered.bead, covered.from_centre(x, y, z));
      }
    });
  }

  bool is_own(int x, int y, int z) const {
    const Index3& n = at_.block.size;
    return x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
  }
  bool is_own_or_halo(int x, int y, int z) const {
    const Index3& n = at_.block.size;
    return x >= -1 && x <= n[0] && y >= -1 && y <= n[1] && z >= -1 && z <= n[2];
  }

  std::ptrdiff_t cell(int x, int y, int z) const { return origin_ + x + pitch_y_ * y + pitch_z_ * z; }
  const Index3& block_size() const { return at_.block.size; }

  /// `cell`, whose local coordinate is x; or, beyond the ends of a row that wraps around within the block
  /// (RowEnds::wrapped), the cell of the row that it is an image of.
  std::ptrdiff_t wrapped_along_x(std::ptrdiff_t cell, int x) const {
    const int cells = at_.block.size[0];
    if (!at_.is_periodic(0) || cells != at_.cells[0] || (x >= 0 && x < cells)) return cell;
    return x < 0 ? cell + cells : cell - cells;
  }

 private:
  enum class State : std::uint8_t { fluid, covered, just_left };

  std::size_t place_of_state(int x, int y, int z) const {
    const Index3& n = at_.block.size;
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

  BlockInLattice at_;
  std::ptrdiff_t pitch_y_, pitch_z_, origin_;
  std::vector<State> state_;  ///< of every cell, x fastest: a byte beside its 19 populations
  CoveredImages now_, before_;
  std::vector<ChangedCell> newly_covered_, uncovered_;
};

}  // namespace beadswim
