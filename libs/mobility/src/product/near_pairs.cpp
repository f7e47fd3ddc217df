#include "near_pairs.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/ewald_split.hpp"
#include "near_search.hpp"

namespace beadswim {
namespace {

/// Values at the Chebyshev points of [0, 1], or coefficients of the polynomial of degree 5 through these
/// values.
using Fit = Eigen::Matrix<double, PairTable::degree + 1, 1>;
double chebyshev_point(int k) {
  constexpr int n = PairTable::degree + 1;
  return 0.5 - 0.5 * std::cos(std::numbers::pi * (k + 0.5) / n);
}
/// Returns the coefficients of the polynomial of degree 5 that has the given values at the Chebyshev points.
Fit fit(const Fit& values) {
  constexpr int n = PairTable::degree + 1;
  static const Eigen::Matrix<double, n, n> inverse = [] {
    Eigen::Matrix<double, n, n> powers;
    for (int k = 0; k < n; ++k)
      for (int p = 0; p < n; ++p) powers(k, p) = std::pow(chebyshev_point(k), p);
    return Eigen::Matrix<double, n, n>(powers.inverse());
  }();
  return inverse * values;
}

}  // namespace

NearPairs::NearPairs(Law law) : law_(std::move(law)) {
  const auto [smallest, largest] = std::ranges::minmax_element(law_.radii);
  min_tabulated_distance_ = std::min(2 * *largest, law_.cutoff);
  has_one_radius_ = *smallest == *largest || law_.model == MobilityModel::oseen;
  tabulate();
}

PairTensor NearPairs::tensor(double radius_i, double radius_j, double r) const {
  const bool is_sphere = has_finite_radii(law_.model);
  const double squares = is_sphere ? radius_i * radius_i + radius_j * radius_j : 0;
  if (is_sphere && r < 1e-3 * std::min(radius_i, radius_j)) {  // avoids cancellation of large terms as r -> 0
    return rotne_prager_tensor(radius_i, radius_j, r, law_.viscosity) -
           far_tensor(law_.xi, 0, 0, law_.viscosity).sphere_tensor(squares);
  }
  PairTensor tensor = near_tensor(law_.xi, r, law_.viscosity).sphere_tensor(squares);
  if (is_sphere && r < radius_i + radius_j) {
    const PairTensor overlap = rotne_prager_tensor(radius_i, radius_j, r, law_.viscosity) -
                               rotne_prager_tensor_apart(squares, r, law_.viscosity);
    tensor = {tensor.isotropic + overlap.isotropic, tensor.axial + overlap.axial};
  }
  return tensor;
}

void NearPairs::tabulate() {
  constexpr int powers = PairTable::degree + 1;
  const auto stretch_of = [](double r) { return std::bit_cast<std::int64_t>(r * r) >> PairTable::shift; };
  table_ = {.first = stretch_of(min_tabulated_distance_),
            .functions = has_one_radius_ ? 2 : 4,
            .coefficients = nullptr};
  const auto stretches = static_cast<int>(stretch_of(law_.cutoff) - table_.first);
  const double squares = has_finite_radii(law_.model) ? 2 * law_.radii.front() * law_.radii.front() : 0;
  const int functions = table_.functions;
  coefficients_.resize(static_cast<std::size_t>(stretches + 1) * powers * functions);
  for (int s = 0; s <= stretches; ++s) {
    std::array<Fit, 4> values;
    const auto edge = [&](int n) { return std::bit_cast<double>((table_.first + n) << PairTable::shift); };
    for (int k = 0; k < powers; ++k) {
      const double r = std::sqrt(std::lerp(edge(s), edge(s + 1), chebyshev_point(k)));
      const SplitTensor parts = near_tensor(law_.xi, r, law_.viscosity);
      const PairTensor first = has_one_radius_ ? parts.sphere_tensor(squares) : parts.oseen;
      values[0][k] = first.isotropic;
      values[1][k] = first.axial / (r * r);
      values[2][k] = parts.laplacian.isotropic / 6;
      values[3][k] = parts.laplacian.axial / 6 / (r * r);
    }
    for (int f = 0; f < functions; ++f) {
      const Fit coefficients = fit(values[f]);
      for (int p = 0; p < powers; ++p)
        coefficients_[(static_cast<std::size_t>(s) * powers + p) * functions + f] = coefficients[p];
    }
  }
  table_.coefficients = coefficients_.data();
}

/// Forces, velocities and radii of the beads in the order of the search, and the current batch of pairs of
/// one bead.
struct NearPairs::Work {
  std::vector<Vec3> forces, velocities;
  std::vector<double> radii;
  PairBatch batch;
};

void NearPairs::add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                               std::span<Vec3> velocities, const Communicator& communicator) const {
  const NearSearch search(positions, velocities.size(), law_.cutoff, law_.lengths);
  const std::vector<int>& order = search.order();
  Work work{
      .forces = {}, .velocities = std::vector<Vec3>(order.size(), Vec3::Zero()), .radii = {}, .batch = {}};
  for (const int b : order) {
    work.forces.push_back(forces[b]);
    work.radii.push_back(law_.radii[b]);
  }
  search.for_each_batch(work.batch, communicator, [&](int one) { flush(work, one); });
  for (std::size_t s = 0; s < order.size(); ++s)
    if (search.is_receiver(s)) velocities[order[s]] += work.velocities[s];
}

void NearPairs::flush(Work& work, int one) const {
  PairBatch& batch = work.batch;
  int kept = 0;
  for (int t = 0; t < batch.count; ++t) {
    const int other = batch.other[t];
    const Vec3 d(batch.d[0][t], batch.d[1][t], batch.d[2][t]);
    if (batch.r2[t] <= min_tabulated_distance_ * min_tabulated_distance_) {  // rare: within a bead diameter
      const double r = std::sqrt(batch.r2[t]);
      const PairTensor whole = tensor(work.radii[one], work.radii[other], r);
      work.velocities[one] += whole.apply(d, r, work.forces[other]);
      work.velocities[other] += whole.apply(d, r, work.forces[one]);
      continue;
    }
    batch.other[kept] = other;
    batch.r2[kept] = batch.r2[t];
    for (int a = 0; a < 3; ++a) {
      batch.d[a][kept] = d[a];
      batch.force[a][kept] = work.forces[other][a];
    }
    if (!has_one_radius_)
      batch.squares[kept] = work.radii[one] * work.radii[one] + work.radii[other] * work.radii[other];
    ++kept;
  }
  batch.count = kept;
  best_kernels<MobilityKernels>().pair_velocities(table_, work.forces[one].data(), batch,
                                                  work.velocities[one].data());
  for (int t = 0; t < kept; ++t)
    for (int a = 0; a < 3; ++a) work.velocities[batch.other[t]][a] += batch.velocity[a][t];
  batch.count = 0;
}

void add_all_pairs(MobilityModel model, double viscosity, std::span<const double> radii,
                   std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities,
                   const Communicator& communicator) {
  const int n = static_cast<int>(positions.size());
  for (int i = communicator.rank(); i < n; i += communicator.size()) {
    for (int j = i + 1; j < n; ++j) {
      const Vec3 d = positions[i] - positions[j];
      const double r = d.norm();
      const PairTensor tensor = model == MobilityModel::oseen
                                    ? oseen_tensor(r, viscosity)
                                    : rotne_prager_tensor(radii[i], radii[j], r, viscosity);
      velocities[i] += tensor.apply(d, r, forces[j]);
      velocities[j] += tensor.apply(d, r, forces[i]);
    }
  }
}

}  // namespace beadswim
