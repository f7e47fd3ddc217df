#pragma once

#include "mesh_window.hpp"
#include "moment_flow.hpp"

// Kernels of pairs of spheres with force moments. Only for files that are compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

template <int order>
BEADSWIM_KERNEL void moment_pairs_of(const OneSphere& one, const SourceLanes& pairs,
                                     double (*at_others)[lanes]) {
  constexpr int count = derivative_count(order), highest = 2 + 2 * order;
  const Lanes r[3]{load(pairs.r[0]), load(pairs.r[1]), load(pairs.r[2])};
  Lanes radial[highest + 1];
  PairDerivatives<order, Lanes> pair;
  const auto derive = [&]<int upto>(const double(*functions)[lanes], Lanes* result)
      __attribute__((always_inline)) {
    for (int n = 0; n <= upto; ++n) radial[n] = load(functions[n]);
    cartesian_derivatives<upto>(r, radial, result);
  };
  derive.template operator()<highest>(pairs.chi, pair.chi);
  derive.template operator()<highest>(pairs.laplacian, pair.laplacian);
  derive.template operator()<2 * order>(pairs.bilaplacian, pair.bilaplacian);

  Lanes source[3 * count], scaled_source[3 * count], flow[3 * count]{};
  const Lanes other_size[3]{load(pairs.size[0]), load(pairs.size[1]), load(pairs.size[2])};
  const Lanes own_size[3]{Lanes{} + one.size[0], Lanes{} + one.size[1], Lanes{} + one.size[2]};
  const auto degree = [](int s) { return derivative_table.order[s % count]; };
  for (int s = 0; s < 3 * count; ++s) {
    source[s] = load(pairs.source[s]);
    scaled_source[s] = other_size[degree(s)] * source[s];
  }
  add_moment_flow<order>(pair, source, scaled_source, own_size, flow);
  for (int s = 0; s < 3 * count; ++s) {
    double sum = 0;
    for (int l = 0; l < lanes; ++l) sum += flow[s][l];
    one.flow[s] += sum;
  }
  // At the other spheres, r is reversed: odd derivatives of source and flow change their sign.
  for (int s = 0; s < 3 * count; ++s) {
    source[s] = Lanes{} + (degree(s) == 1 ? -one.source[s] : one.source[s]);
    scaled_source[s] = own_size[degree(s)] * source[s];
    flow[s] = Lanes{};
  }
  add_moment_flow<order>(pair, source, scaled_source, other_size, flow);
  for (int s = 0; s < 3 * count; ++s) store(at_others[s], degree(s) == 1 ? -flow[s] : flow[s]);
}

void moment_pairs(int order, const OneSphere& one, const SourceLanes& pairs, double (*at_others)[lanes]) {
  order == 1 ? moment_pairs_of<1>(one, pairs, at_others) : moment_pairs_of<2>(one, pairs, at_others);
}

// The velocity is that of add_moment_flow(); the pressure: wall_reflection.hpp.
template <int order, bool has_bilaplacian>
BEADSWIM_KERNEL void mirror_flow_of(int axis, const SourceLanes& sources, MirrorFlowParts& flow) {
  constexpr int count = derivative_count(order), high = derivative_count(order + 2), highest = 2 * order + 4;
  constexpr auto& plus = derivative_sums.of;
  const Lanes r[3]{load(sources.r[0]), load(sources.r[1]), load(sources.r[2])};
  Lanes radial[highest + 1], chi[derivative_count(highest)], laplacian[derivative_count(highest)];
  for (int n = 0; n <= highest; ++n) radial[n] = load(sources.chi[n]);
  cartesian_derivatives<highest>(r, radial, chi);
  for (int n = 0; n <= highest; ++n) radial[n] = load(sources.laplacian[n]);
  cartesian_derivatives<highest>(r, radial, laplacian);
  Lanes bilaplacian[has_bilaplacian ? derivative_count(highest - 2) : 1];
  if constexpr (has_bilaplacian) {
    for (int n = 0; n <= highest - 2; ++n) radial[n] = load(sources.bilaplacian[n]);
    cartesian_derivatives<highest - 2>(r, radial, bilaplacian);
  }
  Lanes source[3 * count], scaled_source[3 * count];
  for (int s = 0; s < 3 * count; ++s) {
    source[s] = load(sources.source[s]);
    scaled_source[s] = load(sources.size[derivative_table.order[s % count]]) * source[s];
  }
  /// Derivative e of the velocity component c.
  const auto velocity = [&](int c, int e) __attribute__((always_inline)) {
    Lanes sum{};
    const int by_c = plus[e][1 + c];
    for (int d = 0; d < count; ++d) {
      sum += source[c * count + d] * laplacian[plus[d][e]];
      if constexpr (has_bilaplacian) sum += scaled_source[c * count + d] * bilaplacian[plus[d][e]];
    }
    for (int b = 0; b < 3; ++b) {
      for (int d = 0; d < count; ++d) {
        const int all = plus[plus[1 + b][d]][by_c];
        sum -= source[b * count + d] * chi[all] + scaled_source[b * count + d] * laplacian[all];
      }
    }
    return sum;
  };
  const auto add = [](double* to, const Lanes& more) __attribute__((always_inline)) {
    store(to, load(to) + more);
  };
  for (int c = 0; c < 3; ++c)
    for (int e = 0; e < count; ++e) add(flow.velocity[c][e], velocity(c, e));
  for (int e = 0; e < high; ++e) {
    add(flow.across[e], velocity(axis, e));
    Lanes sum{};
    for (int b = 0; b < 3; ++b)
      for (int d = 0; d < count; ++d) sum -= source[b * count + d] * laplacian[plus[plus[1 + b][d]][e]];
    add(flow.pressure[e], sum);
  }
}

void mirror_flow(int order, int axis, const SourceLanes& sources, bool has_bilaplacian,
                 MirrorFlowParts& flow) {
  with_constant<0, 1, 2>(
      order, [&]<int n>() __attribute__((always_inline)) {
        has_bilaplacian ? mirror_flow_of<n, true>(axis, sources, flow)
                        : mirror_flow_of<n, false>(axis, sources, flow);
      });
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
