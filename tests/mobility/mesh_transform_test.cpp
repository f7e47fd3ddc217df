#include "mesh_transform.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace beadswim {
namespace {

using Points = std::array<int, 3>;

/// Value at a mesh point, different at all points.
double value_at(int x, int y, int z) {
  return std::sin(1.0 + x + 0.1 * x * y) + 0.3 * y - std::cos(0.7 * z * z + x);
}

/// Evaluates the definition of a Fourier transform, sum over the used points of value exp(-2 pi i k x/n).
Complex exact_mode(const Points& n, const Points& used, int i, int j, int k) {
  Complex sum = 0;
  for (int x = 0; x < used[0]; ++x)
    for (int y = 0; y < used[1]; ++y)
      for (int z = 0; z < used[2]; ++z)
        sum += value_at(x, y, z) *
               std::polar(1.0, -2 * std::numbers::pi *
                                   (double(i * x) / n[0] + double(j * y) / n[1] + double(k * z) / n[2]));
  return sum;
}

template <class Visitor>
void for_each_point(const MeshTransform& transform, const Visitor& visit) {
  const Points &n = transform.points(), &used = transform.used();
  for (int x = 0; x < transform.planes(); ++x)
    for (int y = 0; y < used[1]; ++y)
      for (int z = 0; z < used[2]; ++z)
        visit((std::ptrdiff_t{x} * n[1] + y) * 2 * (n[2] / 2 + 1) + z, transform.first_plane() + x, y, z);
}

// Odd edges, fewer planes than ranks, and values at some of the points alone.
TEST(MeshTransform, IsTheFourierTransform) {
  const Communicator world(MPI_COMM_WORLD);
  for (const auto& [n, used] : {std::pair{Points{6, 9, 8}, Points{6, 9, 8}},
                                {{7, 4, 5}, {7, 4, 5}},
                                {{2, 10, 3}, {2, 10, 3}},
                                {{10, 2, 4}, {10, 2, 4}},
                                {{2, 2, 4}, {2, 2, 4}},
                                {{6, 9, 8}, {3, 5, 4}},
                                {{7, 4, 5}, {1, 3, 5}}}) {
    const MeshTransform transform(n, used, world);
    const FftwArray values = transform.array();
    int waves = 0;
    const auto transform_values = [&] {
      std::fill_n(values.get(), transform.reals(), 0.0);
      for_each_point(
          transform, [&](std::ptrdiff_t place, int x, int y, int z) { values[place] = value_at(x, y, z); });
      transform.forward(values);
      waves = 0;
      double difference = 0;
      transform.for_each_wave([&, &n = n, &used = used](std::ptrdiff_t place, int i, int j, int k) {
        difference = std::max(difference, std::abs(as_complex(values)[place] - exact_mode(n, used, i, j, k)));
        ++waves;
      });
      EXPECT_LT(difference, 1e-12);
    };
    transform_values();
    EXPECT_EQ(waves, transform.wave_count());
    MPI_Allreduce(MPI_IN_PLACE, &waves, 1, MPI_INT, MPI_SUM, world.get());
    EXPECT_EQ(waves, n[0] * n[1] * (n[2] / 2 + 1));

    transform.backward(values);
    double change = 0;
    for_each_point(transform, [&](std::ptrdiff_t place, int x, int y, int z) {
      change = std::max(change, std::abs(values[place] / (n[0] * n[1] * n[2]) - value_at(x, y, z)));
    });
    EXPECT_LT(change, 1e-14);
    transform_values();  // the memory of an earlier transform has no effect
  }
}

// Modes of one mesh are read on another one without messages.
TEST(MeshTransform, OwnsTheWavesOfAnotherMesh) {
  const Communicator world(MPI_COMM_WORLD);
  for (const auto& [coarse, fine] : {std::pair{Points{6, 9, 8}, Points{8, 12, 10}}, {{5, 6, 4}, {7, 9, 6}}}) {
    const MeshTransform one(coarse, coarse, world), other(fine, fine, world, &one);
    std::map<std::array<int, 3>, std::ptrdiff_t> places;
    other.for_each_wave([&](std::ptrdiff_t place, int i, int j, int k) { places[{i, j, k}] = place; });
    one.for_each_wave([&, n = coarse](std::ptrdiff_t, int i, int j, int k) {
      if (2 * std::abs(i) >= n[0] || 2 * std::abs(j) >= n[1]) return;
      ASSERT_TRUE(places.contains(std::array{i, j, k})) << i << " " << j << " " << k;
      EXPECT_EQ(other.place(i, j, k), places.at(std::array{i, j, k}));
    });
  }
}

}  // namespace
}  // namespace beadswim
