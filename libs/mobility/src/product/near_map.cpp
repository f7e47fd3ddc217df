#include "beadswim/mobility/near_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beadswim {
namespace {

/// Returns an upper bound of the norm of L, the sum of log S_p and log S_w (near_map.hpp), and of the norm
/// of its transpose. The bound is the largest sum of the norms of the 3 x 3 matrices in one row of L.
double norm_bound(std::span<const PairLink> pairs, std::span<const WallLink> walls, std::size_t beads) {
  std::vector<double> rows(beads, 0.0);
  for (const PairLink& pair : pairs) {
    const double row_bound = 2 * std::max(std::abs(pair.own), std::abs(pair.other));
    rows[pair.bead] += row_bound;
    if (!pair.is_image) rows[pair.partner] += row_bound;
  }
  for (const WallLink& wall : walls) rows[wall.bead] += std::abs(wall.log);
  return beads == 0 ? 0 : *std::ranges::max_element(rows);
}

double max_component(std::span<const Vec3> vectors) {
  double size = 0;
  for (const Vec3& v : vectors) size = std::max(size, v.cwiseAbs().maxCoeff());
  return size;
}

void add_change_of_line(const LineLink& line, const Eigen::Matrix3d& change, std::span<Vec3> vectors) {
  Vec3* const beads = &vectors[line.first];
  Vec3 along;
  for (int b = 0; b < 3; ++b) along[b] = line.axis.dot(beads[b]);
  const Vec3 increment = change * along;
  for (int b = 0; b < 3; ++b) beads[b] += increment[b] * line.axis;
}

}  // namespace

NearMap::NearMap(std::vector<LineLink> lines, std::vector<PairLink> pairs, std::vector<WallLink> walls,
                 std::size_t beads)
    : lines_(std::move(lines)), pairs_(std::move(pairs)), walls_(std::move(walls)) {
  std::vector<int> place(beads, -1);
  const auto place_of = [&](int bead) {
    if (place[bead] < 0) {
      place[bead] = static_cast<int>(linked_beads_.size());
      linked_beads_.push_back(bead);
    }
    return place[bead];
  };
  for (const PairLink& pair : pairs_) {
    const int bead = place_of(pair.bead);
    link_ends_.emplace_back(bead, place_of(pair.partner));
  }
  for (const WallLink& wall : walls_) wall_ends_.push_back(place_of(wall.bead));
  parts_ = std::max(1, static_cast<int>(std::ceil(norm_bound(pairs_, walls_, beads))));
}

/// Applies exp(L/parts_), evaluated as a Taylor series, `parts_` times to the vectors of the beads. L is the
/// sum of log S_p and log S_w (near_map.hpp). increments(pair, a, b) returns the contributions of a pair
/// to the products of L and the vectors, for the bead and for its partner, along the axis of the pair. a and
/// b are the components of the vectors of the bead and of the partner along this axis.
template <class PairAction>
void NearMap::exponentiate(std::span<Vec3> vectors, const PairAction& increments) const {
  if (linked_beads_.empty()) return;
  constexpr int max_terms = 24;  // 1/24! is below roundoff
  constexpr double truncation = 1e-17;
  std::vector<Vec3> sum, term, next(linked_beads_.size());
  for (const int bead : linked_beads_) sum.push_back(vectors[bead]);
  for (int part = 0; part < parts_; ++part) {
    term = sum;
    for (int n = 1; n <= max_terms && max_component(term) > truncation * max_component(sum); ++n) {
      std::ranges::fill(next, Vec3::Zero());
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const PairLink& pair = pairs_[p];
        const auto [bead, partner] = link_ends_[p];
        const double a = pair.axis.dot(term[bead]);
        const double b = pair.axis.dot(pair.mirror.cwiseProduct(term[partner]));
        const auto [increment, partner_increment] = increments(pair, a, b);
        next[bead] += increment * pair.axis;
        if (!pair.is_image) next[partner] += partner_increment * pair.axis;
      }
      for (std::size_t w = 0; w < walls_.size(); ++w) {
        const WallLink& wall = walls_[w];
        next[wall_ends_[w]] += wall.log * wall.normal.dot(term[wall_ends_[w]]) * wall.normal;
      }
      for (std::size_t b = 0; b < sum.size(); ++b) {
        term[b] = next[b] / (n * parts_);
        sum[b] += term[b];
      }
    }
  }
  for (std::size_t b = 0; b < sum.size(); ++b) vectors[linked_beads_[b]] = sum[b];
}

void NearMap::map_forces(std::span<Vec3> forces) const {
  for (const LineLink& line : lines_) add_change_of_line(line, line.change, forces);
  exponentiate(forces, [](const PairLink& pair, double a, double b) {
    const double increment = pair.own * a + pair.other * b;
    return std::pair(increment, -increment);
  });
}

void NearMap::map_velocities(std::span<Vec3> velocities) const {
  exponentiate(velocities, [](const PairLink& pair, double a, double b) {
    return std::pair(pair.own * (a - b), pair.other * (a - b));
  });
  for (const LineLink& line : lines_) add_change_of_line(line, line.change.transpose(), velocities);
}

}  // namespace beadswim
