#include "beadswim/coupling/bead_links.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "beadswim/lattice/d3q19.hpp"

namespace beadswim {
namespace {

/// Finds links from the runs of covered cells of one image and appends them to `links`.
struct LinkFinder {
  const Coverage& coverage;
  const CoveredImage& covered;
  bool is_alone;
  int cells_behind;
  std::vector<BeadLink>& links;

  /// Appends the links from covered cells of row (y, z) to fluid cells of row (y + cy, z + cz).
  void add(int y, int z, int cy, int cz) {
    const CoveredRun run = coverage.images().run(covered, y, z);
    if (run.empty()) return;
    const CoveredRun facing = coverage.images().run(covered, y + cy, z + cz);
    for (int cx = -1; cx <= 1; ++cx) {
      const int out = direction[cx + 1][cy + 1][cz + 1];
      if (out <= 0) continue;  // velocity zero, or no direction of the lattice
      add_cells(run.low, std::min(run.high, facing.low - cx), y, z, out);
      add_cells(std::max(run.low, facing.high - cx), run.high, y, z, out);
    }
  }

 private:
  static constexpr auto direction = [] {
    std::array<std::array<std::array<int, 3>, 3>, 3> table{};
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 3; ++y) {
        for (int z = 0; z < 3; ++z) table[x][y][z] = d3q19::direction_of(x - 1, y - 1, z - 1);
      }
    }
    return table;
  }();

  /// Appends the links along `out` of the covered cells [low, high), whose neighbours along `out` are not
  /// covered by the same image.
  void add_cells(int low, int high, int y, int z, int out) {
    if (low >= high) return;
    const auto& c = d3q19::velocity[out];
    const int fy = y + c[1], fz = z + c[2], cells = coverage.block_size()[0];
    const bool row_is_own = coverage.is_own(0, y, z), fluid_row_is_own = coverage.is_own(0, fy, fz);
    if (!fluid_row_is_own && !(row_is_own && coverage.is_own_or_halo(0, fy, fz))) return;
    const Index3 from_low = Index3(0, y, z) - covered.image.low;
    for (int x = low; x < high; ++x) {
      const int fx = x + c[0];
      const bool fluid_is_own = fluid_row_is_own && fx >= 0 && fx < cells;
      const bool is_own = row_is_own && x >= 0 && x < cells;
      if (!fluid_is_own && !is_own) continue;
      if (!is_alone && coverage.is_covered(fx, fy, fz)) continue;  // covered by another bead
      int fluid_behind = cells_behind;
      if (!is_alone && fluid_is_own) fluid_behind = count_fluid_behind({fx, fy, fz}, {c[0], c[1], c[2]});
      links.push_back(
          {.from_low = {static_cast<std::int16_t>(x + from_low[0]), static_cast<std::int16_t>(from_low[1]),
                        static_cast<std::int16_t>(from_low[2])},
           .out = static_cast<std::uint8_t>(out),
           .fluid_behind = static_cast<std::uint8_t>(fluid_behind),
           .fluid_is_own = fluid_is_own});
    }
  }

  int count_fluid_behind(const Index3& fluid_cell, const Index3& c) const {
    int count = 0;
    while (count < cells_behind && coverage.is_fluid(fluid_cell + (count + 1) * c)) ++count;
    return count;
  }
};

bool same_box(const BeadImage& a, const BeadImage& b) {
  return (a.low == b.low).all() && (a.high == b.high).all();
}

/// Returns a list with one entry per image: true if no other image and no wall can lie within `distance`
/// cells of the cells of the image.
std::vector<bool> images_alone(const Coverage& coverage, int distance) {
  const std::vector<CoveredImage>& images = coverage.images().images;
  std::vector<bool> alone;
  for (const CoveredImage& covered : images) alone.push_back(!coverage.is_near_wall(covered.image, distance));
  for (const auto& [a, b] : coverage.images().close_pairs) {
    if (are_close(images[a].image, images[b].image, distance)) alone[a] = alone[b] = false;
  }
  return alone;
}

}  // namespace

void BeadLinks::find(const Coverage& coverage) {
  block_ = coverage.block_size();
  const std::vector<CoveredImage>& images = coverage.images().images;
  const std::vector<bool> alone = images_alone(coverage, 1 + cells_behind(scheme_));
  images_.resize(images.size());
  sums_.resize(images.empty() ? 0 : images.back().bead + 1);
  for (std::size_t i = 0; i < images.size(); ++i) find_of_image(coverage, images[i], alone[i], images_[i]);
  sort_by_plane();
}

