#include "beadswim/mobility/line_map_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/mobility/line_map.hpp"

namespace beadswim {
namespace {

constexpr double max_gap = 64;                               // largest gap of a table [mean radius]
constexpr double pair_excess = 0.01, triplet_excess = 0.02;  // cosh xi - 1 at the smallest gap
constexpr double truncation = 1e-8;                          // tolerance of multipole_mobility()

double mean(double a, double b) {
  return (a + b) / 2;
}

template <class Lattice>
typename Lattice::Axis axis_of(double radius_i, double radius_j, double excess) {
  const double first = std::log(min_tabulated_gap(radius_i, radius_j, excess) / mean(radius_i, radius_j));
  const double last = std::log(max_gap);
  return {.first = first, .nodes = static_cast<int>(std::ceil((last - first) / Lattice::spacing)) + 1};
}

template <std::size_t n>
Eigen::MatrixXd exact_map(const std::array<double, n>& radii, const std::array<double, n>& positions) {
  constexpr double viscosity = 1;  // S does not depend on the viscosity
  return line_map(multipole_mobility(radii, positions, viscosity, truncation).value,
                  rotne_prager_line(radii, positions, viscosity));
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

/// Solves gap (R - a_l + a_s) = 2 excess R a_l for the gap. a_l is the larger radius, a_s the smaller radius,
/// and R = gap + a_l + a_s the distance of the centres.
double min_tabulated_gap(double radius_i, double radius_j, double excess) {
  const auto [small, large] = std::minmax(radius_i, radius_j);
  const double half = small - excess * large;
  return -half + std::sqrt(half * half + 2 * excess * large * (large + small));
}

template <int axes, int values>
LazyTable<axes, values>::LazyTable(const std::array<Axis, axes>& extent,
                                   std::function<Values(const Place&)> law)
    : extent_(extent), law_(std::move(law)) {
  std::size_t count = 1;
  for (const Axis& axis : extent_) count *= axis.nodes;
  nodes_.resize(count);
}

template <int axes, int values>
auto LazyTable<axes, values>::node(const std::array<int, axes>& index) const -> const Values& {
  std::size_t number = 0;
  Place place;
  for (int a = 0; a < axes; ++a) {
    number = number * extent_[a].nodes + index[a];
    place[a] = extent_[a].first + spacing * index[a];
  }
  if (!nodes_[number]) nodes_[number] = law_(place);
  return *nodes_[number];
}

template <int axes, int values>
auto LazyTable<axes, values>::at(const Place& place) const -> Values {
  std::array<std::array<double, stencil>, axes> weights;
  std::array<int, axes> first;
  int points = 1;
  for (int a = 0; a < axes; ++a) {
    const int last = extent_[a].nodes - 1;
    const double scaled = (place[a] - extent_[a].first) / spacing;
    const double t = scaled > 0 ? std::min(scaled, double(last)) : 0;
    first[a] = std::clamp(static_cast<int>(t) - stencil / 2 + 1, 0, last - stencil + 1);
    weights[a] = lagrange_weights<stencil>(t - first[a]);
    points *= stencil;
  }
  Values sum{};
  for (int p = 0; p < points; ++p) {
    std::array<int, axes> index;
    double weight = 1;
    for (int a = 0, rest = p; a < axes; ++a, rest /= stencil) {
      index[a] = first[a] + rest % stencil;
      weight *= weights[a][rest % stencil];
    }
    const Values& at_node = node(index);
    for (int v = 0; v < values; ++v) sum[v] += weight * at_node[v];
  }
  return sum;
}

template class LazyTable<1, 1>;
template class LazyTable<1, 2>;
template class LazyTable<2, 6>;

PairMapTable::PairMapTable(const std::array<double, 2>& radii)
    : mean_radius_(mean(radii[0], radii[1])),
      table_({axis_of<LazyTable<1, 2>>(radii[0], radii[1], pair_excess)},
             [radii, unit = mean_radius_](const std::array<double, 1>& u) {
               const double distance = radii[0] + radii[1] + unit * std::exp(u[0]);
               const Eigen::Matrix2d log = log_of_pair_map(exact_map<2>(radii, {0, distance}));
               return std::array{log(0, 0), log(0, 1)};
             }) {}

Eigen::RowVector2d PairMapTable::log_map(double gap) const {
  const auto [own, other] = table_.at({std::log(gap / mean_radius_)});
  return {own, other};
}

TripletMapTable::TripletMapTable(const std::array<double, 3>& radii)
    : mean_radii_{mean(radii[0], radii[1]), mean(radii[1], radii[2])},
      table_({axis_of<LazyTable<2, 6>>(radii[0], radii[1], triplet_excess),
              axis_of<LazyTable<2, 6>>(radii[1], radii[2], triplet_excess)},
             [radii, units = mean_radii_](const std::array<double, 2>& u) {
               const double second = radii[0] + radii[1] + units[0] * std::exp(u[0]);
               const double third = second + radii[1] + radii[2] + units[1] * std::exp(u[1]);
               const Eigen::Matrix3d change =
                   exact_map<3>(radii, {0, second, third}) - Eigen::Matrix3d::Identity();
               return std::array{change(0, 0), change(0, 1), change(0, 2),
                                 change(2, 0), change(2, 1), change(2, 2)};
             }) {}

Eigen::Matrix3d TripletMapTable::change(const std::array<double, 2>& gaps) const {
  const auto c = table_.at({std::log(gaps[0] / mean_radii_[0]), std::log(gaps[1] / mean_radii_[1])});
  Eigen::Matrix3d change;  // the columns of S - I sum to zero
  // clang-format off
  change <<  c[0],         c[1],         c[2],
            -c[0] - c[3], -c[1] - c[4], -c[2] - c[5],
             c[3],         c[4],         c[5];
  // clang-format on
  return change;
}

}  // namespace beadswim
