#pragma once

#include <Eigen/Core>
#include <complex>

// Functions of the phase omega t that are known at M equidistant nodes of a period, M odd, and the
// trigonometric polynomials through them.

namespace beadswim {

/// Three functions (rows) at the nodes (columns).
using NodalValues = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// omega t at a node.
double node_phase(int node, int nodes);

/// d/d(omega t) of the polynomial through the values, at the nodes.
Eigen::MatrixXd differentiation_matrix(int nodes);

/// Complex amplitude of a harmonic, 1 to (M - 1)/2: Re(c exp(i harmonic omega t)).
std::complex<double> harmonic_amplitude(const Eigen::RowVectorXd& values, int harmonic);

/// The same functions at more nodes.
NodalValues interpolated(const NodalValues& values, int nodes);

/// Largest amplitude among the highest quarter of the harmonics, over the largest value.
double unresolved_part(const NodalValues& values);

}  // namespace beadswim
