#include "beadswim/coupling/bead_links.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <tuple>

namespace beadswim::test {
namespace {

const Index3 lattice(22, 15, 13);

/// Size of a block of lattice cells, and the boundaries of the lattice.
struct Shape {
  Block block;
  std::array<Boundary, 3> boundary;
};
const std::array shapes{Shape{{.offset = {0, 4, 3}, .size = {22, 7, 6}}, {}},
                        Shape{{.offset = {7, 0, 3}, .size = {8, 15, 6}}, {}},
                        Shape{{.offset = {0, 5, 0}, .size = {22, 1, 13}}, {}},
                        Shape{{.offset = {0, 0, 9}, .size = {22, 15, 1}}, {}},
                        Shape{{.offset = {21, 0, 0}, .size = {1, 15, 13}}, {}},
                        Shape{{.offset = {0, 8, 6}, .size = {22, 7, 7}},
                              {Boundary::periodic, Boundary::free_slip, Boundary::free_slip}}};

/// Link as found by the search: covered cell, direction, whether the fluid cell is in this block, and, if it
/// is, how many cells behind it are fluid, as far as the scheme of the bead boundary reads.
using Link = std::tuple<int, int, int, int, bool, int>;

/// Returns two beads at random positions, away from walls. In every third scene the beads are almost in
/// contact.
std::vector<BeadOnLattice> random_beads(unsigned seed, const std::array<Boundary, 3>& boundary) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 1), radius(1.1, 3.4);
  std::vector<BeadOnLattice> beads;
  for (int b = 0; b < 2; ++b) {
    BeadOnLattice bead;
    bead.name = {0, b};
    bead.radius = radius(random);
    for (int a = 0; a < 3; ++a) {
      const double low = boundary[a] == Boundary::periodic ? -5 : bead.radius + 0.6;
      const double high = boundary[a] == Boundary::periodic ? 25 : lattice[a] - bead.radius - 0.6;
      bead.motion.position[a] = low + (high - low) * part(random);
    }
    beads.push_back(bead);
  }
  if (seed % 3 == 0 && boundary[1] == Boundary::periodic) {
    const Vec3 apart = (Vec3(part(random), part(random), part(random)) - Vec3::Constant(0.5)).normalized();
    beads[1].motion.position = beads[0].motion.position + (beads[0].radius + beads[1].radius + 0.8) * apart;
  }
  return beads;
}

/// Returns the bead that covers the cell with these global coordinates, found by the distance to the nearest
/// image; -1 if no bead covers it.
int covering_bead(const std::vector<BeadOnLattice>& beads, const Index3& cell,
                  const std::array<Boundary, 3>& boundary) {
  for (int b = 0; b < std::ssize(beads); ++b) {
    Vec3 apart = cell.cast<double>() + 0.5 - beads[b].motion.position.array();
    for (int a = 0; a < 3; ++a) {
      if (boundary[a] == Boundary::periodic) apart[a] -= lattice[a] * std::round(apart[a] / lattice[a]);
    }
    if (apart.norm() < beads[b].radius) return b;
  }
  return -1;
}

/// Returns the mirror image of a cell that lies behind a wall, and every other cell unchanged.
Index3 before_mirror(Index3 cell, const std::array<Boundary, 3>& boundary) {
  for (int a = 0; a < 3; ++a) {
    if (boundary[a] == Boundary::periodic) continue;
    if (cell[a] < 0) cell[a] = -1 - cell[a];
    if (cell[a] >= lattice[a]) cell[a] = 2 * lattice[a] - 1 - cell[a];
  }
  return cell;
}

