#include "direct_ewald.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/pair_mobility.hpp"

// Tests of the reference sums in direct_ewald.hpp, by comparison with results that do not come from these
// sums.

namespace beadswim::direct {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]
constexpr double pi = std::numbers::pi;
constexpr std::array both_laws{Law::oseen, Law::rotne_prager};

/// Returns spheres at random positions in a box, with radii from 1 to 5. Spheres may overlap or contain each
/// other.
Spheres random_spheres(unsigned seed, std::size_t count, const Eigen::Vector3d& lengths) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1), log_radius(0, std::log(5.0)), force(-1, 1);
  Spheres spheres;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d at(share(random), share(random), share(random));
    spheres.places.push_back(lengths.cwiseProduct(at));
    spheres.radii.push_back(std::exp(log_radius(random)));
    spheres.forces.emplace_back(force(random), force(random), force(random));
  }
  return spheres;
}

double largest_difference(const Vectors& a, const Vectors& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i] - b[i]).lpNorm<Eigen::Infinity>());
  }
  return largest;
}

/// Returns sin(x)/x: the mean of exp(ikz) over the surface of a sphere of radius a, x = ka.
double surface_mean(double x) {
  return x == 0 ? 1 : std::sin(x) / x;
}

/// Returns the mean of (I - kk) exp(ik.r) over all directions of k: j_0 - j_1/x for I and j_2 for rr, x = kr.
Tensor direction_mean(double x) {
  if (x < 1e-2) return {2. / 3 - 2 * x * x / 15, x * x / 15};
  const double j0 = std::sin(x) / x, j1_over_x = (j0 - std::cos(x)) / (x * x);
  return {j0 - j1_over_x, 3 * j1_over_x - j0};
}

/// Returns (1/(2 pi)^3) int surface_mean(k a_i) surface_mean(k a_j) (I - kk)/(eta k^2) exp(ik.r) d^3k, up to
/// the wavenumber `cutoff` and divided by 1/(8 pi eta). The integrand is even and limited to the band a_i +
/// a_j + r, so that the trapezoidal rule is exact.
Tensor oseen_averaged_over_surfaces(double a_i, double a_j, double r, double cutoff) {
  const double step = 3 / (a_i + a_j + r);
  Tensor sum{0, 0};
  for (double k = 0; k < cutoff; k += step) {
    const double weight = 4 / pi * step * (k == 0 ? 0.5 : 1) * surface_mean(k * a_i) * surface_mean(k * a_j);
    const Tensor mean = direction_mean(k * r);
    sum = sum + Tensor{weight * mean.identity, weight * mean.dyad};
  }
  return sum;
}

// The definition of the law in every branch: apart, cutting, one within the other.
TEST(DirectRotnePrager, IsOseenAveragedOverBothSurfaces) {
  constexpr double truncation = 1e-9;  // of a sphere's own: cut off at k a_j, k r >= 2000
  const double a_i = 4, own = lone_sphere(a_i).identity;
  for (const double a_j : {4.0, 3.0, 1.5, 0.4}) {
    for (const double r : {9.0, 7.5, 6.1, 5.0, 4.2, 3.0, 2.4, 1.0, 0.1}) {
      SCOPED_TRACE(testing::Message() << "a_j = " << a_j << ", r = " << r);
      const Tensor average = oseen_averaged_over_surfaces(a_i, a_j, r, 2000 / std::min(a_j, r));
      const Tensor there = rotne_prager_tensor(a_i, a_j, r), back = rotne_prager_tensor(a_j, a_i, r);
      EXPECT_NEAR(there.identity, average.identity, truncation * own);
      EXPECT_NEAR(there.dyad, average.dyad, truncation * own);
      EXPECT_EQ(there.identity, back.identity);
      EXPECT_EQ(there.dyad, back.dyad);
    }
  }
}

// The splitting is an arbitrary number: a missing or doubled piece of either sum depends on it.
TEST(DirectEwald, DoesNotDependOnSplitting) {
  constexpr double roundoff = 1e-14;  // velocities are of order 0.1
  constexpr unsigned seed = 31;
  const Eigen::Vector3d lengths(31, 24, 19);
  Spheres spheres = random_spheres(seed, 12, lengths);
  spheres.places[1] = spheres.places[0] + Eigen::Vector3d(0.3, 0, 0.1);  // one within the other
  spheres.places[2] = spheres.places[0] + lengths;  // at the other's image: Rotne-Prager alone has a value
  for (const Law law : both_laws) {
    if (law == Law::oseen) spheres.places[2][0] += 4;
    const Vectors balanced = periodic_velocities(law, spheres, eta, lengths);
    for (const double ratio : {0.6, 1.6, 2.5}) {
      const double xi = ratio * balanced_splitting(lengths);
      const Vectors other = periodic_velocities(law, spheres, eta, lengths, xi);
      EXPECT_LT(largest_difference(other, balanced), roundoff) << "ratio " << ratio << ", seed " << seed;
    }
  }
}

