#pragma once

#include "kernel_vectors.hpp"
#include "mobility_kernels.hpp"
#include "moment_flow.hpp"

// Kernels of pairs of spheres with force moments. Only for files that are compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

void near_radials(const SplitPolynomials& split, double unit, SourceLanes& sources) {
  constexpr int highest = highest_of_mirrors;
#pragma GCC unroll 1
  for (int lane = 0; lane < lanes; lane += part) {
    Part chi[highest + 1], laplacian[highest + 1], bilaplacian[highest - 1];
    near_functions(split, unit, load_as<Part>(sources.distance + lane), chi, laplacian, bilaplacian);
    for (int n = 0; n <= highest; ++n) {
      if (n > 0) store_as(sources.chi[n] + lane, chi[n]);
      store_as(sources.laplacian[n] + lane, laplacian[n]);
      if (n <= highest - 2) store_as(sources.bilaplacian[n] + lane, bilaplacian[n]);
    }
  }
}

template <int order>
void moment_pairs_of(const OneSphere& one, const SourceLanes& pairs, double (*at_others)[lanes]) {
  constexpr int count = derivative_count(order), highest = 2 + 2 * order;
  const auto degree = [](int s) { return derivative_table.order[s % count]; };
  double at_one[3 * count][lanes];
#pragma GCC unroll 1
  for (int lane = 0; lane < lanes; lane += part) {
    const auto load = [lane](const double* row) __attribute__((always_inline)) {
      return load_as<Part>(row + lane);
    };
    const Part r[3]{load(pairs.r[0]), load(pairs.r[1]), load(pairs.r[2])};
    Part radial[highest + 1];
    PairDerivatives<order, Part> pair;
    const auto derive = [&]<int upto>(const double(*functions)[lanes], Part* result)
        __attribute__((always_inline)) {
      for (int n = 0; n <= upto; ++n) radial[n] = load(functions[n]);
      cartesian_derivatives<upto>(r, radial, result);
    };
    derive.template operator()<highest>(pairs.chi, pair.chi);
    derive.template operator()<highest>(pairs.laplacian, pair.laplacian);
    derive.template operator()<2 * order>(pairs.bilaplacian, pair.bilaplacian);

    Part source[3 * count], scaled_source[3 * count], flow[3 * count]{};
    const Part other_size[3]{load(pairs.size[0]), load(pairs.size[1]), load(pairs.size[2])};
    const Part own_size[3]{Part{} + one.size[0], Part{} + one.size[1], Part{} + one.size[2]};
    for (int s = 0; s < 3 * count; ++s) {
      source[s] = load(pairs.source[s]);
      scaled_source[s] = other_size[degree(s)] * source[s];
    }
    add_moment_flow<order>(pair, source, scaled_source, own_size, flow);
    for (int s = 0; s < 3 * count; ++s) store_as(at_one[s] + lane, flow[s]);
    // At the other spheres, r is reversed: odd derivatives of source and flow change their sign.
    for (int s = 0; s < 3 * count; ++s) {
      source[s] = Part{} + (degree(s) == 1 ? -one.source[s] : one.source[s]);
      scaled_source[s] = own_size[degree(s)] * source[s];
      flow[s] = Part{};
    }
    add_moment_flow<order>(pair, source, scaled_source, other_size, flow);
    for (int s = 0; s < 3 * count; ++s) store_as(at_others[s] + lane, degree(s) == 1 ? -flow[s] : flow[s]);
  }
  for (int s = 0; s < 3 * count; ++s) {
    double sum = 0;
    for (int l = 0; l < lanes; ++l) sum += at_one[s][l];
    one.flow[s] += sum;
  }
}

void moment_pairs(int order, const OneSphere& one, const SourceLanes& pairs, double (*at_others)[lanes]) {
  order == 1 ? moment_pairs_of<1>(one, pairs, at_others) : moment_pairs_of<2>(one, pairs, at_others);
}

// The velocity is that of add_moment_flow(); the pressure: wall_reflection.hpp.
template <int order, Receivers receivers, bool has_bilaplacian>
void mirror_flow_of(int axis, const SourceLanes& sources, MirrorFlowParts& flow) {
  constexpr bool at_points = receivers == Receivers::points;
  constexpr int count = derivative_count(order), low = at_points ? 1 : count,
                high = derivative_count(at_points ? 1 : order + 2),
                highest = highest_radial(order, receivers);
  constexpr auto& plus = derivative_sums.of;
#pragma GCC unroll 1
  for (int lane = 0; lane < lanes; lane += part) {
    const auto load = [lane](const double* row) __attribute__((always_inline)) {
      return load_as<Part>(row + lane);
    };
    const Part r[3]{load(sources.r[0]), load(sources.r[1]), load(sources.r[2])};
    Part radial[highest + 1], chi[derivative_count(highest)], laplacian[derivative_count(highest)];
    for (int n = 0; n <= highest; ++n) radial[n] = load(sources.chi[n]);
    cartesian_derivatives<highest>(r, radial, chi);
    for (int n = 0; n <= highest; ++n) radial[n] = load(sources.laplacian[n]);
    cartesian_derivatives<highest>(r, radial, laplacian);
    Part bilaplacian[has_bilaplacian ? derivative_count(highest - 2) : 1];
    if constexpr (has_bilaplacian) {
      for (int n = 0; n <= highest - 2; ++n) radial[n] = load(sources.bilaplacian[n]);
      cartesian_derivatives<highest - 2>(r, radial, bilaplacian);
    }
    Part source[3 * count], scaled_source[3 * count];
    for (int s = 0; s < 3 * count; ++s) {
      source[s] = load(sources.source[s]);
      scaled_source[s] = load(sources.size[derivative_table.order[s % count]]) * source[s];
    }
    /// Derivative e of the velocity component c.
    const auto velocity = [&](int c, int e) __attribute__((always_inline)) {
      Part sum{};
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
    const auto add = [](double* to, const Part& more) __attribute__((always_inline)) {
      store_as(to, load_as<Part>(to) + more);
    };
    for (int t = 0; t < 2; ++t)
      for (int e = 0; e < low; ++e) add(flow.along[t][e] + lane, velocity((axis + 1 + t) % 3, e));
    for (int e = 0; e < high; ++e) {
      add(flow.across[e] + lane, velocity(axis, e));
      Part sum{};
      for (int b = 0; b < 3; ++b)
        for (int d = 0; d < count; ++d) sum -= source[b * count + d] * laplacian[plus[plus[1 + b][d]][e]];
      add(flow.pressure[e] + lane, sum);
    }
  }
}

template <int order>
void mirror_flow_by(Receivers receivers, int axis, const SourceLanes& sources, bool has_bilaplacian,
                    MirrorFlowParts& flow) {
  constexpr void (*functions[][2])(int, const SourceLanes&, MirrorFlowParts&){
      {mirror_flow_of<order, Receivers::spheres, false>, mirror_flow_of<order, Receivers::spheres, true>},
      {mirror_flow_of<order, Receivers::points, false>, mirror_flow_of<order, Receivers::points, true>}};
  functions[receivers == Receivers::points ? 1 : 0][has_bilaplacian ? 1 : 0](axis, sources, flow);
}

void mirror_flow(int order, Receivers receivers, int axis, const SourceLanes& sources, bool has_bilaplacian,
                 MirrorFlowParts& flow) {
  constexpr void (*by_order[])(Receivers, int, const SourceLanes&, bool, MirrorFlowParts&){
      mirror_flow_by<0>, mirror_flow_by<1>, mirror_flow_by<2>};
  by_order[order](receivers, axis, sources, has_bilaplacian, flow);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
