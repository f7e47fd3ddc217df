#include "beadswim/mobility/near_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {
namespace {

constexpr int stresslets = 5, first_stresslet = 3;
using Stresslet = Eigen::Matrix<double, stresslets, 1>;

/// Returns the matrix from the elements of a velocity gradient to the projections on stresslets.
const Eigen::Matrix<double, stresslets, 9>& strain_projection() {
  static const Eigen::Matrix<double, stresslets, 9> all = [] {
    Eigen::Matrix<double, stresslets, 9> matrix;
    for (int k = 0; k < 9; ++k) {
      double flow[3 * derivative_count(1)]{}, projections[moment_count(1)];
      flow[derivative_count(1) * (k % 3) + 1 + k / 3] = 1;
      project_flow(1, 1, flow, projections);
      matrix.col(k) = Stresslet::Map(projections + first_stresslet);
    }
    return matrix;
  }();
  return all;
}

/// Returns an upper bound of the norm of L, the sum of log S_p and log S_w (near_map.hpp), and of the norm
/// of its transpose. The bound is the largest sum of the norms of the 3 x 3 matrices in one row of L.
double norm_bound(const NearLinks& links) {
  std::vector<double> rows(links.beads, 0.0);
  for (const PairLink& pair : links.pairs) {
    const double row_bound = 2 * std::max(std::abs(pair.own), std::abs(pair.other));
    rows[pair.bead] += row_bound;
    if (!pair.is_image) rows[pair.partner] += row_bound;
  }
  for (const WallLink& wall : links.walls) rows[wall.bead] += std::abs(wall.log);
  return rows.empty() ? 0 : *std::ranges::max_element(rows);
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

NearMap::NearMap(NearLinks links) : links_(std::move(links)) {
  std::vector<int> place(links_.beads, -1);
  const auto place_of = [&](int bead) {
    if (place[bead] < 0) {
      place[bead] = static_cast<int>(linked_beads_.size());
      linked_beads_.push_back(bead);
    }
    return place[bead];
  };
  for (const PairLink& pair : links_.pairs) {
    const int bead = place_of(pair.bead);
    link_ends_.emplace_back(bead, place_of(pair.partner));
  }
  for (const WallLink& wall : links_.walls) wall_ends_.push_back(place_of(wall.bead));
  parts_ = std::max(1, static_cast<int>(std::ceil(norm_bound(links_))));
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
      for (std::size_t p = 0; p < links_.pairs.size(); ++p) {
        const PairLink& pair = links_.pairs[p];
        const auto [bead, partner] = link_ends_[p];
        const double a = pair.axis.dot(term[bead]);
        const double b = pair.axis.dot(pair.mirror.cwiseProduct(term[partner]));
        const auto [increment, partner_increment] = increments(pair, a, b);
        next[bead] += increment * pair.axis;
        if (!pair.is_image) next[partner] += partner_increment * pair.axis;
      }
      for (std::size_t w = 0; w < links_.walls.size(); ++w) {
        const WallLink& wall = links_.walls[w];
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

std::vector<double> NearMap::moments_of(std::span<const Vec3> forces) const {
  std::vector<Vec3> mapped(forces.begin(), forces.end());
  for (const LineLink& line : links_.lines) add_change_of_line(line, line.change, mapped);
  exponentiate(mapped, [](const PairLink& pair, double a, double b) {
    const double increment = pair.own * a + pair.other * b;
    return std::pair(increment, -increment);
  });
  const std::size_t count = moment_count(moment_order());
  std::vector<double> moments(count * mapped.size(), 0.0);
  for (std::size_t b = 0; b < mapped.size(); ++b) Vec3::Map(&moments[count * b]) = mapped[b];
  if (count > first_stresslet) add_stresslets(mapped, moments);
  return moments;
}

/// Adds the stresslets -K F.
void NearMap::add_stresslets(std::span<const Vec3> forces, std::span<double> moments) const {
  const auto gradient = [](const Vec3& axis, double p, double q, const Vec3& force) {
    return Eigen::Matrix3d(axis * (2 * p * force + q * axis.dot(force) * axis).transpose());
  };
  std::vector<Eigen::Matrix3d> gradients(links_.beads, Eigen::Matrix3d::Zero());
  for (const StrainLink& link : links_.strains) {
    gradients[link.bead] +=
        gradient(link.axis, link.p[0], link.q[0], link.mirror.cwiseProduct(forces[link.partner]));
    if (!link.is_image)
      gradients[link.partner] -= gradient(link.axis, link.p[1], link.q[1], forces[link.bead]);
  }
  std::vector<Stresslet> strains(links_.beads);
  for (std::size_t b = 0; b < links_.beads; ++b) strains[b] = strain_projection() * gradients[b].reshaped();
  for (const WallStrainLink& link : links_.wall_strains)
    strains[link.strained] += link.strain * forces[link.forced];
  for (std::size_t b = 0; b < links_.beads; ++b)
    Stresslet::Map(&moments[moment_count(1) * b + first_stresslet]) -= links_.resistances[b] * strains[b];
}

/// Adds -K^T of the projections on stresslets.
void NearMap::add_velocities_by_strains(std::span<const double> projections,
                                        std::span<Vec3> velocities) const {
  std::vector<Stresslet> stresslets_of_flow(links_.beads);
  std::vector<Eigen::Matrix3d> tensors(links_.beads);
  for (std::size_t b = 0; b < links_.beads; ++b) {
    stresslets_of_flow[b] =
        links_.resistances[b] * Stresslet::Map(&projections[moment_count(1) * b + first_stresslet]);
    tensors[b].reshaped() = strain_projection().transpose() * stresslets_of_flow[b];
  }
  const auto velocity = [](const Vec3& axis, double p, double q, const Eigen::Matrix3d& tensor) {
    const Vec3 along = tensor * axis;
    return Vec3(2 * p * along + q * axis.dot(along) * axis);
  };
  for (const StrainLink& link : links_.strains) {
    velocities[link.partner] -=
        link.mirror.cwiseProduct(velocity(link.axis, link.p[0], link.q[0], tensors[link.bead]));
    if (!link.is_image)
      velocities[link.bead] += velocity(link.axis, link.p[1], link.q[1], tensors[link.partner]);
  }
  for (const WallStrainLink& link : links_.wall_strains)
    velocities[link.forced] -= link.strain.transpose() * stresslets_of_flow[link.strained];
}

void NearMap::set_velocities(std::span<const double> moments, std::span<const double> projections,
                             std::span<Vec3> velocities) const {
  const std::size_t count = moment_count(moment_order());
  std::vector<Vec3> forces(velocities.size());
  for (std::size_t b = 0; b < velocities.size(); ++b) {
    forces[b] = Vec3::Map(&moments[count * b]);
    velocities[b] = Vec3::Map(&projections[count * b]);
  }
  if (count > first_stresslet) add_velocities_by_strains(projections, velocities);
  subtract_tow_defects(forces, velocities);
  exponentiate(velocities, [](const PairLink& pair, double a, double b) {
    return std::pair(pair.own * (a - b), pair.other * (a - b));
  });
  for (const LineLink& line : links_.lines) add_change_of_line(line, line.change.transpose(), velocities);
}

void NearMap::subtract_tow_defects(std::span<const Vec3> forces, std::span<Vec3> velocities) const {
  for (const PairLink& pair : links_.pairs) {
    const Vec3 sum = forces[pair.bead] + pair.mirror.cwiseProduct(forces[pair.partner]);
    const Vec3 velocity = pair.tow_defect * pair.axis.dot(sum) * pair.axis;
    velocities[pair.bead] -= velocity;
    if (!pair.is_image) velocities[pair.partner] -= velocity;
  }
  for (const LineLink& line : links_.lines) {
    const Vec3 sum = forces[line.first] + forces[line.first + 1] + forces[line.first + 2];
    for (int b = 0; b < 3; ++b)
      velocities[line.first + b] -= line.tow_defect * line.axis.dot(sum) * line.axis;
  }
}

}  // namespace beadswim
