#include "moment_sum.hpp"

#include <algorithm>

#include "moment_flow.hpp"
#include "moment_kernels.hpp"
#include "moment_radials.hpp"
#include "near_search.hpp"

namespace beadswim {
namespace {

void set_radials(MomentPairs& pairs, int lane, const MomentRadials& radials) {
  for (int n = 0; n <= highest_of_pairs; ++n) {
    pairs.chi[n][lane] = radials.chi[n];
    pairs.laplacian[n][lane] = radials.laplacian[n];
    if (n <= highest_of_pairs - 2) pairs.bilaplacian[n][lane] = radials.bilaplacian[n];
  }
}

}  // namespace

/// Sources and flows of all spheres, in the order of the sum, and the current pairs of one sphere.
struct MomentSum::Work {
  std::vector<double> radii, sources, flows;
  MomentPairs pairs{};
  int count = 0;  ///< lanes in use
  int one = 0;    ///< the one sphere of the pairs
  std::array<int, lanes> other{};
};

void MomentSum::flush(Work& work) const {
  if (work.count == 0) return;
  MomentPairs& pairs = work.pairs;
  for (int lane = work.count; lane < lanes; ++lane) {  // copies without sources
    for (auto& component : pairs.r) component[lane] = component[0];
    for (auto* functions : {pairs.chi, pairs.laplacian})
      for (int n = 0; n < 7; ++n) functions[n][lane] = functions[n][0];
    for (auto& function : pairs.bilaplacian) function[lane] = function[0];
    for (auto& size : pairs.size) size[lane] = 0;
    for (auto& source : pairs.source) source[lane] = 0;
  }
  const std::size_t n = elements();
  OneSphere one{.source = &work.sources[n * work.one], .size = {}, .flow = &work.flows[n * work.one]};
  std::ranges::copy(moment_sizes(work.radii[work.one]), one.size);
  best_kernels<MomentKernels>().moment_pairs(law_.order, one, pairs);
  for (int lane = 0; lane < work.count; ++lane)
    for (std::size_t k = 0; k < n; ++k) work.flows[n * work.other[lane] + k] += pairs.flow[k][lane];
  work.count = 0;
}

/// Adds a pair at the vector d from sphere `other` to sphere `one`.
void MomentSum::add_pair(Work& work, int one, int other, const Vec3& d) const {
  if (work.one != one || work.count == lanes) flush(work);
  work.one = one;
  const double r = d.norm();
  const bool overlaps = r < work.radii[one] + work.radii[other];
  if (overlaps) add_overlap(work, one, other, d);
  if (overlaps && law_.xi == 0) return;  // there is no far part to subtract
  // The near part of spheres that overlap is the exact flow minus the far part.
  const MomentRadials radials = law_.xi == 0 ? open_radials(r, law_.viscosity)
                                : overlaps   ? -far_radials(law_.xi, r, law_.viscosity)
                                             : near_radials(law_.xi, r, law_.viscosity);
  const int lane = work.count++;
  work.other[lane] = other;
  for (int a = 0; a < 3; ++a) work.pairs.r[a][lane] = d[a];
  set_radials(work.pairs, lane, radials);
  const std::array<double, 3> size = moment_sizes(work.radii[other]);
  for (int l = 0; l < 3; ++l) work.pairs.size[l][lane] = size[l];
  const std::size_t n = elements();
  for (std::size_t k = 0; k < n; ++k) work.pairs.source[k][lane] = work.sources[n * other + k];
}

/// Adds the exact flow of two spheres that overlap, in both directions, for each pair of degrees of their
/// moments.
void MomentSum::add_overlap(Work& work, int one, int other, const Vec3& d) const {
  const int count = derivative_count(law_.order);
  const std::size_t n = elements();
  const double r = std::max(d.norm(), 1e-6 * std::min(work.radii[one], work.radii[other]));
  const Vec3 place = d.norm() > 0 ? Vec3(d * (r / d.norm())) : Vec3(r, 0, 0);
  const double vector[3]{place[0], place[1], place[2]};
  constexpr auto& first = derivative_table.first;
  for (int l = 0; l <= law_.order; ++l) {
    for (int m = 0; m <= law_.order; ++m) {
      const MomentRadials radials =
          overlap_radials(l, m, work.radii[one], work.radii[other], r, law_.viscosity);
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

void MomentSum::add_flows(std::span<const Vec3> positions, std::span<const double> sources,
                          std::span<double> flows, const Communicator& communicator) const {
  law_.xi == 0 ? add_all_pairs(positions, sources, flows, communicator)
               : add_near_pairs(positions, sources, flows, communicator);
}

void MomentSum::add_all_pairs(std::span<const Vec3> positions, std::span<const double> sources,
                              std::span<double> flows, const Communicator& communicator) const {
  Work work{.radii = law_.radii,
            .sources = {sources.begin(), sources.end()},
            .flows = std::vector<double>(sources.size(), 0.0)};
  const int count = static_cast<int>(positions.size());
  for (int i = communicator.rank(); i < count; i += communicator.size())
    for (int j = i + 1; j < count; ++j) add_pair(work, i, j, positions[i] - positions[j]);
  flush(work);
  for (std::size_t k = 0; k < flows.size(); ++k) flows[k] += work.flows[k];
}

void MomentSum::add_near_pairs(std::span<const Vec3> positions, std::span<const double> sources,
                               std::span<double> flows, const Communicator& communicator) const {
  const std::size_t n = elements();
  const NearSearch search(positions, flows.size() / n, law_.cutoff, law_.lengths);
  const std::vector<int>& order = search.order();
  Work work{.radii = {}, .sources = {}, .flows = std::vector<double>(sources.size(), 0.0)};
  for (const int b : order) {
    work.radii.push_back(law_.radii[b]);
    const std::span<const double> source = sources.subspan(n * b, n);
    work.sources.insert(work.sources.end(), source.begin(), source.end());
  }
  PairBatch batch;
  search.for_each_batch(batch, communicator, [&](int one) {
    for (int t = 0; t < batch.count; ++t)
      add_pair(work, one, batch.other[t], Vec3(batch.d[0][t], batch.d[1][t], batch.d[2][t]));
    batch.count = 0;
  });
  flush(work);
  for (std::size_t s = 0; s < order.size(); ++s)
    if (search.is_receiver(s))
      for (std::size_t k = 0; k < n; ++k) flows[n * order[s] + k] += work.flows[n * s + k];
}

void MomentSum::subtract_far_flow(std::span<const double> sources, std::span<double> flows) const {
  const std::size_t n = elements();
  MomentPairs pairs{};
  set_radials(pairs, 0, far_radials(law_.xi, 0, law_.viscosity));
  const std::vector<double> none(n, 0.0);
  std::vector<double> flow(n);
  for (std::size_t b = 0; n * b < flows.size(); ++b) {
    const std::array<double, 3> size = moment_sizes(law_.radii[b]);
    std::ranges::fill(flow, 0.0);
    OneSphere one{.source = none.data(), .size = {}, .flow = flow.data()};
    for (int l = 0; l < 3; ++l) one.size[l] = pairs.size[l][0] = size[l];
    for (std::size_t k = 0; k < n; ++k) pairs.source[k][0] = sources[n * b + k];
    best_kernels<MomentKernels>().moment_pairs(law_.order, one, pairs);
    for (std::size_t k = 0; k < n; ++k) flows[n * b + k] -= flow[k];
  }
}

}  // namespace beadswim
