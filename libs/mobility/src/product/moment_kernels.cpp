// Compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the instruction set.
#include "moment_kernels.hpp"

#include <type_traits>

#include "mesh_window.hpp"
#include "moment_flow.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

template <int order>
BEADSWIM_KERNEL void moment_pairs_of(const OneSphere& one, MomentPairs& pairs) {
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
  for (int s = 0; s < 3 * count; ++s) store(pairs.flow[s], degree(s) == 1 ? -flow[s] : flow[s]);
}

void moment_pairs(int order, const OneSphere& one, MomentPairs& pairs) {
  order == 1 ? moment_pairs_of<1>(one, pairs) : moment_pairs_of<2>(one, pairs);
}

// The velocity is that of add_moment_flow(); the pressure: wall_reflection.hpp.
template <int order, bool has_bilaplacian>
BEADSWIM_KERNEL void mirror_flow_of(int axis, const PointSources& sources, MirrorFlowParts& flow) {
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

void mirror_flow(int order, int axis, const PointSources& sources, MirrorFlowParts& flow) {
  const auto of = [&]<int n>(std::integral_constant<int, n>) __attribute__((always_inline)) {
    sources.has_bilaplacian ? mirror_flow_of<n, true>(axis, sources, flow)
                            : mirror_flow_of<n, false>(axis, sources, flow);
  };
  if (order == 0) of(std::integral_constant<int, 0>{});
  if (order == 1) of(std::integral_constant<int, 1>{});
  if (order == 2) of(std::integral_constant<int, 2>{});
}

/// Weights of the window of a point along one axis and their derivatives up to the fourth: with the slope g
/// of the exponent, W^(k+1) = g W^(k) + k g' W^(k-1).
template <int P>
struct HighlyDerivedWindow {
  static constexpr int highest = 4;
  Window<P> window;
  double weight[highest + 1][3][P];  ///< [derivative][axis][point]

  BEADSWIM_KERNEL void set_position(const WindowMesh& mesh, const double* position) {
    window.set_position(mesh, position);
    for (int a = 0; a < 3; ++a) {
      const double slope = -2 * mesh.decay[a] * mesh.inverse_spacing[a],
                   curve = slope * mesh.inverse_spacing[a];
      for (int p = 0; p < P; ++p) {
        const double g = slope * (window.offset[a] + p);
        weight[0][a][p] = window.weight[a][p];
        weight[1][a][p] = g * weight[0][a][p];
        for (int k = 1; k < highest; ++k)
          weight[k + 1][a][p] = g * weight[k][a][p] + k * curve * weight[k - 1][a][p];
      }
    }
  }
};

/// Adds the derivatives up to `highest` of a mesh at a point to `result`.
template <int P>
BEADSWIM_KERNEL void add_derivatives_at(const WindowMesh& mesh, const HighlyDerivedWindow<P>& w, int highest,
                                        const double* from, double* result) {
  constexpr int orders = HighlyDerivedWindow<P>::highest + 1;
  const bool wraps = w.window.wraps(mesh);
  for (int p = 0; p < P; ++p) {
    if (w.window.planes[p] < 0) continue;
    double in_plane[orders][orders]{};  // derivatives by y and z
    for (int q = 0; q < P; ++q) {
      const double* const row = from + w.window.row(mesh, p, q);
      double values[P];
      for (int s = 0; s < P; ++s)
        values[s] =
            row[wraps ? Window<P>::wrapped(w.window.first[2] + s, mesh.points[2]) : w.window.first[2] + s];
      for (int k = 0; k <= highest; ++k) {
        double sum = 0;
        for (int s = 0; s < P; ++s) sum += values[s] * w.weight[k][2][s];
        for (int j = 0; j <= highest - k; ++j) in_plane[j][k] += w.weight[j][1][q] * sum;
      }
    }
    // The window depends on mesh point minus position of the point: odd derivatives have the opposite sign.
    for (int d = 0; d < derivative_count(highest); ++d) {
      const auto& degree = derivative_table.degree[d];
      const double value = w.weight[degree[0]][0][p] * in_plane[degree[1]][degree[2]];
      result[d] += derivative_table.order[d] % 2 == 0 ? value : -value;
    }
  }
}

void gather_mirror_flows(int order, int axis, const WindowMesh& mesh, const WindowBeads& points,
                         const double* const* from, MirrorFlow* flows) {
  with_window(
      mesh.window, [&]<int P>() __attribute__((always_inline)) {
        HighlyDerivedWindow<P> w;
        for (long b = 0; b < points.count; ++b) {
          w.set_position(mesh, points.positions + 3 * b);
          double* const results[]{flows[b].velocity[0], flows[b].velocity[1], flows[b].velocity[2],
                                  flows[b].across, flows[b].pressure};
          const double* const values[]{from[0], from[1], from[2], from[axis], from[3]};
          for (int f = 0; f < 5; ++f)
            add_derivatives_at<P>(mesh, w, f < 3 ? order : order + 2, values[f], results[f]);
        }
      });
}

/// Weights of the window of a bead along one axis and their first and second derivatives by the mesh
/// coordinate, in units of [length].
template <int P>
struct DerivedWindow {
  Window<P> window;
  double weight[3][3][P];  ///< [derivative][axis][point]

  BEADSWIM_KERNEL void set_position(const WindowMesh& mesh, const double* position) {
    window.set_position(mesh, position);
    for (int a = 0; a < 3; ++a) {
      const double slope = -2 * mesh.decay[a] * mesh.inverse_spacing[a];
      for (int p = 0; p < P; ++p) {
        const double w = window.weight[a][p], g = slope * (window.offset[a] + p);
        weight[0][a][p] = w;
        weight[1][a][p] = g * w;
        weight[2][a][p] = (g * g + slope * mesh.inverse_spacing[a]) * w;
      }
    }
  }
};

template <int P, int order>
BEADSWIM_KERNEL void spread_moments_of(const WindowMesh& mesh, const WindowBeads& beads,
                                       const double* sources, MeshValues onto) {
  constexpr int count = derivative_count(order);
  DerivedWindow<P> w;
  for (long b = 0; b < beads.count; ++b) {
    w.set_position(mesh, beads.positions + 3 * b);
    const bool wraps = w.window.wraps(mesh);
    for (int c = 0; c < 3; ++c) {
      const double* const A = sources + (3 * b + c) * count;
      for (int p = 0; p < P; ++p) {
        if (w.window.planes[p] < 0) continue;
        const double x0 = w.weight[0][0][p], x1 = w.weight[1][0][p], x2 = w.weight[2][0][p];
        for (int q = 0; q < P; ++q) {
          const double y0 = w.weight[0][1][q], y1 = w.weight[1][1][q], y2 = w.weight[2][1][q];
          double along[3]{A[0] * x0 * y0 + A[1] * x1 * y0 + A[2] * x0 * y1, A[3] * x0 * y0, 0};
          if constexpr (order == 2) {
            along[0] += A[4] * x2 * y0 + A[5] * x1 * y1 + A[7] * x0 * y2;
            along[1] += A[6] * x1 * y0 + A[8] * x0 * y1;
            along[2] = A[9] * x0 * y0;
          }
          double* const row = onto[c] + w.window.row(mesh, p, q);
          double values[P];
          for (int s = 0; s < P; ++s) {
            values[s] = along[0] * w.weight[0][2][s] + along[1] * w.weight[1][2][s];
            if constexpr (order == 2) values[s] += along[2] * w.weight[2][2][s];
          }
          if (wraps) {
            for (int s = 0; s < P; ++s)
              row[Window<P>::wrapped(w.window.first[2] + s, mesh.points[2])] += values[s];
          } else {
            double* const at = row + w.window.first[2];
#pragma GCC ivdep
            for (int s = 0; s < P; ++s) at[s] += values[s];
          }
        }
      }
    }
  }
}

template <int P, int order>
BEADSWIM_KERNEL void gather_moments_of(const WindowMesh& mesh, const WindowBeads& beads, ConstMeshValues from,
                                       double* flows) {
  constexpr int count = derivative_count(order), across = order == 1 ? 3 : 6;
  DerivedWindow<P> w;
  for (long b = 0; b < beads.count; ++b) {
    w.set_position(mesh, beads.positions + 3 * b);
    const bool wraps = w.window.wraps(mesh);
    for (int c = 0; c < 3; ++c) {
      // Sums over the window points of the first two axes, weighted by 1, x, y, xx, xy, yy derivatives.
      double along[across][P]{};
      for (int p = 0; p < P; ++p) {
        if (w.window.planes[p] < 0) continue;
        const double x0 = w.weight[0][0][p], x1 = w.weight[1][0][p], x2 = w.weight[2][0][p];
        for (int q = 0; q < P; ++q) {
          const double y0 = w.weight[0][1][q], y1 = w.weight[1][1][q], y2 = w.weight[2][1][q];
          const double weight[6]{x0 * y0, x1 * y0, x0 * y1, x2 * y0, x1 * y1, x0 * y2};
          const double* const row = from[c] + w.window.row(mesh, p, q);
          double values[P];
          if (wraps) {
            for (int s = 0; s < P; ++s)
              values[s] = row[Window<P>::wrapped(w.window.first[2] + s, mesh.points[2])];
          } else {
            for (int s = 0; s < P; ++s) values[s] = row[w.window.first[2] + s];
          }
          for (int k = 0; k < across; ++k)
            for (int s = 0; s < P; ++s) along[k][s] += weight[k] * values[s];
        }
      }
      double sum[across][3]{};
      for (int k = 0; k < across; ++k)
        for (int z = 0; z < 3; ++z)
          for (int s = 0; s < P; ++s) sum[k][z] += along[k][s] * w.weight[z][2][s];
      // The window depends on mesh point minus bead position: first derivatives by the bead position have the
      // opposite sign.
      double* const flow = flows + (3 * b + c) * count;
      flow[0] += sum[0][0];
      flow[1] -= sum[1][0];
      flow[2] -= sum[2][0];
      flow[3] -= sum[0][1];
      if constexpr (order == 2) {
        flow[4] += sum[3][0];
        flow[5] += sum[4][0];
        flow[6] += sum[1][1];
        flow[7] += sum[5][0];
        flow[8] += sum[2][1];
        flow[9] += sum[0][2];
      }
    }
  }
}

void spread_moments(int order, const WindowMesh& mesh, const WindowBeads& beads, const double* sources,
                    MeshValues onto) {
  if (order == 0) return spread_windows(mesh, beads, sources, onto);
  with_window(
      mesh.window, [&]<int P>() __attribute__((always_inline)) {
        order == 1 ? spread_moments_of<P, 1>(mesh, beads, sources, onto)
                   : spread_moments_of<P, 2>(mesh, beads, sources, onto);
      });
}

void gather_moments(int order, const WindowMesh& mesh, const WindowBeads& beads, ConstMeshValues from,
                    double* flows) {
  if (order == 0) return gather_windows(mesh, beads, from, flows);
  with_window(
      mesh.window, [&]<int P>() __attribute__((always_inline)) {
        order == 1 ? gather_moments_of<P, 1>(mesh, beads, from, flows)
                   : gather_moments_of<P, 2>(mesh, beads, from, flows);
      });
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

const MomentKernels MomentKernels::BEADSWIM_INSTRUCTION_SET{
    .moment_pairs = BEADSWIM_INSTRUCTION_SET::moment_pairs,
    .mirror_flow = BEADSWIM_INSTRUCTION_SET::mirror_flow,
    .gather_mirror_flows = BEADSWIM_INSTRUCTION_SET::gather_mirror_flows,
    .spread_moments = BEADSWIM_INSTRUCTION_SET::spread_moments,
    .gather_moments = BEADSWIM_INSTRUCTION_SET::gather_moments};

}  // namespace beadswim
