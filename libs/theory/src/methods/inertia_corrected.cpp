#include "beadswim/theory/inertia_corrected.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/reynolds_stress.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns the shortest distance between the centre of a bead and of an image of a bead in the box [length].
double nearest_image(const CollinearSwimmer& swimmer, const BoxPlace& place) {
  const auto& [box, middle] = place;
  double nearest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double before = middle[axis] - (axis == 0 ? swimmer.arm[0] : 0);
    const double after = box.lengths[axis] - middle[axis] - (axis == 0 ? swimmer.arm[1] : 0);
    nearest = std::min(nearest, box.has_mirrors(axis) ? 2 * std::min(before, after) : before + after);
  }
  return nearest;
}

/// Returns C_exact/C_RP, the geometry factors of the swimmer in open space by exact and by Rotne-Prager
/// mobilities: the factor by which finite beads weaken the flow between them, compared with pairs. Returns 1
/// where the two differ by half or more.
double weakening_by_beads(const Question& question) {
  const double pairs = geometry_factor(rest_mobility(question.line(), rotne_prager));
  const double ratio = geometry_factor(question.exact()->mobility) / pairs;
  return std::abs(ratio - 1) < 0.5 ? ratio : 1;
}

/// Relative uncertainties of the changes by the box.
struct BoxUncertainty {
  double images = 0;    ///< of the change of the velocity of a given stroke
  double mobility = 0;  ///< of the change of the stroke
};

/// Returns the uncertainties of the changes by the box, more for images that are closer than the beads of an
/// arm. That of the velocity is the change by weakening_by_beads(), which is a measured law, not an exact
/// one. That of the stroke is the error of the Rotne-Prager mobilities between two beads, twice, because flow
/// goes from the beads to the images and back.
BoxUncertainty box_uncertainty(const Question& question) {
  if (!question.surroundings.box) return {};
  const CollinearMobility pairs = rest_mobility(question.line(), rotne_prager),
                          &exact = question.exact()->mobility;
  double mobility = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j)
      mobility = std::max(mobility, std::abs(pairs.value(i, j) / exact.value(i, j) - 1));
  }
  const double velocity = std::abs(geometry_factor(pairs) / geometry_factor(exact) - 1);
  const double arm = (question.line().arm[0] + question.line().arm[1]) / 2;
  const double closeness =
      std::max(1.0, std::pow(arm / nearest_image(question.line(), *question.surroundings.box), 3));
  return {.images = closeness * std::max(velocity, mobility), .mobility = 2 * closeness * mobility};
}

/// Change of the swimmer's velocity because images contribute to the Reynolds stress, and the part of its
/// uncertainty that is not due to the approximation by pairs [length/time].
struct ImageStress {
  double change = 0, uncertainty = 0;
};

/// Returns the change for the induced forces `force` and the forces `towing` that tow the swimmer in the box.
/// In a large box the change is left out. Its uncertainty is then the length of both arms, divided by the
/// distance of the nearest image, times the velocity by the Reynolds stress in open space, `exact`.
ImageStress image_stress(const Question& question, const Eigen::Vector3d& towing,
                         const Eigen::Vector3cd& force, double exact) {
  const CollinearSwimmer& swimmer = question.line();
  const auto in_box =
      reynolds_velocities_in_box(swimmer, question.fluid_density(), *question.surroundings.box, force);
  if (!in_box) {
    const double share =
        (swimmer.arm[0] + swimmer.arm[1]) / nearest_image(swimmer, *question.surroundings.box);
    return {.change = 0, .uncertainty = share * std::abs(exact)};
  }
  constexpr double mesh = 0.04;  // relative error of reynolds_velocities_in_box()
  const double boxed = towing.dot(*in_box);
  const double open =
      reynolds_stress_velocity(reynolds_stress_form(swimmer, question.fluid_density(), towing).total, force);
  return {.change = boxed - open, .uncertainty = mesh * std::abs(boxed)};
}

/// Motion in the box, to second order in amplitude, with the changes of the velocity by the box
/// [length/time].
struct BoxMotion {
  Eigen::Vector2cd arm;
  double velocity = 0;         ///< [length/time]
  double by_stroke = 0;        ///< because the box changes the stroke
  double by_drift = 0;         ///< of this stroke, by drift in the flow of images
  ImageStress by_stress = {};  ///< of this stroke, by the Reynolds stress of images
};

