#pragma once

#include <Eigen/Core>
#include <complex>

// Trigonometric interpolation of functions of the phase omega t. A period has M equidistant nodes, M odd.

namespace beadswim {

/// Values of three functions (rows) at the nodes (columns).
using NodalValues = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Returns omega t at a node [rad].
double node_phase(int node, int nodes);

/// Returns the matrix that maps values at the nodes to the derivative of their trigonometric polynomial with
/// respect to omega t at the nodes.
Eigen::MatrixXd differentiation_matrix(int nodes);

/// Returns the complex amplitude c of the harmonic Re(c exp(i `harmonic` omega t)), with `harmonic` from 1 to
/// (M - 1)/2.
std::complex<double> harmonic_amplitude(const Eigen::RowVectorXd& values, int harmonic);

/// Returns the trigonometric polynomials through `values`, evaluated at `nodes` equidistant nodes.
NodalValues interpolated(const NodalValues& values, int nodes);

/// Returns the largest amplitude among the highest quarter of the harmonics, divided by the largest value.
double unresolved_part(const NodalValues& values);

}  // namespace beadswim