std::set<Link> links_by_search(const std::vector<BeadOnLattice>& beads, const Shape& shape,
                               BeadScheme scheme) {
  const Block& block = shape.block;
  const auto is_own = [&](const Index3& p) { return (p >= 0).all() && (p < block.size).all(); };
  std::set<Link> links;
  for (int z = -1; z <= block.size[2]; ++z) {
    for (int y = -1; y <= block.size[1]; ++y) {
      for (int x = -1; x <= block.size[0]; ++x) {
        const Index3 p(x, y, z);
        if (covering_bead(beads, p + block.offset, shape.boundary) < 0) continue;
        for (int out = 1; out < d3q19::directions; ++out) {
          const auto& c = d3q19::velocity[out];
          const Index3 q = p + Index3(c[0], c[1], c[2]);
          if (!is_own(p) && !is_own(q)) continue;
          if (covering_bead(beads, q + block.offset, shape.boundary) >= 0) continue;
          const auto is_fluid = [&](int on) {
            const Index3 behind = q + block.offset + on * Index3(c[0], c[1], c[2]);
            return covering_bead(beads, before_mirror(behind, shape.boundary), shape.boundary) < 0;
          };
          int behind = 0;
          if (is_own(q)) {
            while (behind < cells_behind(scheme) && is_fluid(behind + 1)) ++behind;
          }
          links.insert({x, y, z, out, is_own(q), behind});
        }
      }
    }
  }
  return links;
}

/// Two beads in a block of cells, and their links.
struct Scene {
  Scene(unsigned seed, const Shape& shape, BeadScheme scheme)
      : shape(shape),
        beads(random_beads(seed, shape.boundary)),
        at{.block = shape.block, .cells = lattice, .boundary = shape.boundary},
        populations(at.block.size),
        coverage(at, populations),
        links(scheme, relaxation_rates(1)) {
    // Replaces scenes in which the beads overlap.
    for (unsigned other = seed + 999; !covers(); other += 3) beads = random_beads(other, shape.boundary);
    links.find(coverage);
  }

  bool covers() {
    try {
      coverage = Coverage(at, populations);
      coverage.update(beads);
    } catch (const std::runtime_error&) {
      return false;
    }
    return true;
  }

  Shape shape;
  std::vector<BeadOnLattice> beads;
  BlockInLattice at;
  Populations populations;
  Coverage coverage;
  BeadLinks links;
};

/// Returns the links of a segment with the local coordinates of their covered cells.
std::vector<Link> links_of(BeadLinks& links, const LinkSegment& at, const Coverage& coverage) {
  const Index3& low = coverage.images().images[at.image].image.low;
  std::vector<Link> found;
  for (const BeadLink& link : links.links(at)) {
    const auto& [x, y, z] = link.from_low;
    found.push_back({low[0] + x, low[1] + y, low[2] + z, link.out, link.fluid_is_own,
                     link.fluid_is_own ? link.fluid_behind : 0});
  }
  return found;
}

class BeadLinksIn : public testing::TestWithParam<std::tuple<Shape, BeadScheme>> {
 protected:
  /// Calls check(scene) for the scenes with the seeds 1 to 30.
  template <class Check>
  void for_each_scene(Check&& check) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
      SCOPED_TRACE(seed);
      Scene scene(seed, std::get<Shape>(GetParam()), std::get<BeadScheme>(GetParam()));
      check(scene);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Shapes, BeadLinksIn,
                         testing::Combine(testing::ValuesIn(shapes),
                                          testing::Values(BeadScheme::staircase, BeadScheme::cli,
                                                          BeadScheme::mr)));

// Catches a row, an image or a seam whose links are missed, found twice, or given to the wrong owner.
TEST_P(BeadLinksIn, AreAllLinksBetweenCoveredAndFluidCells) {
  for_each_scene([](Scene& scene) {
    std::multiset<Link> found;
    for (std::size_t s = 0; s < scene.links.segments().size(); ++s) {
      for (const Link& link : links_of(scene.links, scene.links.segments()[s], scene.coverage))
        found.insert(link);
    }
    const std::set<Link> expected = links_by_search(scene.beads, scene.shape, scene.links.scheme());
    EXPECT_EQ(found, std::multiset<Link>(expected.begin(), expected.end()));
  });
}

