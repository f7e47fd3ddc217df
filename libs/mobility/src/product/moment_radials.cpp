#include "moment_radials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {
namespace {

constexpr int highest = 6;

double unit(double viscosity) {
  return 1 / (8 * std::numbers::pi * viscosity);
}

}  // namespace

MomentRadials open_radials(double r, double viscosity) {
  MomentRadials f;
  double value = unit(viscosity) / r;  // ((1/r) d/dr)^n (1/r)
  for (int n = 0; n <= highest; ++n) {
    if (n < highest) f.chi[n + 1] = value;
    f.laplacian[n] = 2 * value;
    value *= -(2 * n + 1) / (r * r);
  }
  return f;
}

MomentRadials near_radials(double xi, double r, double viscosity) {
  MomentRadials f;
  const double x2 = xi * xi, r2 = r * r,
               bell = unit(viscosity) / std::sqrt(std::numbers::pi) * std::exp(-x2 * r2);
  double B = unit(viscosity) * std::erfc(xi * r) / r, power = 1, sign = 1;  // power: (2 xi^2)^n
  for (int n = 0; n <= highest; ++n) {
    if (n < highest) f.chi[n + 1] = sign * B;
    f.laplacian[n] = sign * (2 * B - 2 * xi * power * bell);
    if (n < 5) f.bilaplacian[n] = sign * power * x2 * xi * (20 - 8 * x2 * r2 + 8 * n) * bell;
    power *= 2 * x2;
    B = ((2 * n + 1) * B + power * bell / xi) / r2;
    sign = -sign;
  }
  return f;
}

namespace {

/// Boys functions F_0 to F_6 at T >= 0: a series for the last, then the recursion downwards.
void boys_functions(double T, double (&F)[highest + 1]) {
  const double bell = std::exp(-T);
  double term = 1.0 / (2 * highest + 1), sum = 0;
  for (int k = 0; term > 1e-17 * sum; ++k) {
    sum += term;
    term *= 2 * T / (2 * (highest + k) + 3);
  }
  F[highest] = bell * sum;
  for (int n = highest - 1; n >= 0; --n) F[n] = (2 * T * F[n + 1] + bell) / (2 * n + 1);
}

}  // namespace

MomentRadials far_radials(double xi, double r, double viscosity) {
  MomentRadials f;
  const double x2 = xi * xi, r2 = r * r, scale = unit(viscosity) * 2 * xi / std::sqrt(std::numbers::pi);
  const double bell = std::exp(-x2 * r2);
  double F[highest + 1], power = scale;  // (-2 xi^2)^n 2 xi/sqrt(pi)
  boys_functions(x2 * r2, F);
  for (int n = 0; n <= highest; ++n) {
    if (n < highest) f.chi[n + 1] = power * F[n];
    f.laplacian[n] = power * (2 * F[n] + bell);
    if (n < 5) f.bilaplacian[n] = -power * x2 / 2 * (20 - 8 * x2 * r2 + 8 * n) * bell;
    power *= -2 * x2;
  }
  return f;
}

