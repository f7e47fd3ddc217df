#include "beadswim/theory/inertia_corrected.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

using Complex = std::complex<double>;

constexpr double numerical_error = 1e-6;  // relative, of the multipoles at their coarser resolution

/// Returns the flow in unbounded fluid. Keeps the last flow, because plans ask for one swimmer in many boxes.
UnsteadyMultipoles flow_of(const Question& question) {
  struct Known {
    CollinearSwimmer swimmer;
    double fluid_density;
    UnsteadyMultipoles flow;
  };
  thread_local std::optional<Known> last;
  if (!last || last->swimmer != question.swimmer || last->fluid_density != question.fluid_density) {
    const MultipoleResolution resolution = coarser(sufficient_resolution(question.swimmer).value());
    last = {question.swimmer, question.fluid_density,
            unsteady_multipoles(question.swimmer, question.fluid_density, resolution)};
  }
  return last->flow;
}

/// Motion in unbounded fluid, exact to second order in amplitude.
struct OpenMotion {
  LinearResponse response;
  MeanMotion mean;
};

/// Returns the exact motion with the arm amplitudes `arm` in unbounded fluid.
OpenMotion open_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const Eigen::Vector2cd& arm) {
  const LinearResponse response = response_to_stroke(arm, flow.mobility, swimmer.angular_frequency());
  return {.response = response, .mean = mean_motion(flow, swimmer, response)};
}

/// Motion in the box, to second order in amplitude.
struct BoxMotion {
  Eigen::Vector2cd arm;
  double velocity = 0;  ///< [length/time]
};

/// Returns the matrix that maps induced forces to bead velocities, for the exact flow in unbounded fluid.
Eigen::Matrix3cd exact_induced_mobility(const InertialScene& open, const Eigen::Matrix3cd& mobility) {
  Eigen::Matrix3cd impedance = mobility.inverse();
  impedance.diagonal() -= Complex(0, open.swimmer.angular_frequency()) * excess_masses(open).cast<Complex>();
  return impedance.inverse();
}

BoxMotion box_motion(const Question& question, const UnsteadyMultipoles& flow) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const InertialScene open = unbounded_scene(question), boxed = inertial_scene(question);
  const Eigen::Matrix3cd mobility = flow.mobility + unsteady_mobility(boxed) - unsteady_mobility(open);
  const LinearResponse response = linear_response(swimmer, mobility);
  const Eigen::Vector3cd force = induced_forces(open, response);
  const MeanMotion by_beads =
      mean_motion(flow, swimmer, response.displacement, exact_induced_mobility(open, flow.mobility) * force);
  const Eigen::Vector3d by_images = drift_velocities(drift_form(boxed), response.displacement, force) -
                                    drift_velocities(drift_form(open), response.displacement, force);
  const Eigen::Matrix3d steady = question.exact->mobility.value +
                                 rotne_prager_mobility(boxed.flow, swimmer, boxed.positions).value -
                                 rest_mobility(swimmer, rotne_prager).value;
  return {.arm = response.arm,
          .velocity = rigid_force_distribution(steady).dot(by_beads.bead_velocities + by_images)};
}

double root_of_squares(std::initializer_list<double> parts) {
  double sum = 0;
  for (const double part : parts) sum += part * part;
  return std::sqrt(sum);
}

/// Relative errors of interactions by pairs: those of Rotne-Prager pairs in steady flow.
struct PairErrors {
  double velocity;  ///< of the velocity of a given stroke
  double mobility;  ///< largest of the mobilities between two beads
};

PairErrors pair_errors(const Question& question) {
  const CollinearMobility pairs = rest_mobility(question.swimmer, rotne_prager),
                          &exact = question.exact->mobility;
  PairErrors errors{.velocity = std::abs(geometry_factor(pairs) / geometry_factor(exact) - 1), .mobility = 0};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j)
      errors.mobility = std::max(errors.mobility, std::abs(pairs.value(i, j) / exact.value(i, j) - 1));
  }
  return errors;
}

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

/// Returns the relative uncertainties of the changes by the box: the errors of pairs twice, because flow goes
/// from the beads to the images and back, and more for images that are closer than the beads of an arm.
PairErrors box_uncertainty(const Question& question) {
  if (!question.box) return {.velocity = 0, .mobility = 0};
  const double arm = (question.swimmer.arm[0] + question.swimmer.arm[1]) / 2;
  const double factor = 2 * std::max(1.0, std::pow(arm / nearest_image(question.swimmer, *question.box), 3));
  const PairErrors pairs = pair_errors(question);
  return {.velocity = factor * pairs.velocity, .mobility = factor * pairs.mobility};
}

