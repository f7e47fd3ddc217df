#include <gtest/gtest.h>

#include "../verification/array_drag.hpp"
#include "../verification/records.hpp"

// Tests the drag of dense and dilute arrays of spheres, and of every bead boundary at its own accuracy. The
// cases of tests/verification test one array for all schemes, and the torque on a rotating sphere.

namespace beadswim::verification {
namespace {

const Vec3 oblique(0.25, 0.1, 0.4);  // position within a cell [cell]

struct Measured {
  double volume_fraction;
  double drag;         ///< reference: Zick & Homsy, J. Fluid Mech. 115 (1982) 13, table 2
  double diameter;     ///< diameter of a sphere [cell]
  double model_error;  ///< accepted error: of the radius, amplified in dense arrays
  BeadScheme scheme = BeadScheme::staircase;
};

class SimpleCubicArray : public testing::TestWithParam<Measured> {};

// Catches a wrong momentum exchange, refill or wall velocity: any of them changes the drag by tens of
// percent.
TEST_P(SimpleCubicArray, HasTheDragOfZickAndHomsy) {
  const Measured& m = GetParam();
  const CubicArray array = cubic_array(m.volume_fraction, m.diameter);
  std::vector<double> drags;
  for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5), oblique, Vec3(0.4, 0.2, 0)})
    drags.push_back(array_drag(array, offset, 1.5, m.scheme));
  const auto [drag, spread] = mean_and_deviation(drags);
  RecordProperty("relative_error", std::to_string(drag / m.drag - 1));
  EXPECT_NEAR(drag / m.drag, 1, m.model_error);
  EXPECT_LT(spread / m.drag, m.model_error);
}

INSTANTIATE_TEST_SUITE_P(
    FractionsAndResolutions, SimpleCubicArray,
    testing::Values(
        Measured{0.027, 2.008, 8, 0.06}, Measured{0.064, 2.810, 8, 0.06}, Measured{0.125, 4.292, 8, 0.08},
        Measured{0.125, 4.292, 16, 0.04}, Measured{0.216, 7.442, 12, 0.08},
        Measured{0.027, 2.008, 8, 0.02, BeadScheme::cli}, Measured{0.125, 4.292, 8, 0.02, BeadScheme::cli},
        Measured{0.125, 4.292, 16, 0.01, BeadScheme::cli},
        Measured{0.125, 4.292, 4, 0.045, BeadScheme::mr},  // two cells between spheres
        Measured{0.125, 4.292, 8, 0.015, BeadScheme::mr}, Measured{0.125, 4.292, 16, 0.01, BeadScheme::mr},
        Measured{0.027, 2.008, 8, 0.01, BeadScheme::psm}, Measured{0.125, 4.292, 8, 0.02, BeadScheme::psm},
        Measured{0.125, 4.292, 16, 0.01, BeadScheme::psm}));

// What the law of the force in a cell is made for. Catches one that weakens or stiffens with the viscosity
// (Noble & Torczynski's weights: 13 % between these relaxation times).
TEST(SaturatedCells, HaveTheSameDragAtEveryViscosity) {
  const CubicArray array = cubic_array(0.064, 6);
  const double slow = array_drag(array, oblique, 0.8, BeadScheme::psm);
  const double fast = array_drag(array, oblique, 3, BeadScheme::psm);
  EXPECT_NEAR(fast / slow, 1, 1e-4);  // how far the runs are from steady
}

}  // namespace
}  // namespace beadswim::verification
