#pragma once

#include "beadswim/core/kernel.hpp"
#include "beadswim/mobility/derivative_table.hpp"

// clang-format off
// Flow of the force moments of one sphere at another sphere (force_moments.hpp), from derivatives of two radial
// functions of the vector r from the one to the other:
//
//   8 pi eta u_c = sum_d [ A_c^d D^d L - sum_b A_b^d D^(d + e_b + e_c) chi ]
//
//   chi    function of the Oseen tensor, (I laplacian - grad grad) chi/(8 pi eta);  L = laplacian chi
//   A_c^d  coefficients of the derivatives of a point force at the one sphere
//   D^d    derivative;  e_b  derivative by component b
//
// Cartesian derivatives of a function f of the distance follow from R(n, d) = D^d ((1/r) d/dr)^n f:
//
//   R(n, d + e_a) = d_a R(n + 1, d - e_a) + r_a R(n + 1, d)
//
// McMurchie & Davidson, J. Comput. Phys. 26 (1978) 218 (recursion).
// clang-format on

namespace beadswim {

/// Number of the sum of two derivatives of orders up to 5; 0 if the order of the sum is above the maximum.
struct DerivativeSums {
  unsigned char of[derivative_count(5)][derivative_count(5)]{};
};
constexpr DerivativeSums derivative_sums = [] {
  DerivativeSums sums;
  for (int d = 0; d < derivative_count(5); ++d) {
    for (int e = 0; e < derivative_count(5); ++e) {
      if (derivative_table.order[d] + derivative_table.order[e] > max_derivative_order) continue;
      const auto &p = derivative_table.degree[d], &q = derivative_table.degree[e];
      sums.of[d][e] =
          static_cast<unsigned char>(derivative_table.index[p[0] + q[0]][p[1] + q[1]][p[2] + q[2]]);
    }
  }
  return sums;
}();

/// Terms of the recursion for R(n, d + e_a): the derivatives with one and two orders less along axis a.
struct DerivativeSteps {
  struct Step {
    unsigned char axis, one_less, two_less;
    double factor;
  };
  Step of[DerivativeTable::size]{};
};
constexpr DerivativeSteps derivative_steps = [] {
  DerivativeSteps steps;
  for (int d = 1; d < DerivativeTable::size; ++d) {
    int degree[3] = {derivative_table.degree[d][0], derivative_table.degree[d][1],
                     derivative_table.degree[d][2]};
    const int axis = degree[0] > 0 ? 0 : (degree[1] > 0 ? 1 : 2);
    DerivativeSteps::Step& step = steps.of[d];
    step.axis = static_cast<unsigned char>(axis);
    step.factor = --degree[axis];
    step.one_less = static_cast<unsigned char>(derivative_table.index[degree[0]][degree[1]][degree[2]]);
    if (degree[axis] == 0) continue;
    --degree[axis];
    step.two_less = static_cast<unsigned char>(derivative_table.index[degree[0]][degree[1]][degree[2]]);
  }
  return steps;
}();

/// Sets result[d] to the derivative d of a function f of r, for all derivatives up to `order`. radial[n]:
/// ((1/r) d/dr)^n f, n = 0 to `order`. Value: double, or a vector of doubles with one lane per pair.
template <int order, class Value>
BEADSWIM_KERNEL void cartesian_derivatives(const Value (&r)[3], const Value* radial, Value* result) {
  Value other[derivative_count(order)];
  Value *now = (order % 2 == 0) ? result : other, *above = (order % 2 == 0) ? other : result;
  now[0] = radial[order];
  for (int n = order - 1; n >= 0; --n) {
    Value* const swapped = above;
    above = now;
    now = swapped;
    now[0] = radial[n];
    for (int d = 1; d < derivative_count(order - n); ++d) {
      const DerivativeSteps::Step& step = derivative_steps.of[d];
      now[d] = r[step.axis] * above[step.one_less];
      if (step.factor > 0) now[d] += step.factor * above[step.two_less];
    }
  }
}

/// Derivatives of the radial functions of a pair, divided by 8 pi eta, for moments up to `order`. For spheres
/// of finite size, chi is replaced by chi + (c_i a_i^2 + c_j a_j^2) laplacian chi.
template <int order, class Value>
struct PairDerivatives {
  Value chi[derivative_count(2 + 2 * order)], laplacian[derivative_count(2 + 2 * order)],
      bilaplacian[derivative_count(2 * order)];
};

/// Adds the flow at a sphere, up to its derivatives of `order`, to `flow` (order of elements:
/// force_moments.hpp).
///   source         A_c^d of the other sphere
///   scaled_source  c_l a^2 A_c^d for the radius a of the other sphere
///   size           c_l a^2 for the radius a of the sphere itself, l = 0, 1, 2
template <int order, class Value>
BEADSWIM_KERNEL void add_moment_flow(const PairDerivatives<order, Value>& pair, const Value* source,
                                     const Value* scaled_source, const Value (&size)[3], Value* flow) {
  constexpr int count = derivative_count(order), next = derivative_count(order + 1);
  // Derivatives of div(A chi), and of its Laplacian, for all derivatives up to the next order.
  Value divergence_flow[next], scaled_divergence_flow[next];
  for (int e = 1; e < next; ++e) {
    Value sum{}, scaled_sum{};
    for (int b = 0; b < 3; ++b) {
      const unsigned char* const by_b = derivative_sums.of[1 + b];
      for (int d = 0; d < count; ++d) {
        const int all = derivative_sums.of[by_b[d]][e];
        sum += source[b * count + d] * pair.chi[all] + scaled_source[b * count + d] * pair.laplacian[all];
        scaled_sum += source[b * count + d] * pair.laplacian[all];
      }
    }
    divergence_flow[e] = sum;
    scaled_divergence_flow[e] = scaled_sum;
  }
  for (int c = 0; c < 3; ++c) {
    for (int e = 0; e < count; ++e) {
      Value sum{}, scaled_sum{};
      for (int d = 0; d < count; ++d) {
        const int both = derivative_sums.of[d][e];
        sum += source[c * count + d] * pair.laplacian[both] +
               scaled_source[c * count + d] * pair.bilaplacian[both];
        scaled_sum += source[c * count + d] * pair.bilaplacian[both];
      }
      const int by_c = derivative_sums.of[1 + c][e];
      flow[c * count + e] += sum - divergence_flow[by_c] +
                             size[derivative_table.order[e]] * (scaled_sum - scaled_divergence_flow[by_c]);
    }
  }
}

}  // namespace beadswim
