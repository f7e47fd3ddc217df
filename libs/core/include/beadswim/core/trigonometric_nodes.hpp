#pragma once

#include <Eigen/Core>
#include <complex>

// Trigonometric interpolation of functions of the phase omega t. A period has M equidistant nodes, M odd
// unless a function allows any M.

namespace beadswim {

/// Values of three functions of the phase omega t (rows) at the nodes of a period (columns).
using NodalValues = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Returns the phase omega t at `node` = 0 .. `nodes` - 1 of a period [rad].
double node_phase(int node, int nodes);

/// Returns the matrix (nodes x nodes) that maps the values of a function at the nodes to the derivative of
/// their trigonometric polynomial with respect to omega t at the nodes. `nodes`: even or odd.
Eigen::MatrixXd differentiation_matrix(int nodes);

/// Returns the complex amplitude c of the harmonic Re(c exp(i h omega t)) of the function with the given
/// values at M nodes. h = `harmonic` is from 1 to (M - 1)/2.
std::complex<double> harmonic_amplitude(const Eigen::RowVectorXd& values, int harmonic);

/// Returns the values at `nodes` equidistant nodes of the trigonometric polynomials through `values`.
NodalValues interpolated(const NodalValues& values, int nodes);

/// Returns the largest amplitude among the highest quarter of the harmonics, divided by the largest absolute
/// value. A small result means that the number of nodes suffices.
double unresolved_part(const NodalValues& values);

}  // namespace beadswim
