// Compiled once per instruction set. BEADSWIM_INSTRUCTION_SET is the namespace of the instruction set.
#include "mobility_kernels.hpp"

#include "beadswim/core/kernel.hpp"
#include "mesh_window.hpp"

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Rounds to the nearest integer, for |value| < 2^51.
BEADSWIM_KERNEL double rounded(double value) {
  constexpr double shift = 0x1.8p52;
  return (value + shift) - shift;
}

int find_near_spheres(const SortedSpheres& spheres, int one, int begin, int end, double cutoff,
                      PairBatch& batch) {
  constexpr int chunk = 128;
  double d[3][chunk], r2[chunk];
  const double at[3]{spheres.x[one], spheres.y[one], spheres.z[one]};
  double inverse[3];
  for (int a = 0; a < 3; ++a) inverse[a] = spheres.lengths[a] > 0 ? 1 / spheres.lengths[a] : 0;
  const double limit = cutoff * cutoff;
  const unsigned char wanted = spheres.is_receiver[one];
  for (; begin < end && batch.count + chunk <= PairBatch::capacity; begin += chunk) {
    const int n = end - begin < chunk ? end - begin : chunk;
    const double* const places[3]{spheres.x + begin, spheres.y + begin, spheres.z + begin};
    for (int t = 0; t < n; ++t) r2[t] = 0;
    for (int a = 0; a < 3; ++a) {
      for (int t = 0; t < n; ++t) {
        double along = at[a] - places[a][t];
        along -= spheres.lengths[a] * rounded(along * inverse[a]);
        d[a][t] = along;
        r2[t] += along * along;
      }
    }
    int count = batch.count;
    for (int t = 0; t < n; ++t) {
      batch.other[count] = begin + t;
      batch.d[0][count] = d[0][t];
      batch.d[1][count] = d[1][t];
      batch.d[2][count] = d[2][t];
      batch.r2[count] = r2[t];
      count += (r2[t] < limit) & (wanted | spheres.is_receiver[begin + t]);
    }
    batch.count = count;
  }
  return begin < end ? begin : end;
}

template <int functions>
BEADSWIM_KERNEL void pair_velocities_of(const PairTable& table, const double* force, PairBatch& b,
                                        double* velocity) {
  const double* const coefficients = table.coefficients;
  const std::int64_t first = table.first;
  const double fx = force[0], fy = force[1], fz = force[2];
  double sx = 0, sy = 0, sz = 0;
#pragma omp simd reduction(+ : sx, sy, sz)
  for (int t = 0; t < b.count; ++t) {
    const std::int64_t bits = __builtin_bit_cast(std::int64_t, b.r2[t]);
    constexpr std::int64_t fraction = (std::int64_t{1} << 52) - 1, one = std::int64_t{0x3ff} << 52;
    const std::int64_t within = ((bits << PairTable::stretch_bits) & fraction) | one;
    const double p = __builtin_bit_cast(double, within) - 1;
    const double* c =
        coefficients + ((bits >> PairTable::shift) - first) * (functions * (PairTable::degree + 1));
    double value[functions];
#pragma GCC unroll 4
    for (int f = 0; f < functions; ++f) value[f] = c[PairTable::degree * functions + f];
#pragma GCC unroll 6
    for (int k = PairTable::degree - 1; k >= 0; --k) {
#pragma GCC unroll 4
      for (int f = 0; f < functions; ++f) value[f] = value[f] * p + c[k * functions + f];
    }
    double isotropic = value[0], axial = value[1];
    if constexpr (functions == 4) {
      isotropic += b.squares[t] * value[2];
      axial += b.squares[t] * value[3];
    }
    const double dx = b.d[0][t], dy = b.d[1][t], dz = b.d[2][t];
    const double gx = b.force[0][t], gy = b.force[1][t], gz = b.force[2][t];
    const double along = axial * (dx * fx + dy * fy + dz * fz);
    b.velocity[0][t] = isotropic * fx + along * dx;
    b.velocity[1][t] = isotropic * fy + along * dy;
    b.velocity[2][t] = isotropic * fz + along * dz;
    const double back = axial * (dx * gx + dy * gy + dz * gz);
    sx += isotropic * gx + back * dx;
    sy += isotropic * gy + back * dy;
    sz += isotropic * gz + back * dz;
  }
  velocity[0] += sx;
  velocity[1] += sy;
  velocity[2] += sz;
}

