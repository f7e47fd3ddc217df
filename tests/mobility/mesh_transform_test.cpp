#include "mesh_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace beadswim {
namespace {

using Points = std::array<int, 3>;

/// Value at a mesh point, different at all points.
double value_at(int x, int y, int z) {
  return std::sin(1.0 + x + 0.1 * x * y) + 0.3 * y - std::cos(0.7 * z * z + x);
}

/// Evaluates the definition of a Fourier transform, sum over the points of value exp(-2 pi i k x/n).
Complex exact_mode(const Points& n, int i, int j, int k) {
  Complex sum = 0;
  for (int x = 0; x < n[0]; ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
        sum += value_at(x, y, z) *
               std::polar(1.0, -2 * std::numbers::pi *
                                   (double(i * x) / n[0] + double(j * y) / n[1] + double(k * z) / n[2]));
  return sum;
}

template <class Visitor>
void for_each_point(const MeshTransform& transform, const Points& n, const Visitor& visit) {
  for (int x = 0; x < transform.planes(); ++x)
    for (int y = 0; y < n[1]; ++y)
      for (int z = 0; z < n[2]; ++z)
        visit((std::ptrdiff_t{x} * n[1] + y) * 2 * (n[2] / 2 + 1) + z, transform.first_plane() + x, y, z);
}

// Odd edges, and fewer planes than ranks.
TEST(MeshTransform, IsTheFourierTransform) {
  const Communicator world(MPI_COMM_WORLD);
  for (const Points& n : {Points{6, 9, 8}, {7, 4, 5}, {2, 10, 3}, {10, 2, 4}, {2, 2, 4}}) {
    const MeshTransform transform(n, n, world);
    const FftwArray values = transform.array();
    for_each_point(transform, n,
                   [&](std::ptrdiff_t place, int x, int y, int z) { values[place] = value_at(x, y, z); });
    transform.forward(values);
    int waves = 0;
    double difference = 0;
    transform.for_each_wave([&](std::ptrdiff_t place, int i, int j, int k) {
      difference = std::max(difference, std::abs(as_complex(values)[place] - exact_mode(n, i, j, k)));
      ++waves;
    });
    EXPECT_LT(difference, 1e-12);
    EXPECT_EQ(waves, transform.wave_count());
    MPI_Allreduce(MPI_IN_PLACE, &waves, 1, MPI_INT, MPI_SUM, world.get());
    EXPECT_EQ(waves, n[0] * n[1] * (n[2] / 2 + 1));

    transform.backward(values);
    double change = 0;
    for_each_point(transform, n, [&](std::ptrdiff_t place, int x, int y, int z) {
      change = std::max(change, std::abs(values[place] / (n[0] * n[1] * n[2]) - value_at(x, y, z)));
    });
    EXPECT_LT(change, 1e-14);
  }
}

}  // namespace
}  // namespace beadswim
