#include "beadswim/theory/question.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/error.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/theory/finite_amplitude.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns the motion in exact Stokes flow; nullopt if beads touch, or if the gap is so small that the
/// multipole series would need too many terms.
std::optional<ExactStokes> exact_stokes(const CollinearSwimmer& swimmer) {
  ExactStokes exact;
  const MobilityFunction mobility = [&](const LinePositions& positions) {
    return exact_mobility(swimmer, positions);
  };
  try {
    exact.mobility = mobility(rest_positions(swimmer));
    exact.motion = second_order_motion(swimmer, exact.mobility);
    exact.amplitude_change = finite_amplitude_change(swimmer, mobility);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const NotFiniteError&) {
    return std::nullopt;
  }
  return exact;
}

}  // namespace

CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance) {
  const MultipoleMobility multipole =
      multipole_mobility(swimmer.radius, positions, swimmer.viscosity, tolerance);
  return {.value = multipole.value, .slope = {multipole.slope[0], multipole.slope[1], multipole.slope[2]}};
}

Question with_exact_reference(Question question) {
  question.exact = exact_stokes(question.swimmer);
  return question;
}

Question with_open_space_motion(Question question) {
  reason_against([&] {
    if (!unsteady_multipole_obstacle(question)) question.inertia = exact_inertia(question);
  });
  reason_against([&] { question.finite = exact_periodic_motion(question.swimmer); });
  return question;
}

std::vector<std::string> warnings(const Question& question, double tolerance) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const PeriodicMotion motion = question.exact
                                    ? question.exact->motion
                                    : second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager));
  const MobilityFunction pair_mobility = [&](const LinePositions& positions) {
    return pairwise_mobility(rotne_prager, swimmer.radius, positions, swimmer.viscosity);
  };
  std::vector<std::string> messages;
  if (!beads_stay_apart(swimmer, motion.stroke)) {
    const std::array<double, 2> gaps = gaps_at_rest(swimmer);
    const double unit = question.units.length;
    messages.push_back(
        fmt::format("beads would touch during the stroke: in first-order theory the arm amplitudes are "
                    "{:.4g} and {:.4g}, but the gaps between the beads at rest are {:.4g} and {:.4g}; lower "
                    "{} or raise {}, {} or {}",
                    motion.stroke.amplitude[0] * unit, motion.stroke.amplitude[1] * unit, gaps[0] * unit,
                    gaps[1] * unit, Setting::amplitude, Setting::stiffness, Setting::damping, Setting::arm));
  }
  const double change =
      question.exact ? question.exact->amplitude_change : finite_amplitude_change(swimmer, pair_mobility);
  if (std::isfinite(change) && std::abs(change) > tolerance) {
    messages.push_back(
        fmt::format("the driving amplitude is not small: closed forms and second-order methods neglect about "
                    "{:+.1f} % of the velocity, more than the tolerance of {:.3g} %; use the methods whose "
                    "names end in -ode, or inertia-corrected, instead",
                    100 * change, 100 * tolerance));
  }
  return messages;
}

}  // namespace beadswim
