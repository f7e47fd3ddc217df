#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/special_functions/sinc.hpp>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/core/dense_systems.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/trigonometric_nodes.hpp"
#include "beadswim/swimmers/hinges.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_flow.hpp"

namespace beadswim {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the springs on the relaxed shape with the stiffness and the damping of all coordinates. The first
/// three free motions are translations along x, y, z, the next ones rotations about `axes`, the last ones
/// deformations that no spring resists. The other deformations are orthonormal, D D^T = 1.
SpringNetwork spring_network(const BeadVectors& shape, const std::vector<Vec3>& axes,
                             const MatrixXd& stiffness, const MatrixXd& damping) {
  const Eigen::Index size = shape.size(), rigid = 3 + std::ssize(axes);
  MatrixXd columns = MatrixXd::Zero(size, size);
  columns.leftCols(rigid) = rigid_motions(shape, axes);
  const MatrixXd deforming = orthonormal_basis(columns).rightCols(size - rigid);
  const SymmetricModes modes(deforming.transpose() * stiffness * deforming);
  constexpr double negligible = 1e-11;
  const Eigen::Index free = (modes.values.array() <= negligible * stiffness.cwiseAbs().maxCoeff()).count();
  SpringNetwork springs;
  springs.free_motions.resize(size, rigid + free);
  springs.free_motions << columns.leftCols(rigid), deforming * modes.vectors.leftCols(free);
  const MatrixXd D = (deforming * modes.vectors.rightCols(size - rigid - free)).transpose();
  springs.deformations = D;
  springs.stiffness = modes.values.tail(D.rows()).asDiagonal();
  springs.damping = D * damping * D.transpose();
  return springs;
}

/// Displacements of the beads at the nodes of a period (columns) and their rates, with the rates of the free
/// motions.
struct Expansion {
  MatrixXd displacement, rate;
  VectorXd free_rates;
};

/// Throws InputError if an angular spring is bent on the relaxed shape, because its stiffness is then not
/// known (own_stiffness()), or if all beads are in line while drives bend hinges (hinges.hpp).
void require_relaxed_angles(const SwimmerType& type, const BeadVectors& shape) {
  constexpr double relaxed = 1e-6;  // [radian], and width of the shape, divided by its length
  const SwimmerType still = with_drives_scaled(type, 0);
  if (has_hinges(type) && !type.driving.angles.empty() &&
      width_of(shape) <= relaxed * shape.colwise().norm().maxCoeff())
    throw InputError(
        "the shape of the swimmer",
        "without drives all beads are in line, where it is undetermined to which side the hinges "
        "bend; use a method at finite amplitude");
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    if (std::abs(bending_of(still, k, 0, shape)) <= relaxed) continue;
    throw InputError("the shape of the swimmer",
                     "without drives, other springs bend angular spring {}, which the second order neglects; "
                     "use a method at finite amplitude, or rest angles that fit the rest lengths",
                     k + 1);
  }
}

/// The expansion of the motion about the relaxed shape (symbols: shaped_swimmer.hpp).
class ShapeExpansion {
 public:
  ShapeExpansion(const ShapedSwimmer& swimmer, const ShapeMobility& law)
      : swimmer_(swimmer),
        law_(law),
        shape_(relaxed_shape({with_drives_scaled(swimmer.type, 0), swimmer.orientation})),
        period_(swimmer.type.driving.period),
        nodes_(std::max(9, 4 * highest_multiple(swimmer.type.driving) + 3)) {
    require_relaxed_angles(swimmer.type, shape_);
    const ShapeFlow flow(swimmer, law);
    flow.require_positive_mobility(shape_);
    mobility_ = law.matrix(shape_);
    const MatrixXd stiffness = own_stiffness<Eigen::Dynamic>(with_drives_scaled(swimmer.type, 0), 0, shape_);
    axes_ = rotation_axes(shape_);
    springs_ = spring_network(shape_, axes_, stiffness, flow.damping(shape_));
  }

