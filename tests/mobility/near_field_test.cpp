#include "beadswim/mobility/near_field.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "near_scenes.hpp"

namespace beadswim {
namespace {

// Three on a line anywhere: velocities by any forces along the line are the exact ones, whether their arms
// are short enough for stresslets or not. Catches a wrong axis, order of the beads, or transposed map.
TEST(NearField, MovesALoneStraightSwimmerExactly) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  constexpr double truncation = 1e-7;
  for (const Numbers& radii : {Numbers{4, 4, 4}, Numbers{3, 4, 5}, Numbers{6, 2, 3}}) {
    const double film = min_tabulated_gap(radii[0], radii[1], 0.02),
                 next = min_tabulated_gap(radii[1], radii[2], 0.02);
    for (const auto& [first, second] :
         {std::pair{1.01, 3.0}, {2.0, 20.0}, {20.0, 25.0}, {40.0, 60.0}, {60.0, 90.0}, {90.0, 900.0}}) {
      const double one = radii[0] + radii[1] + first * film, two = one + radii[1] + radii[2] + second * next;
      const Numbers line{0, one, two};
      const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
      const Eigen::Vector3d force(normal(random), normal(random), normal(random));
      Vectors places, forces;
      for (int b = 0; b < 3; ++b) {
        places.push_back(Vec3(7, -3, 2) + line[b] * axis);
        forces.push_back(force[b] * axis);
      }
      const Vectors found = velocities(near_scene(radii), places, forces);
      const Eigen::Vector3d exact = multipole_mobility(radii, line, eta).value * force;
      for (int b = 0; b < 3; ++b)
        EXPECT_LT((found[b] - exact[b] * axis).norm(), truncation * exact.norm())
            << "bead " << b + 1 << ", radius " << radii[0] << ", gaps " << first << ", " << second;
    }
  }
}

/// Two swimmers that are much longer than wide. The second bead of one is close to the third bead of the
/// other.
struct NearPair {
  Numbers radii{2, 2, 2, 1, 1, 3};
  Vec3 axis = Vec3(1, -2, 2) / 3;
  Vectors places;

