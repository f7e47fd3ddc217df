#pragma once

#include "mesh_window.hpp"

// Kernels of the mesh. Only for files that are compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// `size`: points in a row of a padded window.
template <int size, int order>
void spread_of(const WindowMesh& mesh, const WindowBeads& beads, const double* sources, double* const* onto) {
  constexpr int count = derivative_count(order), quads = size / quad;
  Window<size, order> w;
  for (long b = 0; b < beads.count; ++b, sources += 3 * count) {
    w.set_position(mesh, beads.positions + 3 * b);
    const bool wraps = w.wraps(mesh);
    Quad z[order + 1][quads];  // weights along z and their derivatives
    for (int k = 0; k <= order; ++k)
      for (int g = 0; g < quads; ++g) z[k][g] = load_as<Quad>(w.weight[k][2] + quad * g);
    for (int p = 0; p < mesh.window; ++p) {
      if (w.planes[p] < 0) continue;
      for (int q = 0; q < mesh.window; ++q) {
        const long start = w.row(mesh, p, q);
        double weights[order + 1][order + 1];
        for (int i = 0; i <= order; ++i)
          for (int j = 0; i + j <= order; ++j) weights[i][j] = w.weight[i][0][p] * w.weight[j][1][q];
#pragma GCC unroll 3
        for (int c = 0; c < 3; ++c) {
          double along[order + 1];  // factors of the weights along z and of their derivatives
#pragma GCC unroll 10
          for (int d = 0; d < count; ++d) {
            const auto& [i, j, k] = derivative_table.degree[d];
            const double factor = sources[c * count + d] * weights[i][j];
            along[k] = i + j == 0 ? factor : along[k] + factor;
          }
          const auto values = [&](int g) __attribute__((always_inline)) {
            Quad sum = along[0] * z[0][g];
            for (int k = 1; k <= order; ++k) sum += along[k] * z[k][g];
            return sum;
          };
          double* const row = onto[c] + start;
          if (wraps) {
            double at_columns[size];
            for (int g = 0; g < quads; ++g) store_as(at_columns + quad * g, values(g));
#pragma GCC unroll 1
            for (int s = 0; s < mesh.window; ++s) row[w.columns[s]] += at_columns[s];
          } else {
            double* const at = row + w.first[2];
#pragma GCC unroll 5
            for (int g = 0; g < quads; ++g) store_as(at + quad * g, load_as<Quad>(at + quad * g) + values(g));
          }
        }
      }
    }
  }
}

/// Gathers `together` components of the values at one bead at once; more need too many registers for high
/// orders.
template <int size, int order, int together>
BEADSWIM_KERNEL void gather_components(const WindowMesh& mesh, const Window<size, order>& w,
                                       const double* const* from, double* flow) {
  constexpr int count = derivative_count(order), pairs = (order + 1) * (order + 2) / 2, quads = size / quad;
  const auto across = [](int i, int j) { return i * (2 * order + 3 - i) / 2 + j; };
  const bool wraps = w.wraps(mesh);
  // Sums over the window points of the first two axes, weighted by the derivatives (i, j) along them.
  Quad sums[together][pairs][quads]{};
  double at_columns[size]{};  // values of a row that wraps
  for (int p = 0; p < mesh.window; ++p) {
    if (w.planes[p] < 0) continue;
    for (int q = 0; q < mesh.window; ++q) {
      const long start = w.row(mesh, p, q);
      double weights[pairs];
      for (int i = 0; i <= order; ++i)
        for (int j = 0; j <= order - i; ++j) weights[across(i, j)] = w.weight[i][0][p] * w.weight[j][1][q];
#pragma GCC unroll 3
      for (int c = 0; c < together; ++c) {
        const double* const row = from[c] + start;
        const double* at = row + w.first[2];
        if (wraps) {
#pragma GCC unroll 1
          for (int s = 0; s < mesh.window; ++s) at_columns[s] = row[w.columns[s]];
          at = at_columns;
        }
#pragma GCC unroll 5
        for (int g = 0; g < quads; ++g) {
          const Quad values = load_as<Quad>(at + quad * g);
#pragma GCC unroll 15
          for (int k = 0; k < pairs; ++k) sums[c][k][g] += weights[k] * values;
        }
      }
    }
  }
  // The window depends on mesh point minus bead position: odd derivatives by the bead position have the
  // opposite sign.
  for (int c = 0; c < together; ++c) {
    for (int d = 0; d < count; ++d) {
      const auto& [i, j, k] = derivative_table.degree[d];
      Quad along{};
      for (int g = 0; g < quads; ++g)
        along += sums[c][across(i, j)][g] * load_as<Quad>(w.weight[k][2] + quad * g);
      const double sum = (along[0] + along[1]) + (along[2] + along[3]);
      flow[c * count + d] += derivative_table.order[d] % 2 == 0 ? sum : -sum;
    }
  }
}

template <int size, int order>
void gather_of(const WindowMesh& mesh, const WindowBeads& beads, int components, const double* const* from,
               double* flows) {
  constexpr int count = derivative_count(order);
  Window<size, order> w;
  for (long b = 0; b < beads.count; ++b, flows += components * count) {
    w.set_position(mesh, beads.positions + 3 * b);
    if (components == 3 && order <= 1) {
      gather_components<size, order, 3>(mesh, w, from, flows);
    } else {
      for (int c = 0; c < components; ++c)
        gather_components<size, order, 1>(mesh, w, from + c, flows + c * count);
    }
  }
}