BoxMotion box_motion(const Question& question, const ExactInertia& exact) {
  const CollinearSwimmer& swimmer = question.line();
  const UnsteadyMultipoles& flow = exact.flow;
  const InertialScene open = unbounded_scene(question), boxed = inertial_scene(question);
  const Eigen::Matrix3cd mobility = flow.mobility + unsteady_mobility(boxed) - unsteady_mobility(open);
  const LinearResponse response = linear_response(swimmer, mobility);
  const Eigen::Vector3cd force = induced_forces(open, response);
  const MeanMotion by_beads =
      mean_motion(flow, swimmer, response.displacement, flow.induced_mobility * force);
  const Eigen::Vector3d by_images = drift_velocities(drift_form(boxed), response.displacement, force) -
                                    drift_velocities(drift_form(open), response.displacement, force);
  const Eigen::Matrix3d steady = question.exact()->mobility.value +
                                 rotne_prager_mobility(boxed.flow, swimmer, boxed.positions).value -
                                 rest_mobility(swimmer, rotne_prager).value;
  const Eigen::Vector3d towing = towing_forces(steady);
  const ImageStress stress = image_stress(question, towing, force, by_beads.by_reynolds_stress);
  const double velocity =
      towing.dot(by_beads.bead_velocities + weakening_by_beads(question) * by_images) + stress.change;
  const double with_stroke =
      mean_motion(flow, swimmer,
                  response_to_stroke(arm_rates(), response.arm, flow.mobility, swimmer.angular_frequency()))
          .velocity();
  return {.arm = response.arm,
          .velocity = velocity,
          .by_stroke = with_stroke - exact.motion.mean.velocity(),
          .by_drift = velocity - with_stroke - stress.change,
          .by_stress = stress};
}

/// Returns |x_1 x_2|/(d_1 d_2): the size of the stroke x = `arm`, relative to that of exact Stokes flow.
double relative_stroke(const Question& question, const Eigen::Vector2cd& arm) {
  const double area =
      question.exact()->motion.stroke.amplitude[0] * question.exact()->motion.stroke.amplitude[1];
  return area > 0 ? std::abs(arm[0] * arm[1]) / area : 1;
}

double root_of_squares(std::initializer_list<double> parts) {
  double sum = 0;
  for (const double part : parts) sum += part * part;
  return std::sqrt(sum);
}

/// Returns the contributions to the velocity. `open`, `boxed`: motion to second order in open space and in
/// the box; `finite`: motion at finite amplitude without inertia.
InertialVelocity velocity_parts(const Question& question, const ExactMotion& open, const BoxMotion& boxed,
                                const PeriodicMotion& finite, const BoxUncertainty& by_box) {
  const double kinematic =
      velocity_of_stroke(open.response.arm, question.exact()->mobility, question.line().angular_frequency());
  InertialVelocity v;
  v.quasi_static = question.exact()->motion.velocity;
  v.by_stroke = kinematic - v.quasi_static;
  v.by_drift = open.mean.by_drift - kinematic;
  v.by_reynolds_stress = open.mean.by_reynolds_stress;
  v.by_box = boxed.velocity - open.mean.velocity();
  const double size = relative_stroke(question, boxed.arm);
  v.by_amplitude = (finite.velocity - v.quasi_static) * size * size;
  // The law of weakening_by_beads() scatters by `scatter` of the velocity in boxes that change it by a tenth
  // or more (docs/stated-uncertainty.md).
  constexpr double scatter = 0.04, tenth = 0.1;
  const double gross =
      std::abs(boxed.by_stroke) + std::abs(boxed.by_drift) + std::abs(boxed.by_stress.change);
  v.uncertainty = root_of_squares({by_box.mobility * boxed.by_stroke, by_box.images * boxed.by_drift,
                                   by_box.images * boxed.by_stress.change, boxed.by_stress.uncertainty,
                                   scatter * std::min(std::abs(v.sum()), gross / tenth),
                                   amplitude_uncertainty(question, open, v.by_amplitude)});
  return v;
}

Complex complex_of(const Stroke& stroke, int arm) {
  return std::polar(stroke.amplitude[arm], stroke.phase[arm]);
}

/// Returns an upper bound of the error of sin(delta_1 - delta_2) for the complex arm amplitudes y, whose
/// ratio has the relative error `relative_error`.
double sin_uncertainty(const Eigen::Vector2cd& y, double relative_error) {
  if (y[0] == 0.0 || y[1] == 0.0) return 0;
  const Complex shift = y[0] / y[1];
  return std::abs(shift.real() / std::abs(shift)) * relative_error + relative_error * relative_error / 2;
}

}  // namespace

