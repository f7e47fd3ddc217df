#include "beadswim/mobility/mobility.hpp"

#include <gtest/gtest.h>

#include <random>
#include <span>

#include "beadswim/core/error.hpp"
#include "direct_ewald.hpp"

namespace beadswim {
namespace {

constexpr double eta = 1.0 / 3;  // [mass/(length time)]

/// Returns spheres at random positions in a box, with forces that sum to zero. All radii are `smallest` if
/// `alike` is true; otherwise they lie between `smallest` and twice this value.
direct::Spheres random_spheres(int count, const Vec3& lengths, double smallest, bool alike) {
  std::mt19937 random(static_cast<unsigned>(count));  // seed: the count
  std::uniform_real_distribution<double> uniform(0, 1);
  direct::Spheres spheres;
  Vec3 sum = Vec3::Zero();
  for (int b = 0; b < count; ++b) {
    spheres.places.emplace_back(lengths[0] * uniform(random), lengths[1] * uniform(random),
                                lengths[2] * uniform(random));
    spheres.radii.push_back(smallest * (alike ? 1 : 1 + uniform(random)));
    spheres.forces.emplace_back(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5);
    sum += spheres.forces.back();
  }
  for (Vec3& force : spheres.forces) force -= sum / count;
  return spheres;
}

direct::Vectors product(const MobilityScene& scene, const direct::Spheres& spheres) {
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene, spheres.places, world);
  direct::Vectors velocities(spheres.places.size());
  mobility.apply(spheres.forces, velocities);
  return velocities;
}

double relative_error(const direct::Vectors& a, const direct::Vectors& exact) {
  double difference = 0, size = 0;
  for (std::size_t b = 0; b < a.size(); ++b) {
    difference += (a[b] - exact[b]).squaredNorm();
    size += exact[b].squaredNorm();
  }
  return std::sqrt(difference / size);
}

const Box boxes[] = {{{20, 20, 20}, {}},
                     {{48, 16, 20}, {}},
                     {{15, 24, 30}, {Boundary::free_slip, Boundary::periodic, Boundary::periodic}},
                     {{16, 15, 20}, {Boundary::free_slip, Boundary::free_slip, Boundary::free_slip}}};

// Against the sum over all images and wavevectors of another splitting: the error is what was asked for,
// however small. A wrong share of the windows, size term, self term or mirror is far outside of it.
TEST(Mobility, InABoxIsTheDirectSumToItsTolerance) {
  for (const MobilityModel model : {MobilityModel::rpy, MobilityModel::oseen}) {
    const auto law = model == MobilityModel::oseen ? direct::Law::oseen : direct::Law::rotne_prager;
    for (const Box& box : boxes) {
      for (const bool alike : {true, false}) {
        const direct::Spheres spheres = random_spheres(24, box.lengths, 1, alike);
        const auto exact = direct::box_velocities(law, spheres, eta, box);
        for (const double tolerance : {1e-3, 1e-5, 1e-8}) {
          const MobilityScene scene{model, eta, {.box = box}, spheres.radii, tolerance};
          EXPECT_LT(relative_error(product(scene, spheres), exact), tolerance)
              << box.lengths.transpose() << ", alike " << alike;
        }
      }
    }
  }
}

// Waves along the long edges, of which there are more than an integral over waves has, carry most of the
// flow.
TEST(Mobility, InANarrowBoxIsTheDirectSumToItsTolerance) {
  const Box box{.lengths = {400, 100, 25}, .boundary = {}};
  const direct::Spheres spheres = random_spheres(200, box.lengths, 0.5, true);
  const auto exact = direct::box_velocities(direct::Law::rotne_prager, spheres, eta, box);
  constexpr double tolerance = 1e-3;
  EXPECT_LT(relative_error(
                product({MobilityModel::rpy, eta, {.box = box}, spheres.radii, tolerance}, spheres), exact),
            tolerance);
}

// Against the sum of all pairs: a thousand spheres are on the mesh. Crowded, where many overlap, and far
// apart.
TEST(Mobility, InOpenSpaceIsTheSumOfPairsToItsTolerance) {
  for (const double edge : {25.0, 60.0, 1500.0}) {
    for (const bool alike : {true, false}) {
      const direct::Spheres spheres = random_spheres(1001, {edge, edge, edge / 2}, 1, alike);
      const auto exact = direct::open_velocities(direct::Law::rotne_prager, spheres, eta);
      for (const double tolerance : {1e-3, 1e-4, 1e-6}) {
        const MobilityScene scene{MobilityModel::rpy, eta, {}, spheres.radii, tolerance};
        EXPECT_LT(relative_error(product(scene, spheres), exact), tolerance)
            << "edge " << edge << ", alike " << alike;
      }
    }
  }
}

// Triplets five radii long, a million apart: near pairs are as right as where all are near.
TEST(Mobility, KeepsNearPairsOfSpheresThatAreFarFromOthers) {
  direct::Spheres spheres = random_spheres(1200, {1e6, 1e6, 1e6}, 1, true);
  for (std::size_t b = 0; b < spheres.places.size(); ++b)
    spheres.places[b] = spheres.places[b - b % 3] + Vec3(5.0 * static_cast<double>(b % 3), 0, 0);
  const auto exact = direct::open_velocities(direct::Law::rotne_prager, spheres, eta);
  const double tolerance = 1e-6;
  EXPECT_LT(relative_error(product({MobilityModel::rpy, eta, {}, spheres.radii, tolerance}, spheres), exact),
            tolerance);
}

// Spheres at one place, and all but, move as one: nothing cancels.
TEST(Mobility, SumsSpheresThatCoincide) {
  direct::Spheres spheres = random_spheres(1200, {60, 60, 60}, 1, true);
  spheres.places[1] = spheres.places[0];
  spheres.places[3] = spheres.places[2] + Vec3(1e-6, 0, 0);
  const double tolerance = 1e-4;
  const direct::Vectors velocities =
      product({MobilityModel::rpy, eta, {}, spheres.radii, tolerance}, spheres);
  EXPECT_LT((velocities[0] - velocities[1]).norm(), 1e-3 * velocities[0].norm());
  EXPECT_LT((velocities[2] - velocities[3]).norm(), 1e-3 * velocities[2].norm());
}

// Places that are no numbers crash nothing.
TEST(Mobility, BearsPlacesThatAreNoNumbers) {
  for (const bool is_periodic : {false, true}) {
    direct::Spheres spheres = random_spheres(1200, {40, 40, 40}, 1, true);
    const Communicator world(MPI_COMM_WORLD);
    MobilityScene scene{MobilityModel::rpy, eta, {}, spheres.radii};
    if (is_periodic) scene.domain.box = Box{{40, 40, 40}, {}};
    Mobility mobility(scene, spheres.places, world);
    spheres.places[7] = Vec3::Constant(std::nan(""));
    direct::Vectors velocities(spheres.places.size());
    try {
      mobility.set_positions(spheres.places);
      mobility.apply(spheres.forces, velocities);
      EXPECT_FALSE(velocities[7].allFinite());
    } catch (const SolverError&) {  // as good an answer
    }
  }
}

TEST(Mobility, SumsFewSpheresInOpenSpaceToRoundoff) {
  constexpr double roundoff = 1e-14;
  for (const MobilityModel model : {MobilityModel::rpy, MobilityModel::oseen}) {
    const auto law = model == MobilityModel::oseen ? direct::Law::oseen : direct::Law::rotne_prager;
    const direct::Spheres spheres = random_spheres(30, {10, 10, 10}, 1, false);
    EXPECT_LT(relative_error(product({model, eta, {}, spheres.radii}, spheres),
                             direct::open_velocities(law, spheres, eta)),
              roundoff);
  }
}

// Where positions differ by whole edges of the box, and however the swarm has moved in open space.
TEST(Mobility, DoesNotHangOnImagesOrPlace) {
  direct::Spheres spheres = random_spheres(40, {20, 24, 30}, 1, false);
  const MobilityScene in_box{MobilityModel::rpy, eta, {.box = Box{{20, 24, 30}}}, spheres.radii, 1e-6};
  const auto before = product(in_box, spheres);
  for (std::size_t b = 0; b < spheres.places.size(); ++b)
    spheres.places[b] +=
        Vec3(20.0 * (static_cast<double>(b % 3) - 1), -24.0 * static_cast<double>(b % 2), 60);
  constexpr double roundoff = 1e-12;
  EXPECT_LT(relative_error(product(in_box, spheres), before), roundoff);

  direct::Spheres many = random_spheres(1001, {40, 40, 40}, 1, true);
  const Communicator world(MPI_COMM_WORLD);
  const double tolerance = 1e-4;
  Mobility mobility({MobilityModel::rpy, eta, {}, many.radii, tolerance}, many.places, world);
  for (Vec3& place : many.places) place = 1.3 * place + Vec3(1e4, -300, 7);  // the mesh follows, and grows
  direct::Vectors velocities(many.places.size());
  mobility.set_positions(many.places);
  mobility.apply(many.forces, velocities);
  EXPECT_LT(relative_error(velocities, direct::open_velocities(direct::Law::rotne_prager, many, eta)),
            tolerance);
}

// <f, mu g> = <g, mu f>, and f does work: pairs and mesh together, to roundoff, whatever the tolerance.
TEST(Mobility, IsReciprocalAndDissipates) {
  direct::Spheres spheres = random_spheres(60, {20, 24, 30}, 1, false);
  const MobilityScene scene{MobilityModel::rpy, eta, {.box = Box{{20, 24, 30}}}, spheres.radii, 1e-3};
  const direct::Vectors f = spheres.forces, by_f = product(scene, spheres);
  std::ranges::rotate(spheres.forces, spheres.forces.begin() + 7);
  const direct::Vectors g = spheres.forces, by_g = product(scene, spheres);
  double f_by_g = 0, g_by_f = 0, work = 0;
  for (std::size_t b = 0; b < f.size(); ++b) {
    f_by_g += f[b].dot(by_g[b]);
    g_by_f += g[b].dot(by_f[b]);
    work += f[b].dot(by_f[b]);
  }
  constexpr double roundoff = 1e-12;
  EXPECT_NEAR(f_by_g, g_by_f, roundoff * work);
  EXPECT_GT(work, 0);
}

// The same bits again on as many ranks: FFTW's plans and the order of sums do not hang on time or luck.
TEST(Mobility, RepeatsItsBits) {
  const direct::Spheres spheres = random_spheres(1200, {40, 40, 40}, 1, false);
  const MobilityScene scene{MobilityModel::rpy, eta, {}, spheres.radii, 1e-4};
  const direct::Vectors first = product(scene, spheres);
  EXPECT_EQ(product(scene, spheres), first);
  // Later products at the same positions have kept the pairs of spheres.
  const Communicator world(MPI_COMM_WORLD);
  Mobility mobility(scene, spheres.places, world);
  direct::Vectors again(first.size());
  for (int n = 0; n < 4; ++n) {
    mobility.apply(spheres.forces, again);
    EXPECT_EQ(again, first) << n;
  }
}

TEST(Mobility, RefusesWhatItCannotSum) {
  const direct::Spheres spheres = random_spheres(5, {20, 20, 20}, 1, true);
  MobilityScene scene{MobilityModel::rpy, eta, {.box = Box{{20, 20, 3}}}, spheres.radii};
  EXPECT_THROW(product(scene, spheres), InputError);
  scene.domain.box->lengths[2] = 20;
  scene.tolerance = 0.1;
  EXPECT_THROW(product(scene, spheres), InputError);
  scene.tolerance = 1e-4;
  scene.radii[3] = 0;
  EXPECT_THROW(product(scene, spheres), InputError);
}

// Arrays that are too short or too long would be read or written beyond their ends, or in part.
TEST(Mobility, RefusesArraysThatDoNotFitTheSpheres) {
  const direct::Spheres spheres = random_spheres(5, {20, 20, 20}, 1, true);
  const MobilityScene scene{MobilityModel::rpy, eta, {.box = Box{{20, 20, 20}}}, spheres.radii};
  const Communicator world(MPI_COMM_WORLD);
  const std::span<const Vec3> places(spheres.places), forces(spheres.forces);
  direct::Vectors velocities(6);
  const std::span<Vec3> all(velocities);
  EXPECT_THROW(Mobility(scene, places.first(4), world), InputError);
  Mobility mobility(scene, places, world);
  EXPECT_THROW(mobility.set_positions(places.first(4)), InputError);
  EXPECT_THROW(mobility.apply(forces.first(4), all.first(5)), InputError);
  EXPECT_THROW(mobility.apply(forces, all.first(4)), InputError);
  EXPECT_THROW(mobility.apply(forces, all), InputError);
  EXPECT_NO_THROW(mobility.apply(forces, all.first(5)));
  for (const int first : {-1, 3}) {
    MobilityScene with_line = scene;
    with_line.model = MobilityModel::rpy_near;
    with_line.lines = {first};
    EXPECT_THROW(Mobility(with_line, places, world), InputError) << first;
  }
}

}  // namespace
}  // namespace beadswim