namespace {

using Polynomial = std::vector<double>;  ///< coefficients by ascending power

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial product(p.size() + q.size() - 1, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
  return product;
}

Polynomial power(const Polynomial& p, int exponent) {
  Polynomial result{1};
  for (int n = 0; n < exponent; ++n) result = result * p;
  return result;
}

void add(Polynomial& sum, double factor, const Polynomial& term) {
  if (sum.size() < term.size()) sum.resize(term.size(), 0.0);
  for (std::size_t n = 0; n < term.size(); ++n) sum[n] += factor * term[n];
}

/// Height of p_l: its integral is 1.
double height(int l, double a) {
  constexpr double heights[3]{1.0 / 2, 3.0 / 4, 15.0 / 16};
  return heights[l] / a;
}

double factorial(std::size_t n) {
  return std::tgamma(static_cast<double>(n) + 1);
}

/// r X of spheres of which the surfaces cut each other, by powers of r.
Polynomial cutting(int l, int m, double a, double b) {
  // p_l and p_m by the distances from their ends, and the coefficients of their convolution by that from its
  // end.
  Polynomial p = power({0, 2 / a, -1 / (a * a)}, l), q = power({0, 2 / b, -1 / (b * b)}, m);
  const Polynomial apart{a + b, -1};  // u = a + b - r
  Polynomial result{2 * (size_factors[l] * a * a + size_factors[m] * b * b), 0, 1};
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const double convolution = height(l, a) * height(m, b) * p[i] * q[j] * factorial(i) * factorial(j);
      // Integral of x^n (u - x)^2 over x from 0 to u, with n = i + j + 1: 2 n!/(n + 3)! u^(n + 3).
      const std::size_t n = i + j + 1;
      add(result, -4 * convolution / factorial(n + 3), power(apart, static_cast<int>(n) + 3));
    }
  }
  return result;
}

/// r X of a sphere of radius `small` within one of radius `large`, with moments of the degrees m and l.
Polynomial within(int l, int m, double large, double small) {
  Polynomial p = power({1, 0, -1 / (large * large)}, l);  // only even powers
  Polynomial H{0, 0};  // integral of p_l(s) (y + s) |y + s|, by powers of y
  for (std::size_t n = 0; n < p.size(); n += 2) {
    const double coefficient = height(l, large) * p[n], k = static_cast<double>(n);
    H[1] += 4 * coefficient * std::pow(large, k + 2) / (k + 2);
    Polynomial term(n + 4, 0.0);
    term[n + 3] = 4 * coefficient / ((k + 1) * (k + 2) * (k + 3));
    add(H, 1, term);
  }
  // Mean of H(r + t) over p_m(t): moments of t are those of p_m.
  Polynomial q = power({1, 0, -1 / (small * small)}, m), result{0};
  const auto moment = [&](int k) {
    double sum = 0;
    for (std::size_t n = 0; n < q.size(); n += 2)
      sum += height(m, small) * q[n] * 2 * std::pow(small, static_cast<double>(n) + k + 1) /
             (static_cast<double>(n) + k + 1);
    return sum;
  };
  for (std::size_t n = 1; n < H.size(); n += 2) {
    for (std::size_t k = 0; k < n; k += 2) {
      Polynomial term(n - k + 1, 0.0);
      term[n - k] = factorial(n) / (factorial(k) * factorial(n - k)) * moment(static_cast<int>(k));
      add(result, H[n], term);
    }
  }
  return result;
}

}  // namespace

std::vector<double> overlap_polynomial(int l, int m, double a, double b, double r) {
  if (r <= a - b) return within(l, m, a, b);
  if (r <= b - a) return within(m, l, b, a);
  Polynomial X = cutting(l, m, a, b);
  // Of equal spheres, the odd powers of X below the third plus 2 l are zero except for rounding.
  const double size = a + b;
  for (std::size_t n = 0; n < X.size(); ++n)
    if (std::abs(X[n]) < 1e-11 * std::pow(size, 2 - static_cast<double>(n))) X[n] = 0;
  return X;
}

MomentRadials polynomial_radials(const std::vector<double>& polynomial, double r, double viscosity) {
  MomentRadials f;
  for (std::size_t k = 0; k < polynomial.size(); ++k) {
    if (polynomial[k] == 0) continue;
    double exponent = static_cast<double>(k) - 1;  // of r in X
    double chi = unit(viscosity) * polynomial[k], laplacian = chi * exponent * (exponent + 1);
    for (int n = 0; n <= highest; ++n) {
      if (n > 0 && chi != 0) f.chi[n] += chi * std::pow(r, exponent);
      if (laplacian != 0) f.laplacian[n] += laplacian * std::pow(r, exponent - 2);
      laplacian *= exponent - 2;
      chi *= exponent;
      exponent -= 2;
    }
  }
  return f;
}

}  // namespace beadswim
