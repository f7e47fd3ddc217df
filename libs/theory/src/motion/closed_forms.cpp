#include "beadswim/theory/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/collinear/rotne_prager.hpp"

namespace beadswim {

namespace {

/// Symbols of closed_forms.hpp for a swimmer with equal beads, equal arms and equal springs.
struct Symbols {
  explicit Symbols(const CollinearSwimmer& swimmer)
      : A(swimmer.amplitude[0]),
        B(swimmer.amplitude[1]),
        k(swimmer.stiffness[0]),
        l(swimmer.arm[0]),
        lambda(swimmer.radius[0]),
        omega(swimmer.angular_frequency()),
        W(std::numbers::pi * swimmer.viscosity * omega * lambda),
        sin_alpha(std::sin(swimmer.phase)),
        cos_alpha(std::cos(swimmer.phase)) {}

  double A, B, k, l, lambda, omega, W;
  double sin_alpha, cos_alpha;

  /// Returns (k^2 + 4 W^2) (k^2 + 36 W^2), which the paper prints expanded in equations (4.4) and (4.5).
  double denominator() const { return (k * k + 4 * W * W) * (k * k + 36 * W * W); }
  /// Returns N of equation (4.7), the numerator of sin(delta1 - delta2).
  double shift_numerator() const {
    return 2 * (A * A - B * B) * W * k + A * B * (k * k + 12 * W * W) * sin_alpha;
  }
};

// clang-format off
/// Returns the square of D of equation (4.8), the denominator of sin(delta1 - delta2), with powers of k and W
/// collected:
///
///   A^2 B^2 k^4 + 4 k^2 W^2 (A^4 + 6 A^2 B^2 + B^4) + 16 W^4 (4 A^4 + 25 A^2 B^2 + 4 B^4)
///   + 16 AB W^2 (A^2 + B^2) (k^2 + 20 W^2) cos alpha + 8 A^2 B^2 W^2 (k^2 + 16 W^2) cos 2 alpha
///   + 4 AB k W (A^2 - B^2) (k^2 + 12 W^2) sin alpha
double shift_denominator_squared(const Symbols& s) {
  const double A2 = s.A * s.A, B2 = s.B * s.B, AB = s.A * s.B;
  const double k2 = s.k * s.k, W2 = s.W * s.W;
  const double cos_2alpha = 2 * s.cos_alpha * s.cos_alpha - 1;
  return A2 * B2 * k2 * k2
       +  4 * k2 * W2 * (    A2 * A2 +  6 * A2 * B2 +     B2 * B2)
       + 16 * W2 * W2 * (4 * A2 * A2 + 25 * A2 * B2 + 4 * B2 * B2)
       + 16 * AB * W2 * s.cos_alpha * (A2 + B2) * (k2 + 20 * W2)
       +  8 * A2 * B2 * W2 * (k2 + 16 * W2) * cos_2alpha
       +  4 * AB * s.k * s.W * s.sin_alpha * (A2 - B2) * (k2 + 12 * W2);
}
// clang-format on

/// Returns the factor that equation (4.23) has in common as printed and as repaired. `coefficient` is the
/// factor of l in the term k^2 W^2 of the denominator: 8 as printed and 10 as repaired. The factor is
///
///   omega lambda (28l - 45 lambda) / (192 l^3 Y)
///   Y = (l - 5 lambda) k^4 + 4 W^2 (coefficient l - 33 lambda) k^2 + 144 W^4 l
double rpy_force_prefactor(const Symbols& s, double coefficient) {
  const auto [lambda, l, k2, W2] = std::array{s.lambda, s.l, s.k * s.k, s.W * s.W};
  const double bracket =
      (l - 5 * lambda) * k2 * k2 + 4 * W2 * (coefficient * l - 33 * lambda) * k2 + 144 * W2 * W2 * l;
  return s.omega * lambda * (28 * l - 45 * lambda) / (192 * l * l * l * bracket);
}

/// Returns (2l - 5 lambda) k^2 + 24 W^2 l, a factor of the velocity in equation (4.23) for A = B.
double rpy_force_symmetric_part(const Symbols& s) {
  return (2 * s.l - 5 * s.lambda) * s.k * s.k + 24 * s.W * s.W * s.l;
}

}  // namespace

double oseen_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const Symbols s(swimmer);
  return 7 * s.lambda / (24 * s.l * s.l) * (s.omega * stroke.area());
}