  explicit NearPair(double distance) {
    const Vec3 at(5, 6, 7), along(0, 500, 500), across(700, 0, 0);
    places = {at + along, at, at - along, at + across, at + across - 0.8 * along, at - distance * axis};
  }
};

// Beads of different swimmers, unequal ones: along their line by the exact mobility of two spheres, also if
// one tows the other; across it nearly as by force moments of order 2.
TEST(NearField, MovesTwoBeadsExactlyAlongTheirLine) {
  constexpr double others = 3e-6;  // of both, by the swimmers' long arms
  for (const double gap : {0.08, 0.3, 1.0, 4.9}) {
    const NearPair pair(5 + gap);
    Vectors forces(6, Vec3::Zero());
    for (const double other : {-1.0, 0.0, 0.7}) {
      forces[1] = pair.axis;
      forces[5] = other * pair.axis;
      const Vectors found = velocities(near_scene(pair.radii), pair.places, forces);
      const Eigen::Vector2d exact =
          multipole_mobility(Numbers{2, 3}, Numbers{0, 5 + gap}, eta).value * Eigen::Vector2d(1, other);
      EXPECT_LT((found[1] - exact[0] * pair.axis).norm(), others * exact.norm()) << "gap " << gap << other;
      EXPECT_LT((found[5] - exact[1] * pair.axis).norm(), others * exact.norm()) << "gap " << gap << other;
    }
    const Vec3 across = pair.axis.unitOrthogonal();
    forces[1] = across;
    forces[5] = -across;
    const auto by = [&](MobilityModel model) {
      MobilityScene scene = near_scene(pair.radii);
      scene.model = model;
      scene.moment_order = 2;
      return velocities(scene, pair.places, forces);
    };
    const Vectors expected = by(MobilityModel::multipole);
    EXPECT_LT(largest_difference(by(MobilityModel::rpy_near), expected),
              0.7 * largest_difference(by(MobilityModel::rpy), expected) + 1e-3 * expected[1].norm())
        << "gap " << gap;
  }
}

// Thinner films are held: beads that touch and overlap still yield to each other.
TEST(NearField, HoldsFilmsAtTheThinnest) {
  const auto parting = [](double distance) {
    const NearPair pair(distance);
    Vectors forces(6, Vec3::Zero());
    forces[1] = pair.axis;
    forces[5] = -pair.axis;
    const Vectors found = velocities(near_scene(pair.radii), pair.places, forces);
    return (found[1] - found[5]).dot(pair.axis);
  };
  EXPECT_GT(parting(5.0), 0.01 * parting(6.0));
  EXPECT_GT(parting(4.5), 0.01 * parting(6.0));
  EXPECT_LT(parting(5.0), 0.2 * parting(6.0));
}

TEST(NearField, IsRotneAndPragersFarApart) {
  const NearPair pair(45.1);  // over 18 mean radii
  Vectors forces(6, Vec3::Zero());
  forces[1] = Vec3(1, 2, 3);
  forces[5] = Vec3(-2, 1, 0);
  MobilityScene plain = near_scene(pair.radii);
  plain.model = MobilityModel::rpy;
  const Vectors expected = velocities(plain, pair.places, forces);
  constexpr double model = 1e-6;  // 15/4 (a/r)^4 at 64 mean radii, where arms are held
  EXPECT_LT(largest_difference(velocities(near_scene(pair.radii), pair.places, forces), expected),
            model * expected[1].norm());
}

TEST(NearField, FadesOutWithoutAStep) {
  EXPECT_EQ(pair_weight(full_weight_distance), 1);
  EXPECT_EQ(pair_weight(pair_cutoff), 0);
  EXPECT_NEAR(pair_weight(5), 0.5, 1e-15);
  EXPECT_NEAR(pair_weight(full_weight_distance + 1e-4), 1, 1e-11);  // third power
  EXPECT_NEAR(pair_weight(pair_cutoff - 1e-4), 0, 1e-11);
}

// Crowds of overlapping beads, in which a bead has a dozen near it.
TEST(NearField, IsSymmetricAndPositiveDefinite) {
  constexpr double of_sums = 1e-9;  // in boxes; 1e-16 in open space
  const Vec3 lengths(6, 7, 8);
  for (const unsigned seed : {1, 2}) {
    const Crowd crowd(seed, 4, lengths);
    for (const auto& box :
         {std::optional<Box>{}, std::optional(Box{{6.6, 7, 8}, {}}),
          std::optional(Box{{6.6, 7, 8}, {Boundary::free_slip, Boundary::periodic, Boundary::free_slip}})}) {
      MobilityScene scene = near_scene(crowd.radii, box);
      scene.tolerance = 1e-5;
      const Eigen::MatrixXd matrix = matrix_of(scene, crowd.places);
      EXPECT_LT((matrix - matrix.transpose()).norm(), of_sums * matrix.norm()) << "seed " << seed;
      EXPECT_GT(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 1e-5 * matrix(0, 0))
          << "seed " << seed << ", box " << box.has_value();
    }
  }
}

// So that far flows begin as they should, and beads go with a flow that is everywhere alike.
TEST(NearField, KeepsTheNetForceAndUniformFlow) {
  const Crowd crowd(4, 6, {7, 8, 9});
  for (const auto& box : {std::optional<Box>{}, std::optional(Box{{7, 8, 9}, {}})}) {
    const NearMap map =
        NearField(crowd.radii, lines_of_three(crowd.radii), eta, {.box = box}).at(crowd.places);
    Vectors forces = crowd.forces;
    forces[0] += Vec3(1, 2, 3);  // the sum
    constexpr int count = moment_count(1);
    std::vector<double> moments = map.moments_of(forces), flow(moments.size(), 0.0);
    ASSERT_EQ(moments.size(), count * forces.size());
    Vec3 sum = Vec3::Zero();
    for (std::size_t b = 0; b < forces.size(); ++b) {
      forces[b] = Vec3::Map(&moments[count * b]);
      sum += forces[b];
      Vec3::Map(&flow[count * b]) = Vec3(3, -1, 2);
    }
    EXPECT_GT(largest_difference(forces, crowd.forces), 0.1);
    constexpr double roundoff = 1e-11;
    EXPECT_LT((sum - Vec3(1, 2, 3)).norm(), roundoff);
    std::ranges::fill(moments, 0.0);
    Vectors found(forces.size());
    map.set_velocities(moments, flow, found);
    for (const Vec3& v : found) EXPECT_LT((v - Vec3(3, -1, 2)).norm(), roundoff);
  }
}

TEST(NearField, TurnsAndMovesWithTheSwimmers) {
  const Crowd crowd(5, 6, {9, 9, 9});
  const Vectors before = velocities(near_scene(crowd.radii), crowd.places, crowd.forces);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  Vectors places, forces, turned;
  for (std::size_t b = 0; b < before.size(); ++b) {
    places.push_back(turn * crowd.places[b] + Vec3(30, -20, 11));
    forces.push_back(turn * crowd.forces[b]);
    turned.push_back(turn * before[b]);
  }
  constexpr double roundoff = 1e-11;
  EXPECT_LT(largest_difference(velocities(near_scene(crowd.radii), places, forces), turned), roundoff);
}

TEST(NearField, DoesNotHangOnTheOrderOfSwimmersOrBeads) {
  Crowd crowd(6, 6, {9, 9, 9});
  Vectors before = velocities(near_scene(crowd.radii), crowd.places, crowd.forces);
  const auto reorder = [](auto& list) {
    std::ranges::rotate(list, list.begin() + 6);
    for (auto at = list.begin(); at != list.end(); at += 3) std::swap(at[0], at[2]);
  };
  reorder(before);
  reorder(crowd.places);
  reorder(crowd.forces);
  reorder(crowd.radii);
  constexpr double truncation = 1e-7;  // of the tables of arms in reverse
  EXPECT_LT(largest_difference(velocities(near_scene(crowd.radii), crowd.places, crowd.forces), before),
            truncation);
}

// Tables fill as they are asked for: what was asked before does not matter, to the bit.
TEST(NearField, KeepsNoMemoryOfEarlierPlaces) {
  const Crowd crowd(9, 6, {9, 9, 9});
  const Vectors fresh = velocities(near_scene(crowd.radii), crowd.places, crowd.forces);
  const Communicator world(MPI_COMM_WORLD);
  Mobility used(near_scene(crowd.radii), crowd.places, world);
  Vectors elsewhere = crowd.places, found(fresh.size());
  for (std::size_t b = 0; b < elsewhere.size(); ++b) elsewhere[b] *= 1.3;
  used.set_positions(elsewhere);
  used.apply(crowd.forces, found);
  used.set_positions(crowd.places);
  used.apply(crowd.forces, found);
  EXPECT_EQ(found, fresh);
}

TEST(NearField, BearsPlacesThatAreNoNumbers) {
  Crowd crowd(10, 4, {9, 9, 9});
  crowd.places[4] = Vec3::Constant(std::nan(""));
  EXPECT_FALSE(velocities(near_scene(crowd.radii), crowd.places, crowd.forces)[4].allFinite());
}

/// Returns spheres of radius 1 whose near field has these lines.
MobilityScene unit_spheres(int count, const std::vector<int>& lines) {
  return {MobilityModel::rpy_near, eta, {}, Numbers(count, 1.0), 1e-8, lines};
}

// Of three beads at the corners of a triangle each pair is close: the map has the symmetry of the triangle.
TEST(NearField, TreatsATriangleAsPairs) {
  const double height = 1.5 * std::numbers::sqrt3;
  const Vectors corners{Vec3(-1.5, 0, 0), Vec3(1.5, 0, 0), Vec3(0, height, 0)};
  const Vec3 centre(0, height / 3, 0);
  Vectors outwards;
  for (const Vec3& corner : corners) outwards.push_back((corner - centre).normalized());
  const Vectors found = velocities(unit_spheres(3, {}), corners, outwards);
  for (int b = 0; b < 3; ++b) {
    EXPECT_NEAR(found[b].dot(outwards[b]), found[0].dot(outwards[0]), 1e-12);
    EXPECT_LT(found[b].cross(outwards[b]).norm(), 1e-12);
  }
  MobilityScene plain = unit_spheres(3, {});
  plain.model = MobilityModel::rpy;
  EXPECT_LT(found[0].norm(), 0.95 * velocities(plain, corners, outwards)[0].norm());
}

// A dumbbell before a three-bead swimmer shifts the numbers of its beads, and nothing else.
TEST(NearField, FindsTheBeadsOfLinesInMixtures) {
  const Vectors line{Vec3(0, 0, 0), Vec3(2.7, 0, 0), Vec3(6, 0, 0)},
      forces{Vec3(1, 0, 0), Vec3(-3, 1, 0), Vec3(2, -1, 0)};
  Vectors both{Vec3(0, 1e6, 0), Vec3(0, 1e6 + 5, 0)}, all_forces(2, Vec3::Zero());
  both.insert(both.end(), line.begin(), line.end());
  all_forces.insert(all_forces.end(), forces.begin(), forces.end());
  const Vectors alone = velocities(unit_spheres(3, {0}), line, forces);
  const Vectors mixed = velocities(unit_spheres(5, {2}), both, all_forces);
  for (int b = 0; b < 3; ++b) EXPECT_LT((mixed[2 + b] - alone[b]).norm(), 1e-12);
}

}  // namespace
}  // namespace beadswim
