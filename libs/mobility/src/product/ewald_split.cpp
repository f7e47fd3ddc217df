#include "ewald_split.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/core/gauss_legendre.hpp"
#include "moment_radials.hpp"

namespace beadswim {
namespace {

/// Returns I_n(z)/z^n for z = sqrt(square).
double bessel_ratio(int n, double square) {
  double term = 1;
  for (int k = 1; k <= n; ++k) term /= 2 * k;
  double sum = 0;
  for (int k = 0; term > 1e-18 * sum; ++k) {
    sum += term;
    term *= square / 4 / ((k + 1) * (n + k + 1));
  }
  return sum;
}

/// Returns the nth derivative of a polynomial at w.
double derivative(const double* coefficients, int terms, int n, double w) {
  double sum = 0;
  for (int k = terms - 1; k >= n; --k) {
    double factor = coefficients[k];
    for (int m = 0; m < n; ++m) factor *= k - m;
    sum = sum * w + factor;
  }
  return sum;
}

}  // namespace

double sinh_ratio(double y) {
  if (std::abs(y) < 1e-4) return 1 + y / 6;
  const double q = std::sqrt(std::abs(y));
  return (y > 0 ? std::sinh(q) : std::sin(q)) / q;
}

double sinh_ratio_slope(double y) {
  if (std::abs(y) < 1e-4) return 1.0 / 6 + y / 60;
  const double q = std::sqrt(std::abs(y));
  return ((y > 0 ? std::cosh(q) : std::cos(q)) - sinh_ratio(y)) / (2 * y);
}

double kaiser_bessel_bell(double shape, double x) {
  return bessel_ratio(0, shape * shape * (1 - x * x));
}

EwaldSplit::EwaldSplit(double cutoff, double shape) : cutoff(cutoff), shape(shape) {
  const double square = shape * shape, height = 1 / (cutoff * sinh_ratio(square)), rate = square / (cutoff * cutoff);
  near.inverse_square = 1 / (cutoff * cutoff);
  near.below = 1 / rate;
  near.above = cutoff * cutoff / rate;
  // I_n(z)/z^n = sum of (z^2/4)^k/(2^n k! (n + k)!), with z^2 = b^2 w.
  double size = 1;  // of a term of I_0(b), which is at least that of every series here
  for (int k = 0; k < SplitPolynomials::max_terms && (k < shape || size > 1e-18); ++k, near.terms = k) {
    if (k > 0) size *= square / 4 / (k * k);
    for (int t = 0; t < 2; ++t) {
      const int n = SplitPolynomials::highest + t;
      double& term = near.bells[t][k];
      if (k > 0) {
        term = near.bells[t][k - 1] * square / 4 / (k * (n + k));
      } else {
        term = height * std::pow(rate, n);
        for (int m = 1; m <= n; ++m) term /= 2 * m;
      }
    }
  }
  // A_0 is the mean of phi(t r) over t from 0 to 1; the argument z^2 there is b^2 (1 - t^2 + t^2 w).
  for (const auto& [t, weight] : gauss_legendre(64, 0, 1)) {
    double factor = weight * height;  // (b^2 t^2/2)^k/k!
    for (int k = 0; k < near.terms; ++k) {
      near.mean[k] += factor * bessel_ratio(k, square * (1 - t * t));
      factor *= square * t * t / 2 / (k + 1);
    }
  }
  // S = sum y^n/(2 n + 1)!,   S' = sum (n + 1) y^n/(2 n + 3)!,   c^2 k^2 = b^2 - y
  double inverse = 1 / sinh_ratio(square);  // 1/(2 n + 1)!
  size = inverse;
  for (int n = 0; n < shape || size > 1e-18; ++n) {
    far_terms.push_back(inverse * (1 - n + square * (n + 1) / ((2 * n + 2) * (2 * n + 3))));
    inverse /= (2 * n + 2) * (2 * n + 3);
    size *= square / ((2 * n + 2) * (2 * n + 3));
  }
}

double EwaldSplit::far_share(double k) const {
  const double waves = cutoff * cutoff * k * k, y = shape * shape - waves;
  return (sinh_ratio(y) + waves * sinh_ratio_slope(y)) / sinh_ratio(shape * shape);
}

double EwaldSplit::mean(int n, double r) const {
  return std::pow(2 * near.inverse_square, n) *
         derivative(near.mean, near.terms, n, 1 - r * r * near.inverse_square);
}

double EwaldSplit::bell(int n, double r) const {
  const double square = shape * shape;
  return std::pow(square * near.inverse_square, n) / (cutoff * sinh_ratio(square)) *
         bessel_ratio(n, square * (1 - r * r * near.inverse_square));
}

std::array<double, 4> EwaldSplit::far_integrals() const {
  std::array<double, 4> integrals;
  double factor = std::numbers::pi / 4;
  for (int n = 0; n < 4; ++n) {
    integrals[n] = factor * (2 * n + 3) * bell(n, 0);
    factor *= 2 * n + 1;
  }
  return integrals;
}

namespace {

/// Returns the tensor (I laplacian - grad grad) X at the distance r, from (1/r) X', ((1/r) d/dr)^2 X and
/// laplacian X.
PairTensor tensor_of(double first, double second, double laplacian, double r) {
  return {.isotropic = laplacian - first, .axial = -r * r * second};
}

SplitTensor tensor_of(const MomentRadials& f, double r) {
  return {.oseen = tensor_of(f.chi[1], f.chi[2], f.laplacian[0], r),
          .laplacian = tensor_of(f.laplacian[1], f.laplacian[2], f.bilaplacian[0], r),
          .bilaplacian = tensor_of(f.bilaplacian[1], f.bilaplacian[2],
                                   3 * f.bilaplacian[1] + r * r * f.bilaplacian[2], r)};
}

constexpr int highest_of_tensor = 4;

}  // namespace

SplitTensor near_tensor(const EwaldSplit& split, double r, double eta) {
  return tensor_of(near_radials(split, r, eta), r);
}

SplitTensor far_tensor(const EwaldSplit& split, double r, double eta) {
  return tensor_of(r < split.cutoff ? far_radials(split, r, eta, highest_of_tensor)
                                    : open_radials(r, eta, highest_of_tensor),
                   r);
}

double far_pressure(const EwaldSplit& split, double r, double eta) {
  if (r == 0) return 0;
  return r < split.cutoff ? -far_radials(split, r, eta, 1).laplacian[1] : -open_radials(r, eta, 1).laplacian[1];
}

}  // namespace beadswim
