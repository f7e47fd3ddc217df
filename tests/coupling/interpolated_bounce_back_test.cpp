#include "beadswim/coupling/link_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/populations.hpp"

namespace beadswim {
namespace {

// The populations of a steady linear shear flow u = G x, to first order in it, about a cell at the origin:
//   before collision f_i(x) = 3 w_i (c_i.u(x) - tau c_i.G c_i), after it f_i*(x) = 3 w_i (c_i.u(x) - (tau -
//   1) c_i.G c_i)
// with G free of trace. The wall at q c_i moves with the flow there: the flow must satisfy the law for any q
// and tau. Catches a wrong weight, sign or neighbour.
TEST(InterpolatedBounceBack, IsExactInALinearShearFlow) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1), rate(-0.01, 0.01);
  for (int n = 0; n < 200; ++n) {
    const int i = 1 + n % 18;
    const double tau = 0.5 + 3 * part(random), q = part(random), w = d3q19::weight(i);
    Eigen::Matrix3d shear = Eigen::Matrix3d::NullaryExpr([&] { return rate(random); });
    shear -= Eigen::Matrix3d::Identity() * shear.trace() / 3;
    const Vec3 c = velocity_of(i), flow(rate(random), rate(random), rate(random));
    const auto along = [&](const Vec3& direction, const Vec3& x) { return direction.dot(flow + shear * x); };
    const auto before = [&](const Vec3& direction, const Vec3& x) {
      return 3 * w * (along(direction, x) - tau * direction.dot(shear * direction));
    };
    const auto after = [&](const Vec3& direction, const Vec3& x) {
      return 3 * w * (along(direction, x) - (tau - 1) * direction.dot(shear * direction));
    };
    const Vec3 here = Vec3::Zero();
    const double back = bounced_interpolated(w, interpolation_weight(q), after(c, here), after(c, -c),
                                             after(-c, here), along(c, q * c));
    EXPECT_NEAR(back, before(-c, here), 1e-15) << "direction " << i << ", q " << q << ", tau " << tau;
  }
}

// A steady flow whose velocity is parabolic and whose pressure is linear along a link. With U = 3 w c.u and P
// = w r at x + s c, primes along s, and relaxation times T, t of the two parts, T' = T - 1/2:
//   g+ = U'(s),  g- = P' - T' U''                       what a collision adds to either part
//   f_i, f_ibar before collision = P -+ U - T g+ -+ t g-   (upper sign: ibar), after it with T - 1 and t - 1
// (Ginzburg, Verhaeghe & d'Humieres 2008, section 3: exact for these flows.) The wall at s = q moves with the
// flow there. Catches a wrong coefficient, neighbour, or correction of the slip.
TEST(Multireflection, IsExactInAParabolicFlow) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> part(0, 1), rate(-0.01, 0.01);
  for (int n = 0; n < 200; ++n) {
    const double tau = 0.55 + 3 * part(random), q = part(random), w = d3q19::weight(1 + n % 18);
    const RelaxationRates rates = relaxation_rates(tau);
    const double t = 1 / rates.antisymmetric;
    if (std::abs(1 - t) < 0.01) continue;  // there the law has nothing to go by
    const double u = rate(random), slope = rate(random), bend = rate(random);
    const double p = rate(random), p_slope = rate(random), g_odd = p_slope - (tau - 0.5) * bend;
    const auto speed = [&](double s) { return u + s * slope + 0.5 * s * s * bend; };  // U
    const auto population = [&](int sign, double s, double even_time, double odd_time) {
      return p + s * p_slope + sign * speed(s) - even_time * (slope + s * bend) - sign * odd_time * g_odd;
    };
    const auto after = [&](int sign, double s) { return population(sign, s, tau - 1, t - 1); };
    const MultireflectionLink link{.outgoing = after(1, 0),
                                   .arrived = after(-1, 0),
                                   .behind = after(1, -1),
                                   .arrived_behind = after(-1, -1),
                                   .two_behind = after(1, -2),
                                   .speed = speed(0) / (3 * w)};
    const double back = bounced_multireflection(w, q, multireflection_slip(rates), link, speed(q) / (3 * w));
    EXPECT_NEAR(back, population(-1, 0, tau, t), 1e-14) << "q " << q << ", tau " << tau;
  }
}

// Catches the wrong root, and a distance measured from the wrong end of the link.
TEST(InterpolatedBounceBack, FindsTheSurfaceOnTheLink) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> place(-6, 6);
  int links = 0;
  while (links < 500) {
    const Vec3 covered(place(random), place(random), place(random));
    const double radius = 1 + 0.009 * links;
    const Vec3 into = velocity_of(1 + links % 18);
    const Vec3 fluid = covered - into;
    if (covered.norm() >= radius || fluid.norm() < radius) continue;
    const double c[3] = {into[0], into[1], into[2]}, r[3] = {covered[0], covered[1], covered[2]};
    const double q = wall_distance(c, r, radius * radius);
    EXPECT_GE(q, 0);
    EXPECT_LE(q, 1);
    EXPECT_NEAR((fluid + q * into).norm(), radius, 1e-13);
    ++links;
  }
}

}  // namespace
}  // namespace beadswim
