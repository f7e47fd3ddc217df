#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/compare/stroke_fit.hpp"
#include "beadswim/core/background_flow.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/force_dipole.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

// Motion of one swimmer in one cycle of its driving. The arms are the bonds of the swimmer, in order. Their
// lengths are L_i(t) = mean + d_i cos(w t + delta_i), w = 2 pi/T, equation (4.1) of the paper (Pickl et al.
// 2017). See docs/method/stroke-fit.md.

namespace beadswim {

/// Force dipole of a swimmer in the box, the sum of two parts: one is known at each sample, the other as the
/// time integral from the start of the run to the sample.
struct DipoleSample {
  SymmetricTensor present{};   ///< [mass length^2/time^2]
  SymmetricTensor integral{};  ///< [mass length^2/time]

  BEADSWIM_FIELDS(present, integral)
};

/// State of one swimmer at one time.
struct SwimmerSample {
  double time = 0;                   ///< [time]
  std::vector<Vec3> bead_positions;  ///< centres of the beads, unwrapped [length]
  Vec3 mean_flow = Vec3::Zero();     ///< volume average of the velocity of fluid and beads [length/time]
  DipoleSample dipole{};             ///< used by mean_dipole() only

  BEADSWIM_FIELDS(time, bead_positions, mean_flow, dipole)
};

/// Mean quantities and stroke of one period, in the units of the samples and in the frame of the box.
struct CycleStatistics {
  int index = 0;                 ///< number of the cycle, 1 for the first
  Vec3 velocity = Vec3::Zero();  ///< displacement D (swimmers/turning_frame.hpp)/period [length/time]
  /// Unit vector of the mean of the swimmer's axis (axis_of()) in the turning frame, in the middle of the
  /// period
  Vec3 axis = Vec3::UnitX();
  /// Orientation at the end of the period as a unit quaternion w, x, y, z (swimmers/swimmer_shape.hpp), and
  /// the rotation vector from the orientation at its start to this one, whole turns included, divided by the
  /// period [radian/time]; nullopt if unknown
  std::optional<std::array<double, 4>> orientation{};
  std::optional<Vec3> angular_velocity{};
  double speed_along_axis = 0;         ///< component of `velocity` along `axis` [length/time]
  Vec3 mean_flow = Vec3::Zero();       ///< mean flow, averaged over the period [length/time]
  std::vector<double> arm_amplitudes;  ///< d1, d2, ... of equation (4.1) of the paper [length]
  std::vector<double> arm_phases;      ///< delta1, delta2, ... of equation (4.1), in (-pi, pi] [rad]
  std::vector<double> arm_means;       ///< mean arm lengths [length]
  std::optional<double> power;         ///< mean power of the driving [mass length^2/time^3]
  std::optional<double> efficiency;    ///< Lighthill efficiency: drag of the towed swimmer x v^2/power [1]
  std::optional<ForceDipole> dipole;   ///< mean_dipole(); nullopt if unknown

  BEADSWIM_FIELDS((index, not_a_column), velocity, axis, (speed_along_axis, not_a_column), mean_flow,
                  (orientation, omitted_if_none), (angular_velocity, omitted_if_none), arm_amplitudes,
                  arm_phases, arm_means, (power, omitted_if_none),
                  (efficiency, omitted_if_none, not_a_column), (dipole, omitted_if_none))
};

/// Returns the vector along a bond [length], from its first to its second bead.
Vec3 bond_vector(const SwimmerSample& sample, const Bond& bond);

/// Returns the mean over a cycle of the bead positions relative to their mean, in the frame of the type as it
/// turns with the swimmer [length]. Arguments as of cycle_statistics().
BeadVectors mean_shape(std::span<const SwimmerSample> samples, const SwimmerType& type,
                       const Eigen::Matrix3d& initial_orientation);

/// Returns the mean force dipole of a cycle in the frame of the orientation at each time. Arguments as of
/// cycle_statistics().
ForceDipole mean_dipole(std::span<const SwimmerSample> samples, const SwimmerType& type,
                        const Eigen::Matrix3d& initial_orientation);

/// Fits a length that varies with the period of the driving to the samples of one cycle, in order of time.
/// The sample times are also the times in the driving forces, so the fitted phase is relative to the driving.
/// The last sample is omitted, because it has the same phase as the first. Throws InputError as fit_stroke()
/// does.
///   period  [time]
///   length  returns the length in a sample [length]
StrokeFit fit_cycle(std::span<const SwimmerSample> samples, double period,
                    const std::function<double(const SwimmerSample&)>& length);

/// Evaluates the statistics of one cycle from its samples.
///   index    number of the cycle, 1 for the first
///   samples  at least 4, in order of time; the last sample is one period after the first
///   type     type of the swimmer, with its own driving
///   initial_orientation  at the start of the run (swimmers/swimmer_shape.hpp)
///   flow     background flow, in the units of the samples
/// Time averages use the trapezoidal rule over all samples; fit_cycle() gives the stroke. Power, efficiency
/// and dipole are left empty. Throws InputError if the samples do not satisfy the conditions.
CycleStatistics cycle_statistics(int index, std::span<const SwimmerSample> samples, const SwimmerType& type,
                                 const Eigen::Matrix3d& initial_orientation, const BackgroundFlow& flow = {});

/// Returns the swimmer's velocity relative to the fluid [length/time]. The mean flow is subtracted along
/// periodic axes only: along other axes the walls define the frame of reference.
Vec3 vector_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

/// Returns the component of vector_relative_to_fluid() along the swimmer's axis [length/time].
double velocity_relative_to_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

}  // namespace beadswim