// Cubic array: mobility over the lone sphere's 1 - 2.837297 a/L + (4 pi/3)(a/L)^3 (Hasimoto, J. Fluid Mech.
// 5, 317 (1959)); points have no cubic term. A wrong own term or background shows here.
TEST(DirectEwald, SlowsACubicArrayOfSpheresAsHasimotoFound) {
  constexpr double printed_digits = 1e-12;
  const double length = 50;
  for (const double a : {1.0, 4.0, 20.0}) {
    const double ratio = a / length, points = 1 - 2.8372974794806 * ratio;
    const Spheres sphere{{{3, 7, -80}}, {a}, {{0, 1, 0}}};
    const auto mobility = [&](Law law) -> Eigen::Vector3d {
      return periodic_velocities(law, sphere, eta, Eigen::Vector3d::Constant(length))[0] * (6 * pi * eta * a);
    };
    EXPECT_NEAR(mobility(Law::oseen)[1], points, printed_digits);
    EXPECT_NEAR(mobility(Law::rotne_prager)[1], points + 4 * pi / 3 * std::pow(ratio, 3), printed_digits);
    EXPECT_NEAR(mobility(Law::rotne_prager)[0], 0, printed_digits);
  }
}

/// Returns the Rotne-Prager mobility matrix for beads on a line along x, for velocities and forces along the
/// line, by LineFlow.
Eigen::MatrixXd line_mobility(const LineFlow& flow, const std::vector<double>& x,
                              const std::vector<double>& radii) {
  const std::size_t count = x.size();
  Eigen::MatrixXd mobility(count, count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const SteadyFlow by_j = i == j ? flow.steady_images(x[i]) : flow.steady(x[i], x[j]);
      mobility(i, j) = by_j.oseen.value + (radii[i] * radii[i] + radii[j] * radii[j]) * by_j.laplacian.value +
                       (i == j ? self_mobility(radii[i], eta) : 0);
    }
  }
  return mobility;
}

/// Returns the same matrix by the direct sum, with the line along `axis` and the other two axes in cyclic
/// order.
Eigen::MatrixXd turned_mobility(int axis, const Box& box, const Eigen::Vector2d& yz,
                                const std::vector<double>& x, const std::vector<double>& radii) {
  const auto turned = [&](auto from) {
    return std::array{from[(3 - axis) % 3], from[(4 - axis) % 3], from[(5 - axis) % 3]};
  };
  Spheres spheres;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::array place = turned(std::array{x[i], yz[0], yz[1]});
    spheres.places.emplace_back(place.data());
    spheres.radii.push_back(radii[i]);
  }
  const Box turned_box{.lengths = Vec3(turned(box.lengths).data()), .boundary = turned(box.boundary)};
  const Eigen::MatrixXd all = mobility_matrix(
      spheres, [&](const Spheres& s) { return box_velocities(Law::rotne_prager, s, eta, turned_box); });
  return all(Eigen::seqN(axis, x.size(), 3), Eigen::seqN(axis, x.size(), 3));
}

// Sums along a line, derived otherwise and tested apart; the line along each axis in turn. Catches a mirror
// of wrong sign or place, and axes mixed up.
TEST(DirectEwald, AgreesWithFlowAlongALine) {
  constexpr double truncation = 1e-13;  // of a sphere's own; both sums are cut off
  const std::vector<double> x{27, 47, 71}, radii{4, 3, 5};
  for (const Box& box :
       {Box{.lengths = {100, 40, 40}, .boundary = {}}, Box{.lengths = {100, 60, 35}, .boundary = {}},
        Box{.lengths = {100, 60, 35},
        .boundary = {Boundary::free_slip, Boundary::periodic, Boundary::periodic}},
        Box{.lengths = {100, 60, 35},
        .boundary = {Boundary::periodic, Boundary::free_slip, Boundary::periodic}},
        Box{.lengths = {100, 60, 35},
        .boundary = {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}}}) {
    const Eigen::MatrixXd expected = line_mobility(LineFlow(eta, box, 22, 10), x, radii);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::MatrixXd difference = turned_mobility(axis, box, {22, 10}, x, radii) - expected;
      EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), truncation * self_mobility(3, eta)) << "axis " << axis;
    }
  }
}

}  // namespace
}  // namespace beadswim::direct
