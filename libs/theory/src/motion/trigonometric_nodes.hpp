#pragma once

#include <Eigen/Core>
#include <complex>

// Trigonometric interpolation of functions of the phase omega t through M equidistant nodes of a period, M
// odd.

namespace beadswim {

/// Values of three functions (rows) at the nodes (columns).
using NodalValues = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Returns omega t at a node [rad].
double node_phase(int node, int nodes);

/// Returns the matrix that maps values at the nodes to d/d(omega t) of their polynomial at the nodes.
Eigen::MatrixXd differentiation_matrix(int nodes);

/// Returns the complex amplitude c of a harmonic, from 1 to (M - 1)/2: Re(c exp(i harmonic omega t)).
std::complex<double> harmonic_amplitude(const Eigen::RowVectorXd& values, int harmonic);

/// Returns the polynomials through `values`, evaluated at `nodes` nodes.
NodalValues interpolated(const NodalValues& values, int nodes);

/// Returns the largest amplitude among the highest quarter of the harmonics, divided by the largest value.
double unresolved_part(const NodalValues& values);

}  // namespace beadswim
