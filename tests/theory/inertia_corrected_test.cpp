#include "beadswim/theory/inertia_corrected.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "scenes.hpp"

namespace beadswim {
namespace {

constexpr double small = 1e-3;  // amplitude without effects of its own: they are of order 1e-6 here

Prediction corrected(const CollinearSwimmer& swimmer) {
  return predicted("inertia-corrected", ask(with_amplitude(swimmer, small)));
}

/// Reference values: velocity divided by A^2, arm amplitudes divided by A, and sin(delta_1 - delta_2).
struct Row {
  double period, velocity, d1, d2, sine;
};

// An independent calculation (own derivation, own code in another language): first-order flow by least
// squares of unsteady multipoles on the surfaces of the three spheres (l <= 10, for arms of 14 l <= 12;
// residual below 5e-7), mean velocity by the reciprocal theorem with the Reynolds stress outside the spheres
// by quadrature. It is independent of a common oscillation to 1e-7, and its steady part is that of
// multipole-perturbation in all digits. Velocities of a swimmer like the paper's with other arms, over A^2.
const Row arm_20[] = {
    {500, 0.288057e-3, 3.82174, 4.30025, 0.61068},    {700, 0.502645e-3, 5.51141, 6.49649, 0.62147},
    {1000, 0.827566e-3, 7.72730, 9.71812, 0.64281},   {1400, 1.194269e-3, 10.00848, 13.59620, 0.67862},
    {2000, 1.558446e-3, 12.26766, 18.27536, 0.74189}, {3000, 1.817559e-3, 14.51041, 23.49039, 0.84412},
    {4800, 1.819552e-3, 17.50155, 28.10980, 0.94812}, {10000, 1.282991e-3, 22.92957, 30.79748, 0.99622}};
const Row arm_14[] = {{1000, 1.217799e-3, 6.33156, 7.93114, 0.73256},
                      {2000, 2.212838e-3, 10.92139, 15.18593, 0.80838},
                      {4800, 2.788556e-3, 17.19701, 25.62999, 0.94768},
                      {10000, 2.093167e-3, 22.60490, 29.80387, 0.99460}};
const Row arm_30[] = {{1000, 0.273861e-3, 8.64527, 10.65579, 0.59314},
                      {2000, 0.644219e-3, 13.16983, 20.10315, 0.68894},
                      {4800, 0.842269e-3, 17.46097, 29.52799, 0.94628},
                      {10000, 0.609389e-3, 23.04326, 31.39377, 0.99708}};

void expect_within_own_uncertainty(const Row& row, double arm) {
  CollinearSwimmer swimmer = paper_swimmer(row.period);
  swimmer.arm = {arm, arm};
  const Prediction p = corrected(swimmer);
  const auto& [d, delta] = p.stroke;
  SCOPED_TRACE(testing::Message() << "T = " << row.period << ", l = " << arm);
  // Last digits of the numbers above: relative for velocity and arms, absolute for the sine.
  constexpr double velocity_digits = 2e-6, arm_digits = 2e-6, sine_digits = 5.1e-6;
  const double deviation = p.velocity / (small * small * row.velocity) - 1;
  EXPECT_LT(std::abs(deviation), *p.uncertainty + velocity_digits);
  EXPECT_LT(std::abs(d[0] / (small * row.d1) - 1), p.stroke_uncertainty->arm_amplitudes[0] + arm_digits);
  EXPECT_LT(std::abs(d[1] / (small * row.d2) - 1), p.stroke_uncertainty->arm_amplitudes[1] + arm_digits);
  EXPECT_LT(std::abs(p.sin_phase_shift - row.sine), p.stroke_uncertainty->sin_phase_shift + sine_digits);
  EXPECT_LT(*p.uncertainty, 1e-5);  // at small amplitude, in unbounded fluid
}

TEST(InertiaCorrected, AgreesWithUnsteadyMultipolesWithinItsOwnUncertainty) {
  for (const Row& row : arm_20) expect_within_own_uncertainty(row, 20);
  for (const Row& row : arm_14) expect_within_own_uncertainty(row, 14);
  for (const Row& row : arm_30) expect_within_own_uncertainty(row, 30);
}

// Pairs alone are as far off as they say.
TEST(UnsteadyResponse, AgreesWithUnsteadyMultipolesWithinItsOwnUncertainty) {
  const auto expect_within = [](const Row& row, double arm) {
    CollinearSwimmer swimmer = paper_swimmer(row.period);
    swimmer.arm = {arm, arm};
    const Prediction p = predicted("unsteady-response", ask(with_amplitude(swimmer, small)));
    EXPECT_LT(std::abs(p.velocity / (small * small * row.velocity) - 1), *p.uncertainty)
        << "T = " << row.period << ", l = " << arm;
  };
  for (const Row& row : arm_20) expect_within(row, 20);
  for (const Row& row : arm_14) expect_within(row, 14);
  for (const Row& row : arm_30) expect_within(row, 30);
}

// The steady part against the same calculation.
TEST(InertiaCorrected, StartsFromTheExactQuasiStaticVelocity) {
  constexpr double last_digit = 5.1e-10;
  const struct {
    double period, velocity;
  } rows[] = {{1000, 1.039251e-3}, {2000, 1.570750e-3}, {4800, 1.702098e-3}, {10000, 1.224638e-3}};
  for (const auto& row : rows) {
    const double velocity = setting(corrected(paper_swimmer(row.period)), "velocity_quasi_static");
    EXPECT_NEAR(velocity / (small * small), row.velocity, last_digit) << "T = " << row.period;
  }
}

// Without inertia nothing is left to correct, at finite amplitude too; order one in the density.
TEST(InertiaCorrected, TendsToExactStokesFlowAsDensityVanishes) {
  const CollinearSwimmer swimmer = with_amplitude(unequal_swimmer(), 0.2);
  const Prediction exact = predicted("multipole-ode", ask(swimmer));
  const auto at_density = [&](double density) {
    return predicted("inertia-corrected", ask(with_density(swimmer, density), density));
  };
  const auto deviation = [&](double density) { return at_density(density).velocity / exact.velocity - 1; };
  constexpr double slope_tolerance = 0.02;
  EXPECT_NEAR(std::log10(deviation(1e-4) / deviation(1e-5)), 1, slope_tolerance);
  EXPECT_NEAR(std::log10(deviation(1e-5) / deviation(1e-6)), 1, slope_tolerance);
  EXPECT_LT(std::abs(deviation(1e-6)), 2e-7);
  const Prediction finest = at_density(1e-6);
  EXPECT_NEAR(finest.stroke.amplitude[0] / exact.stroke.amplitude[0], 1, 2e-7);
  EXPECT_NEAR(finest.stroke.amplitude[1] / exact.stroke.amplitude[1], 1, 2e-7);
  EXPECT_NEAR(finest.sin_phase_shift, exact.sin_phase_shift, 2e-7);
  EXPECT_LT(*finest.uncertainty, 1e-6);
}

TEST(InertiaCorrected, IsTheSumOfItsParts) {
  constexpr double roundoff = 1e-14;
  const Prediction p = predicted(
      "inertia-corrected", ask_in_box(with_amplitude(paper_swimmer(4800), 0.2), periodic_box(128, 80, 80)));
  double sum = 0;
  for (const char* part : {"velocity_quasi_static", "velocity_by_stroke", "velocity_by_drift",
                           "velocity_by_reynolds_stress", "velocity_by_box", "velocity_by_amplitude"})
    sum += setting(p, part);
  EXPECT_NEAR(p.velocity / sum, 1, roundoff);
}

// With little inertia, where the Reynolds stress is negligible, a box changes velocity and stroke almost as
// pairs alone predict: for long arms, whose pairs are exact, by the same factor; for those of the paper's
// swimmer by a factor that differs from it by less than the error of pairs.
TEST(InertiaCorrected, TakesTheBoxFromUnsteadyPairs) {
  struct Case {
    double arm, edge, tolerance;  // tolerance: relative to the change by the box
  };
  for (const auto& [arm, edge, tolerance] : {Case{20, 60, 0.12}, Case{80, 140, 0.015}}) {
    for (const double period : {4800.0, 10000.0}) {
      SCOPED_TRACE(testing::Message() << "arm " << arm << ", period " << period);
      CollinearSwimmer swimmer = with_amplitude(paper_swimmer(period * arm * arm / 400), small);
      swimmer.arm = {arm, arm};
      const auto boxed = [&](const std::string& method) {
        return predicted(method, ask_in_box(swimmer, periodic_box(2 * edge, edge, edge)));
      };
      const auto open = [&](const std::string& method) { return predicted(method, ask(swimmer)); };
      const auto expect_alike = [&](const auto& change) {
        const double pairs = change("unsteady-response");
        EXPECT_NEAR(change("inertia-corrected"), pairs, tolerance * std::abs(pairs));
        EXPECT_GT(std::abs(pairs), 3e-4);
      };
      expect_alike(
          [&](const std::string& method) { return boxed(method).velocity / open(method).velocity - 1; });
      expect_alike([&](const std::string& method) {
        return boxed(method).stroke.amplitude[1] / open(method).stroke.amplitude[1] - 1;
      });
    }
  }
}

// Without inertia a box gives second-order theory with the mobility exact + pairs in the box - pairs in open
// space, with its derivatives, those of the images weakened by C_exact/C_RP; also between walls that the
// swimmer does not stand in the middle of.
TEST(InertiaCorrected, InABoxTendsToSteadyTheoryAsDensityVanishes) {
  constexpr double density = 1e-12, tolerance = 1e-5;
  const CollinearSwimmer swimmer = with_density(with_amplitude(unequal_swimmer(), small), density);
  for (const BoxPlace& place :
       {BoxPlace{periodic_box(140, 60, 70), {70, 30, 35}}, BoxPlace{walled_box(140, 60, 70), {60, 22, 35}}}) {
    const Question question = ask_in_box(swimmer, place.box, place.middle_bead, density);
    const LineFlow flow = box_line_flow(place, swimmer.viscosity);
    const CollinearMobility exact = exact_mobility(swimmer, rest_positions(swimmer)),
                            open = rest_mobility(swimmer, rotne_prager),
                            boxed = rotne_prager_mobility(flow, swimmer, rest_positions(swimmer, place));
    CollinearMobility mobility = exact;
    mobility.value += boxed.value - open.value;
    const double weakening = geometry_factor(exact) / geometry_factor(open);
    for (int k = 0; k < 3; ++k) mobility.slope[k] += weakening * (boxed.slope[k] - open.slope[k]);
    const PeriodicMotion steady = second_order_motion(swimmer, mobility);
    const Prediction p = predicted("inertia-corrected", question);
    EXPECT_NEAR(p.velocity / steady.velocity, 1, tolerance);
    EXPECT_NEAR(p.stroke.amplitude[1] / steady.stroke.amplitude[1], 1, tolerance);
    EXPECT_GT(std::abs(setting(p, "velocity_by_box") / p.velocity), 100 * tolerance);
  }
}

// Finite amplitude comes from exact Stokes flow: what that adds to velocity, it adds here, for the stroke
// that inertia leaves; its uncertainty is at most all of it.
TEST(InertiaCorrected, TakesAmplitudeFromExactStokesFlow) {
  constexpr double model = 2e-3;
  const CollinearSwimmer swimmer = paper_swimmer(4800);
  const auto growth = [&](const std::string& method) {
    const double amplitude = 0.2;
    return predicted(method, ask(with_amplitude(swimmer, amplitude))).velocity /
               (predicted(method, ask(with_amplitude(swimmer, small))).velocity *
                std::pow(amplitude / small, 2)) -
           1;
  };
  EXPECT_NEAR(growth("inertia-corrected"), growth("multipole-ode"), model);
  EXPECT_GT(growth("multipole-ode"), 5 * model);
}

}  // namespace
}  // namespace beadswim
