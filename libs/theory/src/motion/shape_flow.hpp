#pragma once

#include <Eigen/Core>

#include "beadswim/theory/shaped_swimmer.hpp"

// Velocities, forces and matrices of the beads of a swimmer (symbols: shaped_swimmer.hpp). Vectors and
// matrices have the components x, y, z of bead 1, then of bead 2, and so on. Positions are relative to
// ShapedSwimmer::place.

namespace beadswim {

/// Returns the axes about which a rotation moves the beads: three, two for beads on a line, none for one
/// bead. `shape`: relative to the point on the axes.
std::vector<Vec3> rotation_axes(const BeadVectors& shape);

/// Returns the velocities of the beads, one column per motion: translations along x, y, z at unit speed, then
/// rotations about `axes` at unit rate.
Eigen::MatrixXd rigid_motions(const BeadVectors& shape, const std::vector<Vec3>& axes);

inline auto as_components(const BeadVectors& beads) {
  return Eigen::Map<const Eigen::VectorXd>(beads.data(), beads.size());
}

inline BeadVectors as_beads(const Eigen::VectorXd& components) {
  return Eigen::Map<const Eigen::Matrix3Xd>(components.data(), 3, components.size() / 3);
}

/// Returns the type with all drives multiplied by `factor`.
SwimmerType with_drives_scaled(SwimmerType type, double factor);

/// Returns the number of the highest harmonic of the drives, at least 1.
int highest_multiple(const Driving& driving);

/// Returns the smallest gap between the surfaces of two beads, or of a bead and the wall; infinity if there
/// is neither [length].
double smallest_gap(const ShapedSwimmer& swimmer, const BeadVectors& beads);

/// Returns the lengths of the bonds [length].
Eigen::VectorXd bond_lengths(const SwimmerType& type, const BeadVectors& beads);

/// Moves the beads so that their mean is the origin.
BeadVectors centred(const BeadVectors& beads);

/// Returns the rotation that fits `from` to `to` best after a translation.
Eigen::Matrix3d best_rotation(const BeadVectors& from, const BeadVectors& to);

/// Returns the force dipole in the frame of the fitted orientation. `forces`: on the beads.
Eigen::Matrix3d dipole_of_beads(const ShapedSwimmer& swimmer, const ShapeMobility& mobility,
                                const BeadVectors& beads, const BeadVectors& forces);

class ShapeFlow {
 public:
  ShapeFlow(const ShapedSwimmer& swimmer, const ShapeMobility& mobility);

  /// Throws InputError if mu is not positive definite.
  void require_positive_mobility(const BeadVectors& beads) const;

  Eigen::MatrixXd damping(const BeadVectors& beads) const;                  ///< C
  Eigen::VectorXd forces(const BeadVectors& beads, double time) const;      ///< F
  Eigen::VectorXd velocities(const BeadVectors& beads, double time) const;  ///< v

  /// Returns -(1 + mu C)^-1 mu K, the derivative of v by x without that of mu [1/time], with the estimate of
  /// mu. K: stiffness of the springs.
  Eigen::MatrixXd relaxation(const BeadVectors& beads, double time) const;

 private:
  const ShapedSwimmer& swimmer_;
  const ShapeMobility& mobility_;
  bool is_damped_ = false;
};

}  // namespace beadswim