/// Returns the relative uncertainty of the velocity V_R by the Reynolds stress in a box, because V_R is
/// evaluated without images: sum of the arm lengths divided by the shortest edge of the box, at most 1.
/// Returns 0 in open space.
double unknown_share_of_reynolds(const Question& question) {
  if (!question.box) return 0;
  const double narrowest = question.box->box.lengths.minCoeff();
  return std::min(1.0, (question.swimmer.arm[0] + question.swimmer.arm[1]) / narrowest);
}

/// Returns the contributions to the velocity. `open`, `boxed`: motion to second order in open space and in
/// the box.
InertialVelocity velocity_parts(const Question& question, const OpenMotion& open, const BoxMotion& boxed,
                                double amplitude_change) {
  const SecondOrderMotion& second_order = question.exact->motion;
  const double kinematic =
      velocity_of_stroke(open.response.arm, question.exact->mobility, question.swimmer.angular_frequency());
  InertialVelocity v;
  v.quasi_static = second_order.velocity;
  v.by_stroke = kinematic - v.quasi_static;
  v.by_drift = open.mean.by_drift - kinematic;
  v.by_reynolds_stress = open.mean.by_reynolds_stress;
  v.by_box = boxed.velocity - open.mean.velocity();
  const auto& [d1, d2] = second_order.stroke.amplitude;
  const double size = d1 * d2 > 0 ? std::abs(boxed.arm[0] * boxed.arm[1]) / (d1 * d2) : 1;
  v.by_amplitude = amplitude_change * size;

  const double inertial = std::abs(v.by_stroke) + std::abs(v.by_drift) + std::abs(v.by_reynolds_stress);
  const double amplitude_share = v.quasi_static != 0 ? inertial / std::abs(v.quasi_static) : 1;
  v.uncertainty = root_of_squares({box_uncertainty(question).velocity * v.by_box,
                                   unknown_share_of_reynolds(question) * v.by_reynolds_stress,
                                   std::min(1.0, amplitude_share) * v.by_amplitude,
                                   numerical_error * (open.mean.velocity())});
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

InertiaCorrected inertia_corrected(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const UnsteadyMultipoles flow = flow_of(question);
  const OpenMotion open = open_motion(flow, swimmer, driven_arms(swimmer, arm_impedance(flow.mobility)));
  const BoxMotion boxed =
      question.box ? box_motion(question, flow) : BoxMotion{open.response.arm, open.mean.velocity()};
  const PeriodicMotion finite = exact_periodic_motion(swimmer);
  const SecondOrderMotion& small = question.exact->motion;

  InertiaCorrected best;
  best.velocity = velocity_parts(question, open, boxed, finite.velocity - small.velocity);
  for (int arm = 0; arm < 2; ++arm) {
    best.arm_means[arm] = finite.arm_means[arm] + open.mean.arm_changes[arm] - small.arm_changes[arm];
  }
  // Relative uncertainties of the arm amplitudes: the change by the box has the error of pairs, the change by
  // finite amplitude is that without inertia.
  std::array<double, 2> uncertainty{};
  for (int arm = 0; arm < 2; ++arm) {
    const Complex steady = complex_of(small.stroke, arm), y = boxed.arm[arm];
    const Complex growth = small.stroke.amplitude[arm] > 0 ? complex_of(finite.stroke, arm) / steady : 1;
    best.arm[arm] = y * growth;
    const double size = std::abs(y);
    const double by_box = size > 0 ? std::abs(y - open.response.arm[arm]) / size : 0;
    const double by_inertia = size > 0 ? std::abs(open.response.arm[arm] - steady) / size : 0;
    uncertainty[arm] =
        root_of_squares({by_box * box_uncertainty(question).mobility,
                         std::min(1.0, by_inertia) * std::abs(growth - 1.0), size > 0 ? numerical_error : 0});
  }
  best.amplitude_uncertainty = uncertainty;
  best.sin_uncertainty = sin_uncertainty(best.arm, uncertainty[0] + uncertainty[1]);
  return best;
}

}  // namespace beadswim
