#include "beadswim/mobility/near_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beadswim {
namespace {

/// No sum over a row's 3 x 3 blocks of their norms, of the exponent or its transpose, is larger.
double norm_bound(std::span<const PairLink> pairs, std::size_t beads) {
  std::vector<double> rows(beads, 0.0);
  for (const PairLink& pair : pairs) {
    const double most = 2 * std::max(std::abs(pair.own), std::abs(pair.other));
    rows[pair.bead] += most;
    if (!pair.is_image) rows[pair.partner] += most;
  }
  return beads == 0 ? 0 : *std::ranges::max_element(rows);
}

double largest(std::span<const Vec3> vectors) {
  double size = 0;
  for (const Vec3& v : vectors) size = std::max(size, v.cwiseAbs().maxCoeff());
  return size;
}

void add_swimmers_change(const SwimmerLink& swimmer, const Eigen::Matrix3d& change, Vec3* beads) {
  Vec3 along;
  for (int b = 0; b < 3; ++b) along[b] = swimmer.axis.dot(beads[b]);
  const Vec3 gained = change * along;
  for (int b = 0; b < 3; ++b) beads[b] += gained[b] * swimmer.axis;
}

}  // namespace

NearMap::NearMap(std::vector<SwimmerLink> swimmers, std::vector<PairLink> pairs)
    : swimmers_(std::move(swimmers)), pairs_(std::move(pairs)) {
  std::vector<int> place(3 * swimmers_.size(), -1);
  const auto place_of = [&](int bead) {
    if (place[bead] < 0) {
      place[bead] = static_cast<int>(linked_.size());
      linked_.push_back(bead);
    }
    return place[bead];
  };
  for (const PairLink& pair : pairs_) {
    const int bead = place_of(pair.bead);
    ends_.emplace_back(bead, place_of(pair.partner));
  }
  parts_ = std::max(1, static_cast<int>(std::ceil(norm_bound(pairs_, place.size()))));
}

/// Taylor's series of exp(L/parts), `parts` times. gains(pair, a, b): of the bead and of its partner.
template <class Gains>
void NearMap::exponentiate(std::span<Vec3> vectors, const Gains& gains) const {
  if (pairs_.empty()) return;
  constexpr int most_terms = 24;  // 1/24! is below roundoff
  constexpr double enough = 1e-17;
  std::vector<Vec3> sum, term, next(linked_.size());
  for (const int bead : linked_) sum.push_back(vectors[bead]);
  for (int part = 0; part < parts_; ++part) {
    term = sum;
    for (int n = 1; n <= most_terms && largest(term) > enough * largest(sum); ++n) {
      std::ranges::fill(next, Vec3::Zero());
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const PairLink& pair = pairs_[p];
        const auto [bead, partner] = ends_[p];
        const double a = pair.axis.dot(term[bead]);
        const double b = pair.axis.dot(pair.mirror.cwiseProduct(term[partner]));
        const auto [gained, partner_gained] = gains(pair, a, b);
        next[bead] += gained * pair.axis;
        if (!pair.is_image) next[partner] += partner_gained * pair.axis;
      }
      for (std::size_t b = 0; b < sum.size(); ++b) {
        term[b] = next[b] / (n * parts_);
        sum[b] += term[b];
      }
    }
  }
  for (std::size_t b = 0; b < sum.size(); ++b) vectors[linked_[b]] = sum[b];
}

void NearMap::map_forces(std::span<Vec3> forces) const {
  for (std::size_t s = 0; s < swimmers_.size(); ++s)
    add_swimmers_change(swimmers_[s], swimmers_[s].change, &forces[3 * s]);
  exponentiate(forces, [](const PairLink& pair, double a, double b) {
    const double gained = pair.own * a + pair.other * b;
    return std::pair(gained, -gained);
  });
}

void NearMap::map_velocities(std::span<Vec3> velocities) const {
  exponentiate(velocities, [](const PairLink& pair, double a, double b) {
    return std::pair(pair.own * (a - b), pair.other * (a - b));
  });
  for (std::size_t s = 0; s < swimmers_.size(); ++s)
    add_swimmers_change(swimmers_[s], swimmers_[s].change.transpose(), &velocities[3 * s]);
}

}  // namespace beadswim