  const BeadVectors& shape() const { return shape_; }
  /// Returns the dipole by the mean forces on the relaxed shape, with the springs after a mean change of it.
  Eigen::Matrix3d dipole_of_mean_forces(const VectorXd& change) const {
    const MatrixXd& D = springs_.deformations;
    const ShapeFlow flow(swimmer_, law_);
    VectorXd forces = -D.transpose() * (springs_.stiffness * (D * change));
    for (int m = 0; m < nodes_; ++m) forces += flow.forces(shape_, time(m)) / nodes_;
    return dipole_of_beads(swimmer_, law_, shape_, as_beads(forces));
  }
  int nodes() const { return nodes_; }
  double time(int node) const { return period_ * node / nodes_; }
  const std::vector<Vec3>& axes() const { return axes_; }
  Eigen::Index num_free_deformations() const { return springs_.free_motions.cols() - 3 - std::ssize(axes_); }

  /// Returns the rates of the free motions, and the change of the shape, that balance mean velocities of the
  /// beads.
  MeanBalance balance(const VectorXd& drift) const {
    MeanBalance mean = balance_mean(springs_, mobility_, drift);
    mean.deformation = springs_.deformations.transpose() * mean.deformation;
    return mean;
  }

  Expansion first_order() const {
    MatrixXd drives(shape_.size(), nodes_);
    const ShapeFlow flow(swimmer_, law_);
    for (int m = 0; m < nodes_; ++m) drives.col(m) = flow.forces(shape_, time(m));
    const MeanBalance mean = balance(mobility_ * drives.rowwise().mean());
    Expansion order{.displacement = mean.deformation.replicate(1, nodes_),
                    .rate = MatrixXd::Zero(shape_.size(), nodes_),
                    .free_rates = mean.free_rates};
    const double omega = 2 * std::numbers::pi / period_;
    constexpr double roundoff = 1e-14;
    for (int h = 1; h <= highest_multiple(swimmer_.type.driving); ++h) {
      Eigen::VectorXcd forces(shape_.size());
      for (int k = 0; k < forces.size(); ++k) forces[k] = harmonic_amplitude(drives.row(k), h);
      if (forces.norm() <= roundoff * drives.norm()) continue;
      const Eigen::VectorXcd p = displacement_by(forces, h * omega);
      for (int m = 0; m < nodes_; ++m) {
        const Complex turn = std::polar(1.0, h * node_phase(m, nodes_));
        order.displacement.col(m) += (p * turn).real();
        order.rate.col(m) += (p * (turn * Complex(0, h * omega))).real();
      }
    }
    return order;
  }

  /// Returns FirstOrderMotion::bead_speeds. The largest |Re(v exp(i phi))| of all phases phi is the root of
  /// (|v|^2 + |v.v|)/2, v: complex amplitude of the velocity.
  std::vector<double> bead_speeds(const Expansion& order) const {
    const VectorXd constant = springs_.free_motions * order.free_rates;
    std::vector<double> speeds;
    for (int b = 0; b < shape_.cols(); ++b) {
      double& speed = speeds.emplace_back(constant.segment<3>(3 * b).norm());
      for (int h = 1; h <= highest_multiple(swimmer_.type.driving); ++h) {
        Eigen::Vector3cd v;
        for (int a = 0; a < 3; ++a) v[a] = harmonic_amplitude(order.rate.row(3 * b + a), h);
        speed += std::sqrt((v.squaredNorm() + std::abs(v.cwiseProduct(v).sum())) / 2);
      }
    }
    return speeds;
  }

  /// Returns the bead positions at one node, for s times the first-order motion.
  BeadVectors beads(const Expansion& order, int m, double s) const {
    return shape_ + as_beads(s * order.displacement.col(m));
  }

  /// Bead positions, their velocities in the box, and R, at one node, for s times the first-order motion.
  /// scaled: the swimmer with s times the drives.
  struct Node {
    BeadVectors beads, velocity;
    VectorXd residual;
    Eigen::Matrix3d dipole;  ///< in the frame of the fitted orientation
  };
  Node node(const ShapedSwimmer& scaled, const Expansion& order, int m, double s) const {
    const ShapeFlow flow(scaled, law_);
    const VectorXd rates = s * order.free_rates, p_rate = s * order.rate.col(m);
    Node result{.beads = beads(order, m, s), .velocity = {}, .residual = {}, .dipole = {}};
    Vec3 turning = Vec3::Zero();
    for (std::size_t r = 0; r < axes_.size(); ++r) turning += rates[3 + r] * axes_[r];
    const auto deforming = num_free_deformations();
    result.velocity = as_beads(p_rate + springs_.free_motions.rightCols(deforming) * rates.tail(deforming));
    for (int b = 0; b < result.beads.cols(); ++b)
      result.velocity.col(b) += rates.head<3>() + turning.cross(Vec3(result.beads.col(b)));
    const VectorXd forces = flow.forces(result.beads, time(m)) - flow.damping(result.beads) * p_rate;
    result.residual = as_components(result.velocity) - law_.apply(result.beads, forces);
    result.dipole = dipole_of_beads(swimmer_, law_, result.beads, as_beads(forces));
    return result;
  }