double rpy_stroke_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const Symbols s(swimmer);
  return (28 * s.l - 99 * s.lambda) * s.lambda / (24 * s.l * s.l * (4 * s.l - 17 * s.lambda)) *
         (s.omega * stroke.area());
}

double rpy_force_velocity_printed(const CollinearSwimmer& swimmer) {
  const Symbols s(swimmer);
  return s.A * s.A * rpy_force_prefactor(s, 8) * rpy_force_symmetric_part(s);
}

double rpy_force_velocity_repaired(const CollinearSwimmer& swimmer) {
  const Symbols s(swimmer);
  const double symmetric = s.A * s.B * s.sin_alpha * rpy_force_symmetric_part(s);
  const double asymmetric = (s.A * s.A - s.B * s.B) * s.W * s.k * (4 * s.l - 9 * s.lambda);
  return rpy_force_prefactor(s, 10) * (symmetric + asymmetric);
}

double oseen_ratio_printed(const CollinearSwimmer& swimmer) {
  const double lambda = swimmer.radius[0], l = swimmer.arm[0];
  return 7 * (4 * l - 3 * lambda) * (4 * l - 7 * lambda) / (4 * l * (28 * l - 45 * lambda));
}

double oseen_ratio_repaired(const CollinearSwimmer& swimmer) {
  const double lambda = swimmer.radius[0], l = swimmer.arm[0];
  const double shape = 56 * l * l - 198 * l * lambda + 189 * lambda * lambda;
  return 7 * (4 * l - 7 * lambda) * (4 * l - 7 * lambda) * (4 * l - 3 * lambda) / (8 * l * shape);
}

double equal_weight_velocity(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const Symbols s(swimmer);
  const double gamma = 1 / self_mobility(s.lambda, swimmer.viscosity);
  const PairMobility near = rotne_prager(s.lambda, s.lambda, s.l, swimmer.viscosity);
  const PairMobility far = rotne_prager(s.lambda, s.lambda, 2 * s.l, swimmer.viscosity);
  const double a = gamma * near.value, p = gamma * near.slope;
  const double b = gamma * far.value, q = gamma * far.slope;
  const double G = (2 * a * p - b * q - 2 * p + q) / (3 * (b - 1) * (4 * a - b - 3));
  return G * (s.omega * stroke.area());
}

double oseen_force_velocity(const CollinearSwimmer& swimmer) {
  const Symbols s(swimmer);
  return 7 * s.lambda * s.omega * s.shift_numerator() / (24 * s.l * s.l * s.denominator());
}

std::array<double, 2> oseen_arm_amplitudes(const CollinearSwimmer& swimmer) {
  const Symbols s(swimmer);
  const double A2 = s.A * s.A, B2 = s.B * s.B, AB = s.A * s.B, k2 = s.k * s.k, W2 = s.W * s.W;
  const double mixed = 4 * AB * s.W * s.k * s.sin_alpha;
  // clang-format off
  const double d1_squared = (A2 * k2 + 4 * W2 * (4 * A2 +     B2 + 4 * AB * s.cos_alpha) - mixed) / s.denominator();
  const double d2_squared = (B2 * k2 + 4 * W2 * (    A2 + 4 * B2 + 4 * AB * s.cos_alpha) + mixed) / s.denominator();
  // clang-format on
  // If an arm is at rest, roundoff may make the square negative.
  return {std::sqrt(std::max(d1_squared, 0.0)), std::sqrt(std::max(d2_squared, 0.0))};
}

double oseen_sin_phase_shift(const CollinearSwimmer& swimmer) {
  const Symbols s(swimmer);
  const double squared = shift_denominator_squared(s);
  if (!(squared > 0)) return 0;  // the phase of an arm at rest is undefined
  return std::clamp(s.shift_numerator() / std::sqrt(squared), -1.0, 1.0);  // roundoff may make N/D exceed 1
}

}  // namespace beadswim
