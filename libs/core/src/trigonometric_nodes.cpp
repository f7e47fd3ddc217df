#include "beadswim/core/trigonometric_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace beadswim {

double node_phase(int node, int nodes) {
  return 2 * std::numbers::pi * node / nodes;
}

Eigen::MatrixXd differentiation_matrix(int nodes) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nodes, nodes);
  for (int n = 0; n < nodes; ++n) {
    for (int m = 0; m < nodes; ++m) {
      if (n == m) continue;
      const double sign = (n - m) % 2 == 0 ? 1 : -1;
      const double half = node_phase(n - m, nodes) / 2;
      matrix(n, m) = sign / (2 * std::sin(half));
      if (nodes % 2 == 0) matrix(n, m) *= std::cos(half);
    }
  }
  return matrix;
}

std::complex<double> harmonic_amplitude(const Eigen::RowVectorXd& values, int harmonic) {
  const int nodes = static_cast<int>(values.size());
  std::complex<double> sum = 0;
  for (int n = 0; n < nodes; ++n) sum += values[n] * std::polar(1.0, -harmonic * node_phase(n, nodes));
  return 2.0 * sum / static_cast<double>(nodes);
}

NodalValues interpolated(const NodalValues& values, int nodes) {
  NodalValues finer(3, nodes);
  for (int row = 0; row < 3; ++row) {
    finer.row(row).setConstant(values.row(row).mean());
    for (int h = 1; 2 * h < values.cols(); ++h) {
      const std::complex<double> amplitude = harmonic_amplitude(values.row(row), h);
      for (int n = 0; n < nodes; ++n) {
        finer(row, n) += (amplitude * std::polar(1.0, h * node_phase(n, nodes))).real();
      }
    }
  }
  return finer;
}

double unresolved_part(const NodalValues& values) {
  const int highest = static_cast<int>(values.cols() - 1) / 2;
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    for (int h = highest - highest / 4; h <= highest; ++h) {
      largest = std::max(largest, std::abs(harmonic_amplitude(values.row(row), h)));
    }
  }
  return largest / values.cwiseAbs().maxCoeff();
}

}  // namespace beadswim