using Spread = void (*)(const WindowMesh&, const WindowBeads&, const double*, double* const*);
template <int order>
constexpr Spread spreads[]{spread_of<4, order>, spread_of<8, order>, spread_of<12, order>,
                           spread_of<16, order>, spread_of<20, order>};
using Gather = void (*)(const WindowMesh&, const WindowBeads&, int, const double* const*, double*);
template <int order>
constexpr Gather gathers[]{gather_of<4, order>, gather_of<8, order>, gather_of<12, order>,
                           gather_of<16, order>, gather_of<20, order>};

void spread(int order, const WindowMesh& mesh, const WindowBeads& beads, const double* sources,
            double* const* onto) {
  constexpr const Spread* by_order[]{spreads<0>, spreads<1>, spreads<2>};
  by_order[order][(mesh.window - 1) / 4](mesh, beads, sources, onto);
}

void gather(int order, const WindowMesh& mesh, const WindowBeads& beads, int components,
            const double* const* from, double* flows) {
  constexpr const Gather* by_order[]{gathers<0>, gathers<1>, gathers<2>, gathers<3>, gathers<4>};
  by_order[order][(mesh.window - 1) / 4](mesh, beads, components, from, flows);
}

void multiply_waves(const WaveRow& row, int fields, const FieldFactors* factors, double* const* values) {
  constexpr int chunk = 64;
  double k2[chunk], inverse[chunk], share[chunk], inverse_share[chunk], F[3][chunk], D[3][chunk];
  const double kx = row.kx, ky = row.ky;
  // Far beyond k = shape/cutoff, s is negligible, and the sum of its terms would lose digits.
  const double lowest = -0.2 * row.square;
  for (long begin = 0; begin < row.count; begin += chunk) {
    const int n = row.count - begin < chunk ? static_cast<int>(row.count - begin) : chunk;
    const double* const kz = row.kz + begin;
    for (int t = 0; t < n; ++t) {
      k2[t] = kx * kx + ky * ky + kz[t] * kz[t];
      inverse[t] = k2[t] > 0 ? 1 / k2[t] : 0;
    }
    for (int t = 0; t < n; ++t) share[t] = row.far_terms[row.terms - 1];
    for (int p = row.terms - 2; p >= 0; --p)
      for (int t = 0; t < n; ++t)
        share[t] = share[t] * (row.square - row.cutoff_square * k2[t]) + row.far_terms[p];
    for (int t = 0; t < n; ++t)
      inverse_share[t] = row.square - row.cutoff_square * k2[t] > lowest ? share[t] * inverse[t] : 0;
    for (int c = 0; c < 3; ++c) {
      for (int t = 0; t < n; ++t) F[c][t] = D[c][t] = 0;
      for (int f = 0; f < fields; ++f) {
        const auto [p, q] = factors[f];
        const double* const source = values[3 * f + c] + begin;
        for (int t = 0; t < n; ++t) {
          F[c][t] += p * source[t];
          D[c][t] += q * source[t];
        }
      }
    }
    for (int t = 0; t < n; ++t) {
      const double f = (kx * F[0][t] + ky * F[1][t] + kz[t] * F[2][t]) * inverse[t],
                   d = (kx * D[0][t] + ky * D[1][t] + kz[t] * D[2][t]) * inverse[t];
      const double k[3]{kx, ky, kz[t]};
      const double K = row.scale * row.window[begin + t] * inverse_share[t];
      for (int c = 0; c < 3; ++c) {
        const double size = K * k2[t] / 6;
        F[c][t] -= f * k[c];
        D[c][t] = K * F[c][t] - size * (D[c][t] - d * k[c]);
        F[c][t] *= size;
      }
    }
    for (int f = 0; f < fields; ++f) {
      const auto [p, q] = factors[f];
      for (int c = 0; c < 3; ++c) {
        double* const flow = values[3 * f + c] + begin;
        for (int t = 0; t < n; ++t) flow[t] = p * D[c][t] - q * F[c][t];
      }
    }
  }
}

void multiply_tensors(long waves, int fields, const double* const* kernel, double* const* values) {
  constexpr int chunk = 256, row[3][3]{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  double twice[chunk], results[6][chunk];
  for (long begin = 0; begin < waves; begin += chunk / 2) {
    const int n = waves - begin < chunk / 2 ? static_cast<int>(waves - begin) : chunk / 2;
    const auto add = [&](int tensor, int from, double* sum, int c) __attribute__((always_inline)) {
      for (int e = 0; e < 3; ++e) {
        const double *const element = kernel[6 * tensor + row[c][e]] + begin, *const source =
                                                                                  values[3 * from + e] +
                                                                                  2 * begin;
        for (int t = 0; t < n; ++t) twice[2 * t] = twice[2 * t + 1] = element[t];
        for (int t = 0; t < 2 * n; ++t) sum[t] += twice[t] * source[t];
      }
    };
    for (int k = 0; k < 3 * fields; ++k)
      for (int t = 0; t < 2 * n; ++t) results[k][t] = 0;
    for (int c = 0; c < 3; ++c) {
      add(0, 0, results[c], c);
      if (fields == 2) {
        add(1, 1, results[c], c);
        add(1, 0, results[3 + c], c);
      }
    }
    for (int k = 0; k < 3 * fields; ++k)
      for (int t = 0; t < 2 * n; ++t) values[k][2 * begin + t] = results[k][t];
  }
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
