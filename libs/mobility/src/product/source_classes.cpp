#include "source_classes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/fluid_memory.hpp"

namespace beadswim {
namespace {

/// Returns the squared radii of the classes: all that occur, or four Chebyshev points between the smallest
/// and the largest.
std::vector<double> squares_of_classes(std::vector<double> squares) {
  std::ranges::sort(squares);
  squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
  constexpr std::size_t points = max_exact_radii;
  if (squares.size() <= points) return squares;
  const double middle = (squares.back() + squares.front()) / 2, half = (squares.back() - squares.front()) / 2;
  std::vector<double> nodes;
  for (std::size_t n = 0; n < points; ++n)
    nodes.push_back(middle - half * std::cos(std::numbers::pi * static_cast<double>(n) / (points - 1)));
  return nodes;
}

}  // namespace

SourceClasses::SourceClasses(std::span<const double> radii, int highest_degree) {
  std::vector<double> squared_radii;
  for (const double radius : radii) squared_radii.push_back(radius * radius);
  const std::vector<double> squares = squares_of_classes(squared_radii);
  radii_ = squares.size();
  for (int degree = 0; degree <= highest_degree; ++degree)
    for (const double square : squares) classes_.push_back({.degree = degree, .radius = std::sqrt(square)});
  for (const double square : squared_radii) {
    for (const double own : squares) {  // polynomials of Lagrange
      double share = 1;
      for (const double other : squares)
        if (other != own) share *= (square - other) / (own - other);
      shares_.push_back(share);
    }
  }
}

}  // namespace beadswim