void BeadLinks::find_of_image(const Coverage& coverage, const CoveredImage& covered, bool is_alone,
                              ImageLinks& known) {
  const std::span<const CoveredRun> runs = coverage.images().runs_of(covered);
  const bool keep = known.is_alone && is_alone && same_box(known.box, covered.image);
  if (keep && std::ranges::equal(known.runs, runs)) return;
  const auto changed = [&](int y, int z) {
    const int run = CoveredImages::run_index(covered, y, z);
    return run >= 0 && known.runs[run] != runs[run];
  };

  found_.links.clear();
  found_.first_of_segment.clear();
  found_.plane_of_segment.clear();
  LinkFinder finder{.coverage = coverage,
                    .covered = covered,
                    .is_alone = is_alone,
                    .cells_behind = cells_behind(scheme_),
                    .links = found_.links};
  const BeadImage& box = covered.image;
  for (int z = box.low[2] - 1; z <= box.high[2]; ++z) {
    for (int y = box.low[1] - 1; y <= box.high[1]; ++y) {
      const auto first = std::ssize(found_.links);
      found_.first_of_segment.push_back(static_cast<int>(first));
      const bool kept = keep && std::ranges::none_of(steps_to_rows, [&](const auto& step) {
                          return changed(y + step[0], z + step[1]);
                        });
      if (kept) {
        const int segment = known.segment(y, z);
        found_.links.insert(found_.links.end(), known.links.begin() + known.first_of_segment[segment],
                            known.links.begin() + known.first_of_segment[segment + 1]);
        found_.plane_of_segment.push_back(known.plane_of_segment[segment]);
        continue;
      }
      for (const auto& [cy, cz] : steps_to_rows) finder.add(y - cy, z - cz, cy, cz);
      const std::span links(found_.links.begin() + first, found_.links.end());
      std::ranges::sort(links, {}, [](const BeadLink& link) {
        return std::pair(link.from_low[0] + d3q19::velocity[link.out][0], int{link.out});
      });
      found_.plane_of_segment.push_back(plane_before(z, links));
    }
  }
  found_.first_of_segment.push_back(static_cast<int>(found_.links.size()));
  found_.box = covered.image;
  found_.is_alone = is_alone;
  found_.runs.assign(runs.begin(), runs.end());
  std::swap(known, found_);
}

/// Returns the number in the sweep order of the plane, among all planes whose populations the links of fluid
/// cells in plane z read or write, that the step sweeps first.
int BeadLinks::plane_before(int z, std::span<const BeadLink> links) const {
  int first = std::numeric_limits<int>::max();
  const auto involve = [&](int plane) {
    if (plane >= 0 && plane < block_[2]) first = std::min(first, order_of_plane(plane, block_[2]));
  };
  if (scheme_ == BeadScheme::mr)
    for (const int dz : {-1, 0, 1}) involve(z + dz);
  std::array<bool, 3> is_present{};  // directions with the components -1, 0, 1 along z
  for (const BeadLink& link : links) is_present[d3q19::velocity[link.out][2] + 1] = true;
  for (const int cz : {-1, 0, 1})
    for (int m = -1; m <= cells_behind(scheme_) && is_present[cz + 1]; ++m) involve(z + m * cz);
  return first;
}

/// Calls visit(segment, number of its plane in the sweep order) for all segments that have links.
template <class Visit>
void BeadLinks::for_each_segment(Visit&& visit) const {
  for (int i = 0; i < std::ssize(images_); ++i) {
    const ImageLinks& image_links = images_[i];
    for (std::size_t s = 0; s < image_links.plane_of_segment.size(); ++s) {
      const LinkSegment segment{
          .first = image_links.first_of_segment[s], .end = image_links.first_of_segment[s + 1], .image = i};
      if (segment.first < segment.end) visit(segment, image_links.plane_of_segment[s]);
    }
  }
}

/// Sorts the segments by plane (counting sort).
void BeadLinks::sort_by_plane() {
  first_of_plane_.assign(block_[2] + 1, 0);
  for_each_segment([&](const LinkSegment&, int plane) { ++first_of_plane_[plane]; });
  std::exclusive_scan(first_of_plane_.begin(), first_of_plane_.end(), first_of_plane_.begin(), 0);
  by_plane_.resize(first_of_plane_.back());
  next_of_plane_ = first_of_plane_;
  for_each_segment(
      [&](const LinkSegment& segment, int plane) { by_plane_[next_of_plane_[plane]++] = segment; });
}

}  // namespace beadswim
