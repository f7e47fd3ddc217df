#include "multipole_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim::multipole {

namespace {

/// Returns the bispherical coordinate xi of sphere i relative to sphere j. With the distance R of the centres
/// and the radii a_i and a_j:
///
///   cosh xi     = (R^2 + a_i^2 - a_j^2) / (2 R a_i)
///   cosh xi - 1 = (R - a_i - a_j) (R - a_i + a_j) / (2 R a_i)
///
/// The second form avoids loss of significance near contact.
double bispherical_coordinate(const Line& line, int i, int j) {
  const double a_i = line.radius[i], a_j = line.radius[j];
  const double distance = std::abs(line.position[i] - line.position[j]);
  const double gap = std::max(0.0, distance - a_i - a_j);
  const double excess = gap * (distance - a_i + a_j) / (2 * distance * a_i);
  return std::log1p(excess + std::sqrt(excess * (2 + excess)));
}

/// Estimates the highest multipole order of sphere i that its neighbour j makes necessary. The multipoles of
/// order n contribute about C exp(-2 n xi) to the mobility, where xi is the bispherical coordinate of sphere
/// i. The estimate is therefore log(C/tolerance)/(2 xi). Numerical experiments give C near 8000 for distant
/// spheres and near 8000/x^6 for close spheres, where x is the mean of xi of both spheres. The estimate is an
/// initial guess; multipole_mobility() determines the actual error from the solution.
double needed_order(const Line& line, int i, int j, double log_tolerance) {
  const double xi = bispherical_coordinate(line, i, j);
  const double mean_xi = (xi + bispherical_coordinate(line, j, i)) / 2;
  const double log_size = std::log(8000.0) - 6 * std::min(0.0, std::log(mean_xi));
  return (log_size - log_tolerance) / (2 * xi);
}

int needed_order(const Line& line, int i, double log_tolerance) {
  double order = 4;
  for (int j = 0; j < line.size(); ++j) {
    if (j != i) order = std::max(order, needed_order(line, i, j, log_tolerance));
  }
  if (order > max_multipole_order) {
    throw InputError(fmt::format("sphere {}", i + 1),
                     "the sphere is too close to its neighbour and needs multipoles of order {:.0f}, above "
                     "the limit of {}; increase the gap or the tolerance",
                     order, max_multipole_order);
  }
  return static_cast<int>(std::ceil(order));
}

/// Returns the coefficients B_0 .. B_L of own flows, with B_0 = -A_1. `own_flow` contains A_0 .. A_L-1, B_1
/// .. B_L in 2L rows.
Eigen::MatrixXd phi_part(const Eigen::MatrixXd& own_flow) {
  const Eigen::Index order = own_flow.rows() / 2;
  Eigen::MatrixXd phi(order + 1, own_flow.cols());
  phi.row(0) = -own_flow.row(1);
  phi.bottomRows(order) = own_flow.bottomRows(order);
  return phi;
}

}  // namespace

// clang-format off
// The components P_l of the no-slip condition on the surface r = 1 are, with X = A + alpha and Y = B + beta
// (sums of the coefficients of the own and of the incoming flow):
//
//   tangential               0     = (l-2)/(2l-1) X_l-1 + (l+3)/(2l+3) X_l+1 + Y_l
//   radial + (l+1) tang.     A_l-1 = (2l-1)/(2(l+1)) [ (l-2)(2l+1)/(2l-1) alpha_l-1 + (l+1) alpha_l+1 + (2l+1) beta_l ]
Eigen::MatrixXd response(int order, const IncomingFlow& flow) {
  const int n = order;
  const Eigen::ArrayXd l = Eigen::ArrayXd::LinSpaced(n, 1, n);
  const Eigen::ArrayXd tangential_below = (l - 2) / (2 * l - 1), tangential_above = (l + 3) / (2 * l + 3);
  const Eigen::ArrayXd alpha_below = (l - 2)     * (2 * l + 1) / (2 * (l + 1));
  const Eigen::ArrayXd alpha_above = (2 * l - 1)               /  2;
  const Eigen::ArrayXd beta_level  = (2 * l - 1) * (2 * l + 1) / (2 * (l + 1));
  const auto below = flow.alpha.topRows(n).array();
  const auto above = flow.alpha.bottomRows(n).array();
  const auto level = flow.beta.bottomRows(n).array();

  Eigen::MatrixXd own(2 * n, flow.alpha.cols());
  auto a = own.topRows(n).array();
  auto b = own.bottomRows(n).array();
  a = below.colwise() * alpha_below + above.colwise() * alpha_above + level.colwise() * beta_level;
  b = -level - (a + below).colwise() * tangential_below - above.colwise() * tangential_above;
  b.topRows(n - 2) -= a.bottomRows(n - 2).colwise() * tangential_above.head(n - 2);
  return own;
}
// clang-format on

