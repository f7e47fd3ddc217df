#include "wall_reflection.hpp"

#include "moment_flow.hpp"

namespace beadswim {
namespace {

/// Derivatives of functions of x that are known at the mirror point: phi and q (wall_reflection.hpp).
struct Mirrored {
  const double* values;
  int axis;

  /// Returns the derivative e, by x, of the function.
  double operator()(int e) const {
    return derivative_table.degree[e][axis] % 2 == 0 ? values[e] : -values[e];
  }
};

/// Returns the number of derivative e with one order less along the axis.
int lowered(int e, int axis) {
  std::array<int, 3> degree{derivative_table.degree[e][0], derivative_table.degree[e][1],
                            derivative_table.degree[e][2]};
  --degree[axis];
  return derivative_table.index[degree[0]][degree[1]][degree[2]];
}

}  // namespace

void add_reflected_flow(int order, int axis, double height, const std::array<double, 3>& sizes,
                        const MirrorFlow& at_mirror, double* flow) {
  const int count = derivative_count(order);
  const Mirrored phi{at_mirror.across, axis}, q{at_mirror.pressure, axis};
  const auto& plus = derivative_sums.of;
  for (int t = 0; t < 3; ++t) {
    const int c = (axis + 1 + t) % 3;
    const Mirrored v{t < 2 ? at_mirror.along[t] : at_mirror.across, axis};
    for (int e = 0; e < count; ++e) {
      const int k = derivative_table.degree[e][axis], slope = plus[e][1 + c];
      double sum = -v(e) + height * (2 * phi(slope) + height * q(slope));
      if (k > 0) {
        const int lower = plus[lowered(e, axis)][1 + c];
        sum += 2 * k * (phi(lower) + height * q(lower));
        if (k > 1) sum += k * (k - 1) * q(plus[lowered(lowered(e, axis), axis)][1 + c]);
      }
      const int along_c = k + (c == axis ? 1 : 0), rise = plus[slope][1 + axis];
      const double laplacian = (1 + 2 * along_c) * q(slope) + 2 * height * q(rise) + 4 * phi(rise);
      flow[c * count + e] += sum + sizes[derivative_table.order[e]] * laplacian;
    }
  }
}

}  // namespace beadswim