ExactInertia exact_inertia(const Question& question) {
  const CollinearSwimmer& swimmer = question.line();
  if (const std::string obstacle = unsteady_multipole_obstacle(question); !obstacle.empty())
    throw InputError(obstacle);
  const MultipoleResolution resolution = *sufficient_resolution(swimmer);
  const auto flow_at = [&](const MultipoleResolution& multipoles) {
    return unsteady_multipoles(swimmer, question.fluid_density(), multipoles);
  };
  const UnsteadyMultipoles flow = flow_at(resolution);
  const ExactMotion motion = exact_motion(flow, swimmer);
  const MeanMotion fine = motion.mean, coarse = exact_motion(flow_at(coarser(resolution)), swimmer).mean;
  constexpr double roundoff = 1e-12;  // drift and Reynolds stress may cancel
  return {.flow = flow,
          .motion = motion,
          .numerical_error = std::abs(coarse.by_drift - fine.by_drift) +
                             std::abs(coarse.by_reynolds_stress - fine.by_reynolds_stress) +
                             roundoff * (std::abs(fine.by_drift) + std::abs(fine.by_reynolds_stress))};
}

double amplitude_uncertainty(const Question& question, const ExactMotion& motion, double by_amplitude) {
  const auto& [response, mean] = motion;
  const CollinearSwimmer& swimmer = question.line();
  const double omega = swimmer.angular_frequency(), nu = swimmer.viscosity / question.fluid_density();
  const double quasi_static = question.exact()->motion.velocity;
  const double kinematic = velocity_of_stroke(response.arm, question.exact()->mobility, omega);
  const double inertial = std::abs(kinematic - quasi_static) + std::abs(mean.by_drift - kinematic) +
                          std::abs(mean.by_reynolds_stress);
  const double share = quasi_static != 0 ? std::min(1.0, inertial / std::abs(quasi_static)) : 1;
  const double strain =
      std::max(std::abs(response.arm[0]) / swimmer.arm[0], std::abs(response.arm[1]) / swimmer.arm[1]);
  const double reynolds = std::pow(omega * response.displacement.cwiseAbs().maxCoeff(), 2) / (omega * nu);
  return share * std::abs(by_amplitude) + std::max(strain * strain, reynolds) * inertial;
}

InertiaCorrected inertia_corrected(const Question& question) {
  const CollinearSwimmer& swimmer = question.line();
  const ExactInertia& exact = *question.inertia();
  const ExactMotion& open = exact.motion;
  const BoxMotion boxed = question.surroundings.box
                              ? box_motion(question, exact)
                              : BoxMotion{.arm = open.response.arm, .velocity = open.mean.velocity()};
  const PeriodicMotion& finite = *question.finite();
  const PeriodicMotion& small = question.exact()->motion;
  const BoxUncertainty by_pairs = box_uncertainty(question);

  InertiaCorrected best;
  best.velocity = velocity_parts(question, open, boxed, finite, by_pairs);
  best.velocity.uncertainty += exact.numerical_error;
  const double size = relative_stroke(question, boxed.arm);
  // Relative uncertainties of the arm amplitudes: the change by the box has the error of pairs, the change by
  // finite amplitude is that without inertia.
  for (int arm = 0; arm < 2; ++arm) {
    const Complex steady = complex_of(small.stroke, arm), y = boxed.arm[arm];
    const Complex growth =
        small.stroke.amplitude[arm] > 0 ? size * (complex_of(finite.stroke, arm) / steady - 1.0) : 0;
    best.arm[arm] = y * (1.0 + growth);
    best.arm_means[arm] = swimmer.arm[arm] + open.mean.arm_changes[arm] +
                          size * size * (finite.arm_changes[arm] - small.arm_changes[arm]);
    if (y == 0.0) continue;
    const double by_box = std::abs(y - open.response.arm[arm]) / std::abs(y),
                 by_inertia = std::min(1.0, std::abs(open.response.arm[arm] - steady) / std::abs(y));
    best.amplitude_uncertainty[arm] =
        std::hypot(by_box * by_pairs.mobility,
                   by_inertia * (std::abs(growth) + std::norm(y) / std::pow(swimmer.arm[arm], 2)));
  }
  best.sin_uncertainty =
      sin_uncertainty(best.arm, best.amplitude_uncertainty[0] + best.amplitude_uncertainty[1]);
  return best;
}

}  // namespace beadswim
