#include "beadswim/theory/question.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

ExactStokes exact_stokes(const CollinearSwimmer& swimmer) {
  const MobilityFunction mobility = [&](const LinePositions& positions) {
    return exact_mobility(swimmer, positions);
  };
  ExactStokes exact{.mobility = mobility(rest_positions(swimmer)), .motion = {}};
  exact.motion = second_order_motion(swimmer, exact.mobility);
  exact.amplitude_change = finite_amplitude_change(swimmer, mobility);
  return exact;
}

/// Returns the result in `stored`, which is computed first if it is not there.
template <class T>
const ResultOrError<T>& stored_result(std::optional<ResultOrError<T>>& stored, const auto& compute) {
  if (!stored) stored.emplace(compute);
  return *stored;
}

}  // namespace

CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance) {
  const MultipoleMobility multipole =
      multipole_mobility(swimmer.radius, positions, swimmer.viscosity, tolerance);
  return {.value = multipole.value,
          .slope = {multipole.slope[0], multipole.slope[1], multipole.slope[2]},
          .stresslet = multipole.stresslet,
          .stresslet_slope = multipole.stresslet_slope};
}

Question::Question(TheorySwimmer swimmer, double fluid_density, const UnitScales& units)
    : swimmer_(std::move(swimmer)),
      fluid_density_(fluid_density),
      units_(units),
      motions_(std::make_shared<Motions>()) {}

const ResultOrError<ExactStokes>& Question::exact() const {
  return stored_result(motions_->exact, [&] { return exact_stokes(line()); });
}

const ResultOrError<ExactInertia>& Question::inertia() const {
  return stored_result(motions_->inertia, [&] { return exact_inertia(*this); });
}

const ResultOrError<PeriodicMotion>& Question::finite() const {
  return stored_result(motions_->finite, [&] { return exact_periodic_motion(line()); });
}

const ResultOrError<ShapeReference>& Question::reference() const {
  return stored_result(motions_->reference, [&] { return shape_reference(shape()); });
}

std::vector<std::string> warnings(const Question& question, double tolerance) {
  const CollinearSwimmer& swimmer = question.line();
  const PeriodicMotion motion = question.exact()
                                    ? question.exact()->motion
                                    : second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager));
  const MobilityFunction pair_mobility = [&](const LinePositions& positions) {
    return pairwise_mobility(rotne_prager, swimmer.radius, positions, swimmer.viscosity);
  };
  std::vector<std::string> messages;
  if (!beads_stay_apart(swimmer, motion.stroke)) {
    const std::array<double, 2> gaps = gaps_at_rest(swimmer);
    const double unit = question.units().length;
    messages.push_back(
        fmt::format("beads would touch during the stroke: in first-order theory the arm amplitudes are "
                    "{:.4g} and {:.4g}, but the gaps between the beads at rest are {:.4g} and {:.4g}; lower "
                    "{} or raise {}, {} or {}",
                    motion.stroke.amplitude[0] * unit, motion.stroke.amplitude[1] * unit, gaps[0] * unit,
                    gaps[1] * unit, Setting::amplitude, Setting::stiffness, Setting::damping, Setting::arm));
  }
  const double change =
      question.exact() ? question.exact()->amplitude_change : finite_amplitude_change(swimmer, pair_mobility);
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
