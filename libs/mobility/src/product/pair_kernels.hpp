#pragma once

#if defined(__AVX512VL__)
#include <immintrin.h>
#endif

#include <cmath>

#include "beadswim/core/kernel.hpp"
#include "mobility_kernels.hpp"

// Kernels of pairs of spheres on which forces act. Only for files that are compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Rounds to the nearest integer, for |value| < 2^51.
BEADSWIM_KERNEL double rounded(double value) {
  constexpr double shift = 0x1.8p52;
  return (value + shift) - shift;
}

/// Sets d to the vector from another sphere to the one sphere at the position `at`; returns its square.
BEADSWIM_KERNEL double separation(const SortedSpheres& spheres, const double (&at)[3],
                                  const double (&inverse)[3], int other, double (&d)[3]) {
  d[0] = at[0] - spheres.x[other];
  d[1] = at[1] - spheres.y[other];
  d[2] = at[2] - spheres.z[other];
  double square = 0;
  for (int a = 0; a < 3; ++a) {
    d[a] -= spheres.lengths[a] * rounded(d[a] * inverse[a]);
    square += d[a] * d[a];
  }
  return square;
}

struct Place {
  double at[3], inverse[3];

  BEADSWIM_KERNEL Place(const SortedSpheres& spheres, int one)
      : at{spheres.x[one], spheres.y[one], spheres.z[one]} {
    for (int a = 0; a < 3; ++a) inverse[a] = spheres.lengths[a] > 0 ? 1 / spheres.lengths[a] : 0;
  }
};

/// Writes begin + t for all values[t] above `from` and at most `to`, of `count` values; returns their number.
/// Also writes up to 8 numbers behind them. `values` has elements up to a multiple of 8.
BEADSWIM_KERNEL int select(const double* values, int count, int begin, double from, double to, int* indices) {
  int found = 0;
#if defined(__AVX512VL__)
  const __m512d above = _mm512_set1_pd(from), limit = _mm512_set1_pd(to);
  __m256i index = _mm256_add_epi32(_mm256_set1_epi32(begin), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  for (int t = 0; t < count; t += 8, index = _mm256_add_epi32(index, _mm256_set1_epi32(8))) {
    const __m512d value = _mm512_loadu_pd(values + t);
    const unsigned inside = _mm512_cmp_pd_mask(value, above, _CMP_GT_OQ) &
                            _mm512_cmp_pd_mask(value, limit, _CMP_LE_OQ),
                   valid = count - t < 8 ? (1U << (count - t)) - 1 : 255;
    const auto mask = static_cast<__mmask8>(inside & valid);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(indices + found),
                        _mm256_maskz_compress_epi32(mask, index));
    found += __builtin_popcount(mask);
  }
#else
  for (int t = 0; t < count; ++t) {
    indices[found] = begin + t;
    found += static_cast<int>(values[t] > from) & static_cast<int>(values[t] <= to);
  }
#endif
  return found;
}

int find_near_spheres(const SortedSpheres& spheres, int one, int begin, int end, double cutoff, double close,
                      NearSpheres& near) {
  constexpr int chunk = 128;
  double r2[chunk];
  const Place place(spheres, one);
  const double limit = cutoff * cutoff;
  const unsigned char wanted = spheres.is_receiver[one];
  for (; begin < end && near.count + chunk <= NearSpheres::capacity &&
         near.close_count + chunk <= NearSpheres::capacity;
       begin += chunk) {
    const int n = end - begin < chunk ? end - begin : chunk;
    for (int t = 0; t < n; ++t) {
      double d[3];
      r2[t] = separation(spheres, place.at, place.inverse, begin + t, d);
    }
    if (wanted == 0)
      for (int t = 0; t < n; ++t)
        if (spheres.is_receiver[begin + t] == 0) r2[t] = 2 * limit;
    near.count += select(r2, n, begin, close, limit, near.others + near.count);
    near.close_count += select(r2, n, begin, -1, std::fmin(close, limit), near.close + near.close_count);
  }
  return begin < end ? begin : end;
}

template <int functions>
BEADSWIM_KERNEL void pair_velocities_of(const PairTable& table, const SortedSpheres& spheres, int one,
                                        int count, const int* indices, const double* const* force,
                                        double* const* velocity) {
  const Place place(spheres, one);
  const double* const coefficients = table.coefficients;
  const std::int64_t first = table.first;
  const double *const force_x = force[0], *const force_y = force[1], *const force_z = force[2];
  const double fx = force_x[one], fy = force_y[one], fz = force_z[one];
  double sx = 0, sy = 0, sz = 0, others[3][NearSpheres::capacity];
#pragma omp simd reduction(+ : sx, sy, sz)
  for (int t = 0; t < count; ++t) {
    const int other = indices[t];
    double d[3];
    const double r2 = separation(spheres, place.at, place.inverse, other, d);
    const std::int64_t bits = __builtin_bit_cast(std::int64_t, r2);
    constexpr std::int64_t fraction = (std::int64_t{1} << 52) - 1, unit = std::int64_t{0x3ff} << 52;
    const std::int64_t within = ((bits << PairTable::stretch_bits) & fraction) | unit;
    const double p = __builtin_bit_cast(double, within) - 1;
    const double* c =
        coefficients + ((bits >> PairTable::shift) - first) * (functions * (PairTable::degree + 1));
    double value[functions];
#pragma GCC unroll 6
    for (int f = 0; f < functions; ++f) value[f] = c[PairTable::degree * functions + f];
#pragma GCC unroll 6
    for (int k = PairTable::degree - 1; k >= 0; --k) {
#pragma GCC unroll 6
      for (int f = 0; f < functions; ++f) value[f] = value[f] * p + c[k * functions + f];
    }
    double isotropic = value[0], axial = value[1];
    if constexpr (functions >= 4) {
      const double squares = spheres.squares[one] + spheres.squares[other];
      isotropic += squares * value[2];
      axial += squares * value[3];
    }
    if constexpr (functions == 6) {
      const double product = spheres.squares[one] * spheres.squares[other];
      isotropic += product * value[4];
      axial += product * value[5];
    }
    const double gx = force_x[other], gy = force_y[other], gz = force_z[other];
    const double along = axial * (d[0] * fx + d[1] * fy + d[2] * fz);
    others[0][t] = isotropic * fx + along * d[0];
    others[1][t] = isotropic * fy + along * d[1];
    others[2][t] = isotropic * fz + along * d[2];
    const double back = axial * (d[0] * gx + d[1] * gy + d[2] * gz);
    sx += isotropic * gx + back * d[0];
    sy += isotropic * gy + back * d[1];
    sz += isotropic * gz + back * d[2];
  }
  for (int t = 0; t < count; ++t)
    for (int a = 0; a < 3; ++a) velocity[a][indices[t]] += others[a][t];
  velocity[0][one] += sx;
  velocity[1][one] += sy;
  velocity[2][one] += sz;
}

void pair_velocities(const PairTable& table, const SortedSpheres& spheres, int one, int count,
                     const int* others, const double* const* force, double* const* velocity) {
  table.functions == 2   ? pair_velocities_of<2>(table, spheres, one, count, others, force, velocity)
  : table.functions == 4 ? pair_velocities_of<4>(table, spheres, one, count, others, force, velocity)
                         : pair_velocities_of<6>(table, spheres, one, count, others, force, velocity);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
