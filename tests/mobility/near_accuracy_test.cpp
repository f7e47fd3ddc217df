#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "beadswim/collinear/pair_mobility.hpp"
#include "near_scenes.hpp"

// Accuracy of the model rpy+near relative to force moments of order 2, and its positive definiteness. The
// first test prints the table of docs/method/near-field.md.

namespace beadswim {
namespace {

/// Spheres whose mobility M is known from force moments of order 2, and velocities of interest.
struct KnownScene {
  std::string name;
  Numbers radii;
  Vectors places;
  std::optional<HalfSpace> half_space{};
  std::vector<int> moved{}, forced{};  ///< components of all velocities, and of the forces, which are 1
};

Vectors row(int count, double distance, double height) {
  Vectors places;
  for (int b = 0; b < count; ++b) places.emplace_back(b * distance, 0, height);
  return places;
}

const Vectors cubic{{0, 0, 0}}, body_centred{{0, 0, 0}, {0.5, 0.5, 0.5}},
    face_centred{{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};

/// Returns the points of a crystal with `cells` unit cells per axis, of which the nearest are `distance`
/// apart.
Vectors crystal(const Vectors& unit_cell, int cells, double distance, double lowest) {
  double nearest = 1;
  for (const Vec3& corner : unit_cell)
    if (corner.norm() > 0) nearest = std::min(nearest, corner.norm());
  Vectors places;
  for (int n = 0; n < cells * cells * cells; ++n)
    for (const Vec3& corner : unit_cell)
      places.push_back(distance / nearest * (corner + Vec3(n % cells, n / cells % cells, n / cells / cells)) +
                       Vec3(0, 0, lowest));
  return places;
}

/// Returns a sphere and its twelve neighbours in a face-centred crystal.
Vectors thirteen(double distance) {
  Vectors places{Vec3::Zero()};
  for (const double a : {-1, 1})
    for (const double b : {-1, 1})
      for (const Vec3& place : {Vec3(a, b, 0), Vec3(a, 0, b), Vec3(0, a, b)})
        places.push_back(distance / std::numbers::sqrt2 * place);
  return places;
}

std::vector<KnownScene> known_scenes() {
  const HalfSpace wall;
  const std::vector<int> tow{0, 3, 6, 9, 12};
  return {
      {"row of five, distance 2.5, towed: outer, second, inner",
       Numbers(5, 1.0),
       row(5, 2.5, 0),
       {},
       {0, 3, 6},
       tow},
      {"radii 1, 2, 1/2 at (0, 0), (3.75, 0), (0, 2.25): force y on the last, velocity y of the first",
       {1, 2, 0.5},
       {{0, 0, 0}, {3.75, 0, 0}, {0, 2.25, 0}},
       {},
       {1},
       {7}},
      {"pair, distance 3: cross mobility along the line", {1, 1}, row(2, 3, 0), {}, {0}, {3}},
      {"the same along a wall at height 1.5", {1, 1}, row(2, 3, 1.5), wall, {0}, {3}},
      {"at height 2", {1, 1}, row(2, 3, 2), wall, {0}, {3}},
      {"at height 3", {1, 1}, row(2, 3, 3), wall, {0}, {3}},
      {"pair at heights 1.5 and 4, across the wall", {1, 1}, {{0, 0, 1.5}, {0, 0, 4}}, wall, {2}, {5}},
      {"row of three, distance 2.5, height 1.5, towed: outer, inner",
       Numbers(3, 1.0),
       row(3, 2.5, 1.5),
       wall,
       {0, 3},
       {0, 3, 6}},
      {"triangle, distance 2.5, height 2",
       Numbers(3, 1.0),
       {{0, 0, 2}, {2.5, 0, 2}, {1.25, 1.25 * std::numbers::sqrt3, 2}},
       wall},
      {"zigzag of four", Numbers(4, 1.0), {{0, 0, 0}, {2.4, 0.9, 0}, {4.8, 0, 0.5}, {7.2, 0.9, 0}}},
      {"cross of five",
       {1.5, 1, 1, 0.8, 0.8},
       {{0, 0, 0}, {3.2, 0, 0}, {-3.1, 0, 0}, {0, 2.9, 0}, {0, 0, -3}}},
      {"four over a wall", Numbers(4, 1.0), {{0, 0, 1.7}, {2.6, 0, 2.1}, {0, 2.7, 3}, {2.5, 2.5, 4.6}}, wall},
      {"sphere and its 12 neighbours, distance 2.2", Numbers(13, 1.0), thirteen(2.2)},
      {"at distance 2.5", Numbers(13, 1.0), thirteen(2.5)},
      {"cube of 27, distance 2.2", Numbers(27, 1.0), crystal(cubic, 3, 2.2, 0)},
      {"at distance 2.5", Numbers(27, 1.0), crystal(cubic, 3, 2.5, 0)}};
}

/// Mobilities by rpy, rpy+near and force moments of order 2.
struct Mobilities {
  Eigen::MatrixXd plain, near, expected;

  explicit Mobilities(const KnownScene& known) {
    MobilityScene scene{MobilityModel::rpy, eta, {}, known.radii, 1e-8};
    scene.moment_order = 2;
    scene.domain.half_space = known.half_space;
    plain = matrix_of(scene, known.places);
    scene.model = MobilityModel::rpy_near;
    near = matrix_of(scene, known.places);
    scene.model = MobilityModel::multipole;
    expected = matrix_of(scene, known.places);
  }
  /// Returns the largest amount by which the error of an entry exceeds that of rpy [sqrt(M_ii M_jj)].
  double excess() const {
    const Eigen::VectorXd self = expected.diagonal().cwiseSqrt();
    return ((near - expected).cwiseAbs() - (plain - expected).cwiseAbs())
        .cwiseQuotient(self * self.transpose())
        .maxCoeff();
  }
  double error(const Eigen::MatrixXd& found) const { return (found - expected).norm() / expected.norm(); }
  std::string errors_of_velocities(const Eigen::MatrixXd& found, const KnownScene& known) const {
    std::string text;
    for (const int row : known.moved) {
      double velocity = 0, exact = 0;
      for (const int column : known.forced) {
        velocity += found(row, column);
        exact += expected(row, column);
      }
      char number[16];
      std::snprintf(number, sizeof number, "%s%+.1f", text.empty() ? "" : ", ", 100 * (velocity / exact - 1));
      text += number;
    }
    return text;
  }
};

// The error of the matrix is below a fifth of that of rpy. Errors of rpy cancel by chance in some entries,
// which may then be worse, but by at most 2 % of the self-mobilities.
TEST(NearAccuracy, IsCloserToForceMomentsThanRotneAndPrager) {
  for (const KnownScene& known : known_scenes()) {
    const Mobilities m(known);
    EXPECT_LT(m.error(m.near), 0.2 * m.error(m.plain)) << known.name;
    EXPECT_LT(m.excess(), 0.02) << known.name;
    std::printf("| %s | %.1f | %.1f | %.1f | %s | %s |\n", known.name.c_str(), 100 * m.error(m.plain),
                100 * m.error(m.near), 100 * std::max(m.excess(), 0.0),
                m.errors_of_velocities(m.plain, known).c_str(),
                m.errors_of_velocities(m.near, known).c_str());
  }
}

/// Returns a group of spheres. The gap of each sphere to one before it is between 0.3 and 2 mean radii.
KnownScene random_group(std::mt19937& random, int count, double min_radius, bool is_over_wall) {
  std::uniform_real_distribution<double> unit(0, 1);
  KnownScene group{.name = "random group", .radii = {}, .places = {}};
  if (is_over_wall) group.half_space = HalfSpace{};
  while (std::ssize(group.places) < count) {
    const double radius = min_radius * std::pow(1 / min_radius, 2 * unit(random));
    Vec3 place(0, 0, radius * (1.2 + 3 * unit(random)));
    if (!group.places.empty()) {
      const auto near = static_cast<std::size_t>(unit(random) * static_cast<double>(group.places.size()));
      const Vec3 direction = Vec3(unit(random), unit(random), unit(random)) - Vec3::Constant(0.5);
      place = group.places[near] +
              (radius + group.radii[near]) * (1.15 + 0.85 * unit(random)) * direction.normalized();
    }
    bool is_free = !is_over_wall || place.z() > 1.2 * radius;
    for (std::size_t b = 0; b < group.places.size(); ++b)
      is_free = is_free && (group.places[b] - place).norm() > 1.15 * (radius + group.radii[b]);
    if (!is_free) continue;
    group.radii.push_back(radius);
    group.places.push_back(place);
  }
  return group;
}

TEST(NearAccuracy, IsCloserInRandomGroups) {
  constexpr unsigned seed = 20261201;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int n = 0; n < 40; ++n) {
    const Mobilities m(random_group(random, 2 + n % 4, n % 3 == 0 ? 1 : 0.5, n % 2 == 0));
    EXPECT_LT(m.error(m.near), 0.5 * m.error(m.plain)) << n;
    EXPECT_LT(m.excess(), 0.03) << n;
  }
}

void expect_positive_definite(const std::string& name, const Vectors& places,
                              const std::optional<HalfSpace>& half_space,
                              const std::optional<Box>& box = {}) {
  MobilityScene scene{MobilityModel::rpy_near, eta, {.box = box}, Numbers(places.size(), 1.0), 1e-6};
  scene.domain.half_space = half_space;
  const Eigen::MatrixXd matrix = matrix_of(scene, places);
  EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-9 * matrix.norm()) << name;
  EXPECT_GT(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 1e-6 * self_mobility(1, eta))
      << name;
}

// Sums over close pairs alone would have negative eigenvalues here.
TEST(NearAccuracy, IsPositiveDefiniteInCrystals) {
  for (const double distance : {2.01, 2.5}) {
    for (const double lowest : {0.0, 1.05}) {
      const std::optional<HalfSpace> wall = lowest > 0 ? std::optional(HalfSpace{}) : std::nullopt;
      expect_positive_definite("fcc", crystal(face_centred, 2, distance, lowest), wall);
      expect_positive_definite("bcc", crystal(body_centred, 3, distance, lowest), wall);
      expect_positive_definite("sc", crystal(cubic, 3, distance, lowest), wall);
    }
    const double edge = 2 * std::numbers::sqrt2 * distance;
    expect_positive_definite("fcc in a box", crystal(face_centred, 2, distance, 0), {},
                             Box{{edge, edge, edge}, {}});
  }
}

TEST(NearAccuracy, IsPositiveDefiniteIfManyBeadsOverlap) {
  constexpr unsigned seed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int n = 0; n < 5; ++n) {
    Vectors places;
    for (int b = 0; b < 10; ++b) places.push_back(1.5 * Vec3(unit(random), unit(random), unit(random)));
    expect_positive_definite("open space", places, {});
    for (Vec3& place : places) place.z() += 1.02;
    expect_positive_definite("over a wall", places, HalfSpace{});
  }
}

}  // namespace
}  // namespace beadswim
