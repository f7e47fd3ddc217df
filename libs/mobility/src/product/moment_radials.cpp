#include "moment_radials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {
namespace {

double unit(double viscosity) {
  return 1 / (8 * std::numbers::pi * viscosity);
}

}  // namespace

MomentRadials MomentRadials::reversed() const {
  MomentRadials f = *this;
  const auto reverse = [](auto& values) {
    for (double& value : values) value = -value;
  };
  reverse(f.chi);
  reverse(f.laplacian);
  reverse(f.bilaplacian);
  return f;
}

MomentRadials open_radials(double r, double viscosity, int highest) {
  MomentRadials f{.highest = highest};
  double value = unit(viscosity) / r;  // ((1/r) d/dr)^n (1/r)
  for (int n = 0; n <= highest; ++n) {
    if (n < highest) f.chi[n + 1] = value;
    f.laplacian[n] = 2 * value;
    value *= -(2 * n + 1) / (r * r);
  }
  return f;
}

MomentRadials near_radials(const EwaldSplit& split, double r, double viscosity) {
  MomentRadials f{.highest = SplitPolynomials::highest};
  near_functions(split.near, unit(viscosity), r, f.chi, f.laplacian, f.bilaplacian);
  return f;
}

MomentRadials far_radials(const EwaldSplit& split, double r, double viscosity, int highest) {
  MomentRadials f{.highest = highest};
  double scale = unit(viscosity);
  for (int n = 0; n <= highest; ++n, scale = -scale) {
    const double mean = split.mean(n, r);
    if (n < highest) f.chi[n + 1] = scale * mean;
    f.laplacian[n] = scale * (2 * mean + split.bell(n, r));
    if (n <= highest - 2)
      f.bilaplacian[n] = scale * (r * r * split.bell(n + 2, r) - (5 + 2 * n) * split.bell(n + 1, r));
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

/// Height of p_l, whose integral is 1.
double height(int l, double a) {
  constexpr double heights[3]{1.0 / 2, 3.0 / 4, 15.0 / 16};
  return heights[l] / a;
}

double factorial(std::size_t n) {
  double product = 1;
  for (std::size_t k = 2; k <= n; ++k) product *= static_cast<double>(k);
  return product;
}

/// Powers x^0, x^1, ... of a number.
using Powers = std::array<double, 2 * highest_of_pairs + 2>;

Powers powers_of(double x) {
  Powers powers{1};
  for (std::size_t n = 1; n < powers.size(); ++n) powers[n] = x * powers[n - 1];
  return powers;
}

/// Returns r X(r), by powers of r, if the sphere of radius b with moments of degree m is inside the sphere of
/// radius a with moments of degree l.
Polynomial inside(int l, int m, double a, double b) {
  const Polynomial p = power({1, 0, -1 / (a * a)}, l),
                   q = power({1, 0, -1 / (b * b)}, m);  // even powers only
  const Powers of_a = powers_of(a), of_b = powers_of(b);
  Polynomial H(p.size() + 3, 0.0);  // integral of p_l(s) (y + s) |y + s| ds, by powers of y
  for (std::size_t n = 0; n < p.size(); n += 2) {
    const double coefficient = 4 * height(l, a) * p[n], k = static_cast<double>(n);
    H[1] += coefficient * of_a[n + 2] / (k + 2);
    H[n + 3] += coefficient / ((k + 1) * (k + 2) * (k + 3));
  }
  const auto moment = [&](std::size_t k) {  // mean of t^k over p_m(t)
    double sum = 0;
    for (std::size_t n = 0; n < q.size(); n += 2) {
      const std::size_t exponent = n + k + 1;
      sum += 2 * height(m, b) * q[n] * of_b[exponent] / static_cast<double>(exponent);
    }
    return sum;
  };
  Polynomial result(H.size(), 0.0);  // mean of H(r + t) over p_m(t)
  for (std::size_t n = 1; n < H.size(); n += 2)
    for (std::size_t k = 0; k < n; k += 2)
      result[n - k] += H[n] * factorial(n) / (factorial(k) * factorial(n - k)) * moment(k);
  return result;
}

/// Returns the coefficients, by powers of v = r - (a - b), by which r X(r) differs from inside() if the
/// surfaces intersect.
Polynomial outside_part(int l, int m, double a, double b) {
  const Polynomial p = power({0, -2 / a, -1 / (a * a)}, l), q = power({0, 2 / b, -1 / (b * b)}, m);
  Polynomial result(p.size() + q.size() + 3, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      result[i + j + 4] -=
          4 * height(l, a) * height(m, b) * p[i] * q[j] * factorial(i) * factorial(j) / factorial(i + j + 4);
  return result;
}

/// Adds ((1/r) d/dr)^n of coefficient v^k/r, with dv/dr = 1, to derivatives[n] for all n. Each derivative is
/// a sum of terms v^(k - j) r^-(2 n + 1 - j). Arguments: powers of v and of 1/r.
void add_derivatives(double coefficient, std::size_t k, const Powers& v, const Powers& inverse_r,
                     double* derivatives) {
  std::array<double, highest_of_pairs + 2> terms{coefficient};  // coefficient of term j
  for (int n = 0; n <= highest_of_pairs; ++n) {
    std::array<double, highest_of_pairs + 2> next{};
    for (int j = 0; j <= n; ++j) {
      if (terms[j] == 0) continue;
      const int exponent = static_cast<int>(k) - j, inverse = 2 * n + 1 - j;
      derivatives[n] += terms[j] * v[exponent] * inverse_r[inverse];
      next[j + 1] += exponent * terms[j];
      next[j] -= inverse * terms[j];
    }
    terms = next;
  }
}

/// Adds ((1/r) d/dr)^n of coefficient r^exponent to derivatives[n] for all n; exponent is even, 0 or more.
void add_even_power(double coefficient, int exponent, const Powers& r, double* derivatives) {
  for (int n = 0; n <= highest_of_pairs && exponent >= 0; ++n, exponent -= 2) {
    derivatives[n] += coefficient * r[exponent];
    coefficient *= exponent;
  }
}

}  // namespace

MomentRadials overlap_radials(int l, int m, double a, double b, double r, double viscosity) {
  if (a < b) return overlap_radials(m, l, b, a, r, viscosity);
  MomentRadials f;
  const Polynomial contained = inside(l, m, a, b);
  const Powers of_r = powers_of(r);
  for (std::size_t k = 1; k < contained.size(); k += 2) {
    const double c = unit(viscosity) * contained[k], n = static_cast<double>(k);
    add_even_power(c, static_cast<int>(k) - 1, of_r, f.chi);
    if (k >= 3) add_even_power(c * n * (n - 1), static_cast<int>(k) - 3, of_r, f.laplacian);
  }
  const double v = r - (a - b);
  if (v <= 0) return f;
  const Polynomial outside = outside_part(l, m, a, b);
  const Powers of_v = powers_of(v), of_inverse = powers_of(1 / r);
  for (std::size_t k = 4; k < outside.size(); ++k) {
    const double c = unit(viscosity) * outside[k], n = static_cast<double>(k);
    add_derivatives(c, k, of_v, of_inverse, f.chi);
    add_derivatives(c * n * (n - 1), k - 2, of_v, of_inverse, f.laplacian);
  }
  return f;
}

void set_lane(SourceLanes& spheres, int lane, const Vec3& r, const std::array<double, 3>& sizes,
              std::span<const double> source) {
  for (int a = 0; a < 3; ++a) {
    spheres.r[a][lane] = r[a];
    spheres.size[a][lane] = sizes[a];
  }
  spheres.distance[lane] = r.norm();
  for (std::size_t k = 0; k < source.size(); ++k) spheres.source[k][lane] = source[k];
}

void set_radials(SourceLanes& spheres, int lane, const MomentRadials& radials) {
  for (int n = 0; n <= radials.highest; ++n) {
    spheres.chi[n][lane] = radials.chi[n];
    spheres.laplacian[n][lane] = radials.laplacian[n];
    if (n <= radials.highest - 2) spheres.bilaplacian[n][lane] = radials.bilaplacian[n];
  }
}

void clear_lanes(SourceLanes& spheres, int used) {
  const auto copy_first = [&](auto& rows) {
    for (auto& row : rows) std::fill(row + used, row + lanes, row[0]);
  };
  copy_first(spheres.r);
  std::fill(spheres.distance + used, spheres.distance + lanes, spheres.distance[0]);
  copy_first(spheres.chi);
  copy_first(spheres.laplacian);
  copy_first(spheres.bilaplacian);
  for (auto& size : spheres.size) std::fill(size + used, size + lanes, 0.0);
  for (auto& source : spheres.source) std::fill(source + used, source + lanes, 0.0);
}

}  // namespace beadswim
