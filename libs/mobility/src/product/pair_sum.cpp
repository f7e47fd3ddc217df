#include "pair_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "moment_flow.hpp"
#include "moment_radials.hpp"

namespace beadswim {
PairSum::PairSum(const ImagedSpheres& spheres, const std::optional<EwaldPlan>& plan, double min_distance)
    : spheres_(spheres), is_positive_(plan && plan->is_positive) {
  if (plan) split_.emplace(plan->cutoff, plan->shape);
  if (plan && spheres.order == 0) table_.emplace(spheres, *plan, min_distance);
}

void PairSum::set_positions(std::span<const Vec3> positions, std::size_t receivers) {
  if (split_) {
    cells_.emplace(positions, split_->cutoff, spheres_.lengths, 1);
    order_ = cells_->order();
  } else {
    order_.resize(positions.size());
    std::iota(order_.begin(), order_.end(), 0);
  }
  sums_ = 0;
  neighbour_list_.clear();
  neighbour_ranges_.clear();
  for (auto& coordinate : coordinates_) coordinate.clear();
  is_receiver_.clear();
  radii_.clear();
  squares_.clear();
  for (const int sphere : order_) {
    for (int a = 0; a < 3; ++a) coordinates_[a].push_back(positions[sphere][a]);
    is_receiver_.push_back(static_cast<std::size_t>(sphere) < receivers ? 1 : 0);
    radii_.push_back(spheres_.radii[sphere]);
    squares_.push_back(radii_.back() * radii_.back());
  }
}

/// Sources and flows of all spheres, in the order of the sum, and the current pairs of one sphere.
struct PairSum::Work {
  std::vector<double> sources, flows;
  /// Of the table: forces and velocities of all spheres, by component.
  std::array<std::vector<double>, 3> forces, velocities;
  SourceLanes pairs{};
  double at_others[max_elements][lanes];
  int count = 0;  ///< lanes in use
  int one = 0;    ///< the one sphere of the pairs
  std::array<int, lanes> other{};
  std::array<bool, lanes> overlaps{};  ///< true if the two spheres of a lane overlap
};

void PairSum::add_flows(std::span<const double> sources, std::span<double> flows,
                        const Communicator& communicator) {
  const std::size_t n = spheres_.elements();
  Work work;  // its large arrays are not initialised
  work.sources.resize(sources.size());
  work.flows.resize(sources.size(), 0.0);
  for (std::size_t s = 0; s < order_.size(); ++s)
    std::copy_n(&sources[n * order_[s]], n, &work.sources[n * s]);
  for (int a = 0; a < 3 && table_; ++a) {
    for (std::size_t s = 0; s < order_.size(); ++s) work.forces[a].push_back(work.sources[3 * s + a]);
    work.velocities[a].assign(order_.size(), 0.0);
  }
  cells_ ? add_near_pairs(work, communicator) : add_all_pairs(work, communicator);
  flush(work);
  for (std::size_t s = 0; s < order_.size(); ++s) {
    if (is_receiver_[s] == 0) continue;
    for (std::size_t k = 0; k < n; ++k)
      flows[n * order_[s] + k] += work.flows[n * s + k] + (table_ ? work.velocities[k][s] : 0);
  }
}

/// Adds this rank's share of all pairs.
void PairSum::add_all_pairs(Work& work, const Communicator& communicator) const {
  const auto& [x, y, z] = coordinates_;
  for (int i = communicator.rank(); i < std::ssize(order_); i += communicator.size()) {
    for (int j = i + 1; j < std::ssize(order_); ++j) {
      const Vec3 d(x[i] - x[j], y[i] - y[j], z[i] - z[j]);
      add_pair(work, i, j, d, d.norm());
    }
  }
}

SortedSpheres PairSum::sorted_spheres() const {
  const auto& [x, y, z] = coordinates_;
  const Vec3& lengths = spheres_.lengths;
  return {.x = x.data(),
          .y = y.data(),
          .z = z.data(),
          .is_receiver = is_receiver_.data(),
          .squares = squares_.data(),
          .lengths = {lengths[0], lengths[1], lengths[2]}};
}

/// Adds this rank's share of the pairs within the cutoff of which at least one sphere is a receiver. The
/// second sum at the same positions keeps the pairs for later ones.
void PairSum::add_near_pairs(Work& work, const Communicator& communicator) {
  const SortedSpheres spheres = sorted_spheres();
  if (++sums_ > 2) {
    for (const NeighbourRange& kept : neighbour_ranges_)
      add_near(work, spheres, kept.one, std::span(neighbour_list_).subspan(kept.first, kept.others),
               std::span(neighbour_list_).subspan(kept.first + kept.others, kept.closest));
    return;
  }
  const auto find_near_spheres = best_kernels<MobilityKernels>().find_near_spheres;
  const double close = table_ ? table_->min_square() : INFINITY;
  const auto [first, last] = rank_share(std::ssize(order_), communicator.rank(), communicator.size());
  NearSpheres near;
  const auto add = [&](int one) {
    const std::span others(near.others, near.count), closest(near.close, near.close_count);
    add_near(work, spheres, one, others, closest);
    if (sums_ == 2) {
      neighbour_ranges_.push_back(
          {.one = one, .others = others.size(), .closest = closest.size(), .first = neighbour_list_.size()});
      neighbour_list_.insert(neighbour_list_.end(), others.begin(), others.end());
      neighbour_list_.insert(neighbour_list_.end(), closest.begin(), closest.end());
    }
    near.count = near.close_count = 0;
  };
  for (int one = static_cast<int>(first); one < last; ++one) {
    cells_->for_each_range_after(one, [&](int begin, int end) {
      while ((begin = find_near_spheres(spheres, one, begin, end, split_->cutoff, close, near)) < end)
        add(one);
    });
    add(one);
  }
}

/// Adds the pairs of the sphere `one` with others by the table, and those with the `closest` one by one.
void PairSum::add_near(Work& work, const SortedSpheres& spheres, int one, std::span<const int> others,
                       std::span<const int> closest) const {
  if (table_) {
    const auto pointers = [](auto& arrays) {
      return std::array{arrays[0].data(), arrays[1].data(), arrays[2].data()};
    };
    const std::array<const double*, 3> forces = pointers(std::as_const(work.forces));
    const std::array<double*, 3> velocities = pointers(work.velocities);
    best_kernels<MobilityKernels>().pair_velocities(table_->table(), spheres, one,
                                                    static_cast<int>(others.size()), others.data(),
                                                    forces.data(), velocities.data());
  }
  const auto& [x, y, z] = coordinates_;
  for (const int other : closest) {
    Vec3 d(x[one] - x[other], y[one] - y[other], z[one] - z[other]);
    for (int a = 0; a < 3; ++a)
      if (spheres_.lengths[a] > 0) d[a] -= spheres_.lengths[a] * std::nearbyint(d[a] / spheres_.lengths[a]);
    add_pair(work, one, other, d, d.norm());
  }
}

/// Adds a pair at the vector d, of length r, from sphere `other` to sphere `one`.
void PairSum::add_pair(Work& work, int one, int other, const Vec3& d, double r) const {
  if (spheres_.order == 0) return add_forces(work, one, other, d, r);
  if (work.one != one || work.count == lanes) flush(work);
  work.one = one;
  const bool overlaps = r < radii_[one] + radii_[other];
  if (overlaps) add_overlap(work, one, other, d);
  if (overlaps && !split_) return;  // there is no far part to subtract
  const int lane = work.count++;
  work.other[lane] = other;
  work.overlaps[lane] = overlaps;
  const std::size_t n = spheres_.elements();
  set_lane(work.pairs, lane, d, moment_sizes(radii_[other]), {&work.sources[n * other], n});
}

/// Adds a pair of spheres with forces alone.
void PairSum::add_forces(Work& work, int one, int other, const Vec3& d, double r) const {
  const PairTensor tensor =
      near_part(split_, is_positive_, radii_[one], radii_[other], r, spheres_.viscosity);
  const auto push = [&](int to, int from) {
    Eigen::Map<Vec3>(&work.flows[3 * to]) += tensor.apply(d, r, Vec3(&work.sources[3 * from]));
  };
  push(one, other);
  push(other, one);
}

/// Adds the exact flow of two spheres that overlap, in both directions, for each pair of degrees of their
/// moments.
void PairSum::add_overlap(Work& work, int one, int other, const Vec3& d) const {
  const int count = derivative_count(spheres_.order);
  const std::size_t n = spheres_.elements();
  const double r = std::max(d.norm(), 1e-6 * std::min(radii_[one], radii_[other]));
  const Vec3 place = d.norm() > 0 ? Vec3(d * (r / d.norm())) : Vec3(r, 0, 0);
  const double vector[3]{place[0], place[1], place[2]};
  constexpr auto& first = derivative_table.first;
  for (int l = 0; l <= spheres_.order; ++l) {
    for (int m = 0; m <= spheres_.order; ++m) {
      const MomentRadials radials = overlap_radials(l, m, radii_[one], radii_[other], r, spheres_.viscosity);
      double chi[derivative_count(highest_of_pairs)], laplacian[derivative_count(highest_of_pairs)];
      cartesian_derivatives<highest_of_pairs>(vector, radials.chi, chi);
      cartesian_derivatives<highest_of_pairs>(vector, radials.laplacian, laplacian);
      const auto add_flow = [&](const double* source, int of, double* flow, int at, double sign) {
        for (int c = 0; c < 3; ++c) {
          for (int e = first[at]; e < first[at + 1]; ++e) {
            double sum = 0;
            for (int s = first[of]; s < first[of + 1]; ++s) {
              sum += source[c * count + s] * laplacian[derivative_sums.of[s][e]];
              for (int b = 0; b < 3; ++b)
                sum -= source[b * count + s] *
                       chi[derivative_sums.of[derivative_sums.of[s][1 + b]][derivative_sums.of[e][1 + c]]];
            }
            flow[c * count + e] += sign * sum;
          }
        }
      };
      const double reversed = (l + m) % 2 == 0 ? 1 : -1;
      add_flow(&work.sources[n * other], m, &work.flows[n * one], l, 1);
      add_flow(&work.sources[n * one], l, &work.flows[n * other], m, reversed);
    }
  }
}

/// Sets the radial functions of the current pairs.
void PairSum::set_radials(Work& work) const {
  const int highest = 2 * spheres_.order + 2;
  const double viscosity = spheres_.viscosity;
  if (split_)
    best_kernels<MobilityKernels>().near_radials(split_->near, 1 / (8 * std::numbers::pi * viscosity),
                                                 work.pairs);
  for (int lane = 0; lane < (split_ ? work.count : lanes); ++lane) {
    const double r = work.pairs.distance[lane];
    // The near part of spheres that overlap is the exact flow minus the far part.
    if (!split_)
      beadswim::set_radials(work.pairs, lane, open_radials(r, viscosity, highest));
    else if (work.overlaps[lane])
      beadswim::set_radials(work.pairs, lane, far_radials(*split_, r, viscosity, highest).reversed());
  }
}

/// Adds the flow of the current pairs.
void PairSum::flush(Work& work) const {
  if (work.count == 0) return;
  clear_lanes(work.pairs, work.count);
  set_radials(work);
  const std::size_t n = spheres_.elements();
  OneSphere one{.source = &work.sources[n * work.one], .size = {}, .flow = &work.flows[n * work.one]};
  std::ranges::copy(moment_sizes(radii_[work.one]), one.size);
  best_kernels<MobilityKernels>().moment_pairs(spheres_.order, one, work.pairs, work.at_others);
  for (int lane = 0; lane < work.count; ++lane)
    for (std::size_t k = 0; k < n; ++k) work.flows[n * work.other[lane] + k] += work.at_others[k][lane];
  work.count = 0;
}

}  // namespace beadswim