// Catches links that are kept although cells have changed hands: of the bead, or of one that came near it.
TEST_P(BeadLinksIn, OfBeadsThatMovedAreThoseFoundAnew) {
  for_each_scene([](Scene& scene) {
    const Vec3 v(0.11, -0.06, 0.08);
    for (int step = 0; step < 12; ++step) {
      const std::vector<BeadOnLattice> before = scene.beads;
      scene.beads[0].motion.position += v;
      if (step < 6) scene.beads[1].motion.position -= 0.5 * v;  // then it stays
      if (!scene.covers()) {                                    // they would overlap
        scene.beads = before;
        ASSERT_TRUE(scene.covers());
      }
      scene.links.find(scene.coverage);
      BeadLinks anew(scene.links.scheme(), relaxation_rates(1));
      anew.find(scene.coverage);
      ASSERT_EQ(scene.links.segments().size(), anew.segments().size()) << step;
      for (std::size_t s = 0; s < anew.segments().size(); ++s) {
        ASSERT_EQ(links_of(scene.links, scene.links.segments()[s], scene.coverage),
                  links_of(anew, anew.segments()[s], scene.coverage))
            << step;
      }
    }
  });
}

// What lets links be done plane by plane: none comes after the sweep of a row that it reads from or writes
// to, or before messages for the halo across z have arrived.
TEST_P(BeadLinksIn, ComeBeforeTheSweepOfTheirPlanes) {
  for_each_scene([](Scene& scene) {
    const Index3& n = scene.at.block.size;
    std::set<std::pair<int, int>> swept;
    for (int k = 0; k < n[2]; ++k) {
      const int z = plane_in_order(k, n[2]);
      const bool halo_is_filled = k >= first_outer_plane(n[2]);
      for (const LinkSegment& segment : scene.links.segments_before(z)) {
        for (const auto& [link_x, link_y, link_z, out, own, behind] :
             links_of(scene.links, segment, scene.coverage)) {
          const auto& c = d3q19::velocity[out];
          const bool is_mr = scene.links.scheme() == BeadScheme::mr;  // has all of its halo from the start
          for (int m = 0; m <= behind + 1; ++m) {
            const int row_y = link_y + m * c[1], row_z = link_z + m * c[2];
            EXPECT_FALSE(swept.contains({row_y, row_z}));
            EXPECT_TRUE(is_mr || halo_is_filled || (row_z >= 0 && row_z < n[2]));
          }
          if (!is_mr || !own) continue;
          for (int i = 0; i < d3q19::directions; ++i) {  // all that leaves the fluid cell
            const auto& d = d3q19::velocity[i];
            EXPECT_FALSE(swept.contains({link_y + c[1] + d[1], link_z + c[2] + d[2]}));
          }
        }
      }
      for (int y = 0; y < n[1]; ++y) swept.insert({y, z});
    }
    EXPECT_EQ(std::ssize(swept), n[1] * n[2]);
  });
}

// The momentum of a fluid cell is evaluated once for links that follow each other, and one address per
// segment.
TEST_P(BeadLinksIn, OfASegmentHaveTheirFluidCellsInOneRowInOrder) {
  for_each_scene([](Scene& scene) {
    for (const LinkSegment& segment : scene.links.segments()) {
      std::vector<std::array<int, 3>> cells;  // z, y, x
      for (const auto& [x, y, z, out, own, behind] : links_of(scene.links, segment, scene.coverage)) {
        const auto& c = d3q19::velocity[out];
        cells.push_back({z + c[2], y + c[1], x + c[0]});
      }
      ASSERT_TRUE(std::ranges::is_sorted(cells));
      ASSERT_EQ(cells.front()[0], cells.back()[0]);
      ASSERT_EQ(cells.front()[1], cells.back()[1]);
    }
  });
}

// Catches a link of a cell that is looked for in the wrong rows.
TEST_P(BeadLinksIn, OfACellAreFoundFromTheCell) {
  for_each_scene([](Scene& scene) {
    std::size_t found = 0, all = 0;
    for (const LinkSegment& segment : scene.links.segments()) all += segment.end - segment.first;
    for (const CoveredImage& covered : scene.coverage.images().images) {
      const BeadImage& box = covered.image;
      for (int z = box.low[2]; z < box.high[2]; ++z) {
        for (int y = box.low[1]; y < box.high[1]; ++y) {
          const CoveredRun run = scene.coverage.images().run(covered, y, z);
          for (int x = run.low; x < run.high; ++x) {
            scene.links.for_each_link_of(covered.index, x, y, z, [&](const BeadLink&) { ++found; });
          }
        }
      }
    }
    EXPECT_EQ(found, all);
  });
}

}  // namespace
}  // namespace beadswim::test