void pair_velocities(const PairTable& table, const double* force, PairBatch& batch, double* velocity) {
  table.functions == 2 ? pair_velocities_of<2>(table, force, batch, velocity)
                       : pair_velocities_of<4>(table, force, batch, velocity);
}

template <int P>
BEADSWIM_KERNEL void spread_of(const WindowMesh& mesh, const WindowBeads& beads, const double* numbers,
                               double* const* onto) {
  Window<P> w;
  for (long b = 0; b < beads.count; ++b) {
    w.set_position(mesh, beads.positions + 3 * b);
    const bool wraps = w.wraps(mesh);
    for (int c = 0; c < 3; ++c) {
      const double number = numbers[3 * b + c];
      for (int p = 0; p < P; ++p) {
        if (w.planes[p] < 0) continue;
        for (int q = 0; q < P; ++q) {
          double* const row = onto[c] + w.row(mesh, p, q);
          const double strength = number * w.weight[0][p] * w.weight[1][q];
          if (wraps) {
            for (int s = 0; s < P; ++s)
              row[Window<P>::wrapped(w.first[2] + s, mesh.points[2])] += strength * w.weight[2][s];
          } else {
            double* const at = row + w.first[2];
#pragma GCC ivdep
            for (int s = 0; s < P; ++s) at[s] += strength * w.weight[2][s];
          }
        }
      }
    }
  }
}

template <int P>
BEADSWIM_KERNEL void gather_of(const WindowMesh& mesh, const WindowBeads& beads, const double* const* from,
                               double* numbers) {
  Window<P> w;
  for (long b = 0; b < beads.count; ++b) {
    w.set_position(mesh, beads.positions + 3 * b);
    const bool wraps = w.wraps(mesh);
    for (int c = 0; c < 3; ++c) {
      double along[P]{};  // weighted sums over the window points of the first two axes
      for (int p = 0; p < P; ++p) {
        if (w.planes[p] < 0) continue;
        for (int q = 0; q < P; ++q) {
          const double* const row = from[c] + w.row(mesh, p, q);
          const double weight = w.weight[0][p] * w.weight[1][q];
          if (wraps) {
            for (int s = 0; s < P; ++s)
              along[s] += weight * row[Window<P>::wrapped(w.first[2] + s, mesh.points[2])];
          } else {
            const double* const at = row + w.first[2];
#pragma GCC ivdep
            for (int s = 0; s < P; ++s) along[s] += weight * at[s];
          }
        }
      }
      double sum = 0;
      for (int s = 0; s < P; ++s) sum += along[s] * w.weight[2][s];
      numbers[3 * b + c] += sum;
    }
  }
}

void multiply_waves(const WaveRow& row, int fields, const FieldFactors* factors, double* const* values) {
  constexpr int chunk = 64;
  double k2[chunk], inverse[chunk], F[3][chunk], D[3][chunk];
  const double kx = row.kx, ky = row.ky, width = 1 / (4 * row.xi * row.xi);
  for (long begin = 0; begin < row.count; begin += chunk) {
    const int n = row.count - begin < chunk ? static_cast<int>(row.count - begin) : chunk;
    const double* const kz = row.kz + begin;
    for (int t = 0; t < n; ++t) {
      k2[t] = kx * kx + ky * ky + kz[t] * kz[t];
      inverse[t] = k2[t] > 0 ? 1 / k2[t] : 0;
    }
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
      const double K = row.scale * row.decay[begin + t] * (1 + k2[t] * width) * inverse[t];
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

void spread_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* numbers,
                    double* const* onto) {
  with_window(
      mesh.window, [&]<int P>() __attribute__((always_inline)) { spread_of<P>(mesh, beads, numbers, onto); });
}

void gather_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* const* from,
                    double* numbers) {
  with_window(
      mesh.window, [&]<int P>() __attribute__((always_inline)) { gather_of<P>(mesh, beads, from, numbers); });
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET

namespace beadswim {

const MobilityKernels MobilityKernels::BEADSWIM_INSTRUCTION_SET{
    .find_near_spheres = BEADSWIM_INSTRUCTION_SET::find_near_spheres,
    .pair_velocities = BEADSWIM_INSTRUCTION_SET::pair_velocities,
    .multiply_waves = BEADSWIM_INSTRUCTION_SET::multiply_waves};

}  // namespace beadswim
