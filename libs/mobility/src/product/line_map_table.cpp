#include "beadswim/mobility/line_map_table.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/collinear/multipole_mobility.hpp"

namespace beadswim {
namespace {

constexpr double viscosity = 1;
constexpr double max_gap = 64;       // largest gap of a table [mean radius]
constexpr double truncation = 1e-8;  // tolerance of multipole_mobility()
constexpr double spacing = 0.125;    // distance of neighbouring table nodes
constexpr int stencil = 6;           // table nodes per axis that one interpolation uses

double no_weight(double /*distance*/) {
  return 0;
}

/// Returns the positions of the spheres, of which the first is at 0.
template <std::size_t n>
std::array<double, n> line_of(const std::array<double, n>& radii, const std::array<double, n - 1>& gaps) {
  std::array<double, n> line{};
  for (std::size_t k = 0; k + 1 < n; ++k) line[k + 1] = line[k] + radii[k] + gaps[k] + radii[k + 1];
  return line;
}

/// Evaluates the n Lagrange polynomials of the nodes 0 to n - 1 at t.
template <int n>
std::array<double, n> lagrange_weights(double t) {
  constexpr auto scales = [] {
    std::array<double, n> result;
    for (int k = 0; k < n; ++k) {
      double product = 1;
      for (int m = 0; m < n; ++m)
        if (m != k) product *= k - m;
      result[k] = 1 / product;
    }
    return result;
  }();
  std::array<double, n> weights = scales;
  for (int k = 0; k < n; ++k)
    for (int m = 0; m < n; ++m)
      if (m != k) weights[k] *= t - m;
  return weights;
}

}  // namespace

double fading(double x, double full, double none) {
  if (x <= full) return 1;
  if (x >= none) return 0;
  const double t = (x - full) / (none - full);
  return 1 - t * t * t * (10 - 15 * t + 6 * t * t);
}

/// Solves gap (R - a_l + a_s) = 2 excess R a_l for the gap. a_l is the larger radius, a_s the smaller radius,
/// and R = gap + a_l + a_s the distance of the centres.
double min_tabulated_gap(double radius_i, double radius_j, double excess) {
  const auto [small, large] = std::minmax(radius_i, radius_j);
  const double half = small - excess * large;
  return -half + std::sqrt(half * half + 2 * excess * large * (large + small));
}

template <int N>
LineMapTable<N>::LineMapTable(const std::array<double, N>& radii) : radii_(radii) {
  int count = 1;
  for (int k = 0; k < N - 1; ++k) {
    min_gaps_[k] = min_tabulated_gap(radii[k], radii[k + 1], 0.01 * (N - 1));
    const double last = std::log(max_gap * (radii[k] + radii[k + 1]) / 2 / min_gaps_[k]);
    counts_[k] = static_cast<int>(std::ceil(last / spacing)) + 1;
    count *= counts_[k];
  }
  nodes_.resize(count);
}

template <int N>
const LineMatrix<N>& LineMapTable<N>::node(const Index& index) {
  int number = 0;
  Gaps gaps;
  for (int k = 0; k < N - 1; ++k) {
    number = number * counts_[k] + index[k];
    gaps[k] = min_gaps_[k] * std::exp(spacing * index[k]);
  }
  const auto line = line_of(radii_, gaps);
  if (!nodes_[number])
    nodes_[number] = multipole_mobility(radii_, line, viscosity, truncation).value -
                     strained_line<N>(radii_, line, viscosity, no_weight);
  return *nodes_[number];
}

template <int N>
LineMatrix<N> LineMapTable<N>::interpolated(const Gaps& gaps) {
  std::array<std::array<double, stencil>, N - 1> weights;
  Index first;
  int points = 1;
  for (int k = 0; k < N - 1; ++k) {
    const int last = counts_[k] - 1;
    const double t = std::min(std::log(gaps[k] / min_gaps_[k]) / spacing, double(last));
    first[k] = std::clamp(static_cast<int>(t) - stencil / 2 + 1, 0, last - stencil + 1);
    weights[k] = lagrange_weights<stencil>(t - first[k]);
    points *= stencil;
  }
  LineMatrix<N> sum = LineMatrix<N>::Zero();
  for (int p = 0; p < points; ++p) {
    Index index;
    double weight = 1;
    for (int k = 0, rest = p; k < N - 1; ++k, rest /= stencil) {
      index[k] = first[k] + rest % stencil;
      weight *= weights[k][rest % stencil];
    }
    sum += weight * node(index);
  }
  return sum;
}

template <int N>
LineMap<N> LineMapTable<N>::at(Gaps gaps, double (*weight)(double)) {
  double share = 1;
  for (int k = 0; k < N - 1; ++k) {
    share *= fading(min_gaps_[k] - gaps[k], 0, min_gaps_[k]);
    gaps[k] = std::max(min_gaps_[k], gaps[k]);  // NaN: the smallest gap
  }
  const auto line = line_of(radii_, gaps);
  LineMap<N> result = line_map<N>(strained_line<N>(radii_, line, viscosity, no_weight) + interpolated(gaps),
                                  strained_line<N>(radii_, line, viscosity, weight));
  result.tow_defect *= share;
  return result;
}

template class LineMapTable<2>;
template class LineMapTable<3>;

}  // namespace beadswim
