#pragma once

#include <array>

// Gauss-Legendre quadrature of 16 points: exact for polynomials up to degree 31.
// Abramowitz and Stegun, Handbook of Mathematical Functions, table 25.4.

namespace beadswim {

struct QuadraturePoint {
  double place;   ///< in (0, 1), and mirrored
  double weight;  ///< on (-1, 1): all sixteen sum to 2
};

inline constexpr std::array<QuadraturePoint, 8> gauss_legendre_16{
    {{0.0950125098376374402, 0.1894506104550684963},
     {0.2816035507792589132, 0.1826034150449235889},
     {0.4580167776572273863, 0.1691565193950025382},
     {0.6178762444026437484, 0.1495959888165767321},
     {0.7554044083550030339, 0.1246289712555338720},
     {0.8656312023878317439, 0.0951585116824927848},
     {0.9445750230732325761, 0.0622535239386478929},
     {0.9894009349916499326, 0.0271524594117540949}}};

/// Integral of f over (from, to), as a sum: calls add(place, weight).
template <class Add>
void gauss_legendre(double from, double to, const Add& add) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  for (const auto& point : gauss_legendre_16) {
    add(middle - half * point.place, half * point.weight);
    add(middle + half * point.place, half * point.weight);
  }
}

}  // namespace beadswim
