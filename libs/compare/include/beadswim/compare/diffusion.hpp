#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// Diffusion of swimmers in a run with thermal noise, by the displacements and rotations in windows of time
// that do not overlap, of all swimmers:
//
//   V = <dR>/tau,   D = <|dR|^2>/(6 tau),   D_r = ln(C(t)/C(2 t))/(2 t),   C(t) = <e(0).e(t)>
//
//   dR   displacement of a swimmer in a window of length tau: a 20th of all time, or ten persistence times
//        1/(2 D_r) if this is less
//   e    its axis;  t: a thousandth of all time; C(t)/C(2 t) does not contain fast changes of the shape
//
// D contains the motion of the swimmer along its axis where tau is longer than the persistence time:
// D = D_0 + v^2/(6 D_r). Standard errors are those of the mean of independent windows.

namespace beadswim {

/// Places [length] and axes of a swimmer at equidistant times.
struct SwimmerPath {
  std::vector<Vec3> places, axes;

  /// Appends the mean place of the beads, and the axis that the swimmer has there.
  void append(const SwimmerType& type, std::span<const Vec3> beads,
              const Eigen::Matrix3d& initial_orientation);

  BEADSWIM_FIELDS(places, axes)
};

/// A mean, and the standard error of it.
template <class Value>
struct MeanAndError {
  Value mean{};
  Value standard_error{};

  BEADSWIM_FIELDS(mean, standard_error)
};

/// Returns the mean of independent numbers; its error is NaN for fewer than two.
MeanAndError<double> mean_with_error(std::span<const double> numbers);

/// Without values for paths of fewer than two intervals.
struct DiffusionStatistics {
  std::optional<double> lag{};                        ///< tau [time]
  std::optional<MeanAndError<Vec3>> mean_velocity{};  ///< [length/time]
  /// D [length^2/time]; nullopt: fewer than 10 windows
  std::optional<MeanAndError<double>> effective_diffusion{};
  std::optional<MeanAndError<double>> rotational_diffusion{};  ///< D_r [1/time]; nullopt: axes turn too fast
  std::optional<MeanAndError<double>> persistence_time{};      ///< [time]

  BEADSWIM_FIELDS((lag, omitted_if_none), (mean_velocity, omitted_if_none),
                  (effective_diffusion, omitted_if_none), (rotational_diffusion, omitted_if_none),
                  (persistence_time, omitted_if_none))
};

/// Means over windows of `intervals` intervals that do not overlap, of all paths.
struct DisplacementStatistics {
  MeanAndError<double> square;  ///< <|dR|^2> [length^2]
  MeanAndError<double> cosine;  ///< <e(t) . e(t + tau)>
};

/// Returns the means of paths that are longer than `intervals`.
DisplacementStatistics displacement_statistics(std::span<const SwimmerPath> paths, std::size_t intervals);

/// Returns the statistics of paths of equal length. `interval`: between times of the paths [time].
DiffusionStatistics diffusion_statistics(std::span<const SwimmerPath> paths, double interval);

}  // namespace beadswim