Eigen::MatrixXd translation(const Pair& pair) {
  const double receiver_step = std::abs(pair.receiver_radius / pair.offset) * (pair.offset > 0 ? -1 : 1);
  const double source_step = std::abs(pair.source_radius / pair.offset) * (pair.offset > 0 ? 1 : -1);
  Eigen::MatrixXd t(pair.receiver_order + 2, pair.source_order + 1);
  t(0, 0) = std::abs(source_step);
  for (int m = 1; m < t.cols(); ++m) t(0, m) = t(0, m - 1) * source_step;
  const Eigen::ArrayXd ratio = receiver_step / Eigen::ArrayXd::LinSpaced(t.rows() - 1, 1, t.rows() - 1);
  for (int m = 0; m < t.cols(); ++m) {
    for (int n = 0; n + 1 < t.rows(); ++n) t(n + 1, m) = t(n, m) * (n + m + 1) * ratio[n];
  }
  return t;
}

// The potential z chi + phi of the source j is measured from its centre z_j. Relative to the centre z_i of
// the receiver it is (z - z_j) chi_j + phi_j = (z - z_i) chi_j + [(z_i - z_j) chi_j + phi_j]. Therefore, with
// offset = z_i - z_j, the radii a_i and a_j and the translation matrix T:
//   alpha = T A,   beta = (a_j/a_i) T B + (offset/a_i) T A
IncomingFlow unit_flows(const Pair& pair, const Eigen::MatrixXd& translation) {
  const int sources = pair.source_order, rows = pair.receiver_order;
  const double radius_ratio = pair.source_radius / pair.receiver_radius;
  IncomingFlow flow{.alpha = Eigen::MatrixXd::Zero(rows + 2, 2 * sources),
                    .beta = Eigen::MatrixXd(rows + 1, 2 * sources)};
  flow.alpha.leftCols(sources) = translation.leftCols(sources);
  flow.beta.leftCols(sources) =
      pair.offset / pair.receiver_radius * translation.topLeftCorner(rows + 1, sources);
  flow.beta.col(1) -= radius_ratio * translation.col(0).head(rows + 1);  // B_0 = -A_1
  flow.beta.rightCols(sources) = radius_ratio * translation.topRightCorner(rows + 1, sources);
  return flow;
}

// The translation matrix T_nm is proportional to |offset|^-(n+m+1), so d T_nm/d offset = -(n+m+1)
// T_nm/offset.
IncomingFlow flow_slopes(const Pair& pair, const Eigen::MatrixXd& translation,
                         const Eigen::MatrixXd& own_flow) {
  const Eigen::MatrixXd& t = translation;
  const Eigen::Index rows = t.rows(), columns = t.cols();
  const Eigen::ArrayXd n = Eigen::ArrayXd::LinSpaced(rows, 0, rows - 1);
  const Eigen::ArrayXd m_plus_1 = Eigen::ArrayXd::LinSpaced(columns, 1, columns);
  const auto slope = [&](const Eigen::MatrixXd& part) -> Eigen::ArrayXXd {
    const Eigen::MatrixXd weighted = (part.array().colwise() * m_plus_1.head(part.rows())).matrix();
    const auto used = t.leftCols(part.rows());
    const Eigen::ArrayXXd by_receiver = (used * part).array().colwise() * n;
    return (by_receiver + (used * weighted).array()) / -pair.offset;
  };
  const Eigen::MatrixXd chi = own_flow.topRows(columns - 1);
  const Eigen::ArrayXXd chi_slope = slope(chi);
  const Eigen::ArrayXXd beta = pair.source_radius * slope(phi_part(own_flow)) + pair.offset * chi_slope +
                               (t.leftCols(columns - 1) * chi).array();
  return {.alpha = chi_slope.matrix(), .beta = (beta.topRows(rows - 1) / pair.receiver_radius).matrix()};
}

Pair Line::pair(int receiver, int source) const {
  return {.receiver_radius = radius[receiver],
          .source_radius = radius[source],
          .offset = position[receiver] - position[source],
          .receiver_order = order[receiver],
          .source_order = order[source]};
}

Line make_line(std::span<const double> radii, std::span<const double> positions, double log_tolerance) {
  Line line{.radius = radii, .position = positions, .order = {}, .start = {0}};
  for (int i = 0; i < line.size(); ++i) {
    line.order.push_back(needed_order(line, i, log_tolerance));
    line.start.push_back(line.start.back() + line.unknowns(i));
  }
  return line;
}

double nearest_bispherical_coordinate(const Line& line, int i) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int j = 0; j < line.size(); ++j) {
    if (j != i) nearest = std::min(nearest, bispherical_coordinate(line, i, j));
  }
  return nearest;
}

}  // namespace beadswim::multipole