 private:
  /// Returns the complex displacement by oscillating drives. The part of the drives on free motions tows the
  /// swimmer without deforming it.
  Eigen::VectorXcd displacement_by(const Eigen::VectorXcd& forces, double angular_frequency) const {
    const Eigen::VectorXcd towing =
        towing_forces(mobility_, springs_.free_motions) * (springs_.free_motions.transpose() * forces);
    const Eigen::VectorXcd tension = springs_.deformations * (forces - towing);
    return linear_response(springs_, mobility_, tension, angular_frequency).displacement +
           mobility_ * towing / Complex(0, angular_frequency);
  }

  const ShapedSwimmer& swimmer_;
  const ShapeMobility& law_;
  BeadVectors shape_;
  double period_;
  int nodes_;
  MatrixXd mobility_;
  std::vector<Vec3> axes_;
  SpringNetwork springs_;
};

/// Returns the matrix whose rows give the changes of the lengths of the bonds by small displacements of the
/// beads.
MatrixXd bond_rates(const SwimmerType& type, const BeadVectors& shape) {
  MatrixXd rates = MatrixXd::Zero(std::ssize(type.bonds), shape.size());
  for (Eigen::Index k = 0; k < rates.rows(); ++k) {
    const auto [i, j] = type.bonds[k].beads;
    const Vec3 along = (shape.col(j) - shape.col(i)).normalized();
    rates.block<1, 3>(k, 3 * j) = along.transpose();
    rates.block<1, 3>(k, 3 * i) = -along.transpose();
  }
  return rates;
}

/// Returns the amplitudes of the lengths of the bonds at the frequency of the driving.
Stroke stroke_of_bonds(const MatrixXd& rates, const Expansion& order) {
  const MatrixXd lengths = rates * order.displacement;
  Eigen::VectorXcd amplitudes(lengths.rows());
  for (Eigen::Index k = 0; k < lengths.rows(); ++k) amplitudes[k] = harmonic_amplitude(lengths.row(k), 1);
  return stroke_of(amplitudes);
}

/// Returns the even part of the means at +s and -s, divided by s^2, of these quantities: R [length/time],
/// changes of the lengths of the bonds [length], power of the drives [mass length^2/time^3], force dipole
/// [mass length^2/time^2].
VectorXd even_part(const ShapedSwimmer& swimmer, const ShapeExpansion& expansion, const Expansion& order,
                   double s) {
  const VectorXd at_rest = bond_lengths(swimmer.type, expansion.shape());
  const Eigen::Index size = expansion.shape().size();
  VectorXd sum = VectorXd::Zero(size + at_rest.size() + 10);
  for (const double sign : {1.0, -1.0}) {
    ShapedSwimmer scaled = swimmer;
    scaled.type = with_drives_scaled(swimmer.type, sign * s);
    for (int m = 0; m < expansion.nodes(); ++m) {
      const ShapeExpansion::Node node = expansion.node(scaled, order, m, sign * s);
      sum.head(size) += node.residual;
      sum.segment(size, at_rest.size()) += bond_lengths(swimmer.type, node.beads) - at_rest;
      sum.tail<9>() += node.dipole.reshaped();
      sum.tail<10>()[0] +=
          power_of_drives(scaled.type, expansion.time(m), node.beads, node.velocity, swimmer.orientation);
    }
  }
  return sum / (2 * s * s * expansion.nodes());
}

/// Returns the quantities of even_part() to second order in the drives, without the mean change of the shape:
/// extrapolated from three values of s (Richardson).
VectorXd second_order_part(const ShapedSwimmer& swimmer, const ShapeExpansion& expansion,
                           const Expansion& order) {
  constexpr double small_displacement = 0.05;  // relative to the smallest radius
  const double largest = order.displacement.cwiseAbs().maxCoeff();
  const double radius = std::ranges::min(swimmer.type.beads, {}, &Bead::radius).radius;
  const double s = largest > 0 ? small_displacement * radius / largest : 1;
  const auto at = [&](double factor) { return even_part(swimmer, expansion, order, factor * s); };
  return (64.0 * at(0.25) - 20.0 * at(0.5) + at(1)) / 45;
}

/// Returns the mean velocity over a cycle of a frame with the velocity `v` along its own axes, in the
/// orientation of the frame in the middle of the cycle. `turn`: rotation in the cycle [radian].
Vec3 velocity_on_helix(const Vec3& v, const Vec3& turn) {
  const Vec3 axis = turn.stableNormalized(), along = axis.dot(v) * axis;
  return along + boost::math::sinc_pi(turn.norm() / 2) * (v - along);
}

}  // namespace

FirstOrderMotion first_order_motion(const ShapedSwimmer& swimmer, PairTensorLaw law) {
  const ShapeMobility mobility = pair_mobility(swimmer, law);
  const ShapeExpansion expansion(swimmer, mobility);
  const Expansion order = expansion.first_order();
  return {.stroke = stroke_of_bonds(bond_rates(swimmer.type, expansion.shape()), order),
          .bead_speeds = expansion.bead_speeds(order)};
}

std::string second_order_obstacle(const ShapedSwimmer& swimmer) {
  const auto is_constant = [](const ForceDrive& drive) { return drive.constant != 0; };
  const bool is_treated =
      swimmer.flow.is_zero() &&
      !(swimmer.domain.half_space && std::ranges::any_of(swimmer.type.driving.forces, is_constant));
  return is_treated
             ? ""
             : "the flow or the forces: methods of second order treat a swimmer in fluid at rest, over a "
               "wall without constant forces; use a method whose name ends in -ode";
}

ShapeMotion second_order_motion(const ShapedSwimmer& swimmer, const ShapeMobility& mobility) {
  if (const std::string obstacle = second_order_obstacle(swimmer); !obstacle.empty())
    throw InputError(obstacle);
  const ShapeExpansion expansion(swimmer, mobility);
  const Expansion order = expansion.first_order();
  const VectorXd second = second_order_part(swimmer, expansion, order);
  const MeanBalance mean = expansion.balance(-second.head(expansion.shape().size()));
  const VectorXd rates = order.free_rates + mean.free_rates;
  const auto drifting = expansion.num_free_deformations();
  constexpr double negligible = 1e-9;
  if (drifting > 0 && rates.tail(drifting).norm() > negligible * order.rate.cwiseAbs().maxCoeff())
    throw InputError("the shape of the swimmer",
                     "the springs leave a deformation free, and the mean forces of the motion drive it; add "
                     "bonds or angular springs");
  ShapeMotion motion;
  const std::vector<Vec3>& axes = expansion.axes();
  for (std::size_t r = 0; r < axes.size(); ++r) motion.angular_velocity += rates[3 + r] * axes[r];
  motion.velocity_vector =
      velocity_on_helix(rates.head<3>(), swimmer.type.driving.period * motion.angular_velocity);
  motion.axis = swimmer.orientation.col(0);
  motion.velocity = motion.velocity_vector.dot(motion.axis);
  motion.power = second.tail<10>()[0];
  const VectorXd mean_change = order.displacement.rowwise().mean() + mean.deformation;
  motion.mean_shape = expansion.shape() + as_beads(mean_change);
  motion.dipole = dipole_in_frame(Eigen::Matrix3d(second.tail<9>().reshaped(3, 3)) +
                                  expansion.dipole_of_mean_forces(mean_change));
  const MatrixXd rates_of_bonds = bond_rates(swimmer.type, expansion.shape());
  const VectorXd changes = bond_lengths(swimmer.type, expansion.shape()) +
                           second.segment(expansion.shape().size(), rates_of_bonds.rows()) +
                           rates_of_bonds * mean_change;
  for (Eigen::Index k = 0; k < changes.size(); ++k)
    motion.arm_changes.push_back(changes[k] - swimmer.type.bonds[k].rest_length);
  motion.stroke = stroke_of_bonds(rates_of_bonds, order);
  for (int m = 0; m < expansion.nodes(); ++m)
    motion.smallest_gap = std::min(motion.smallest_gap, smallest_gap(swimmer, expansion.beads(order, m, 1)));
  return motion;
}

}  // namespace beadswim
