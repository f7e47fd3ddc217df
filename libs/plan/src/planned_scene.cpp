#include "planned_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/plan/reason_against.hpp"
#include "beadswim/scene/reduce.hpp"

namespace beadswim {
namespace {

constexpr double most_growth = 50;  // as an exponent: e^50, no number to speak of

Asked ask(Representative representative) {
  Asked asked{.representative = std::move(representative), .best = {}, .why_not = {}, .lag = {}};
  const Question& question = asked.representative.question;
  const auto driven = asked.representative.type.driving.amplitude;
  const auto seen = question.swimmer.amplitude;
  constexpr double none = 1e-9;
  asked.why_not = reason_against([&] {
    asked.lag.emplace(question);
    if (std::hypot(seen[0], seen[1]) < none * std::hypot(driven[0], driven[1]))
      throw InputError("it is driven across its line alone, which bends it");
    asked.best = best_known(question);
  });
  return asked;
}

/// Departures from the order of a swarm grow by exp(rate cycles). Rates of docs/swarm-stability.md: 0.011
/// with gamma omega/k = 0.59, 0.10 with 3.4; a power law between and beyond.
double growth_of_disorder(const CollinearSwimmer& swimmer, double cycles) {
  const double drag = 6 * std::numbers::pi * swimmer.viscosity * swimmer.radius[1];
  const double softness =
      drag * swimmer.angular_frequency() / std::min(swimmer.stiffness[0], swimmer.stiffness[1]);
  const double rate = 0.011 * std::pow(softness / 0.592, 1.26);
  return std::exp(std::min(most_growth, rate * cycles));
}

/// Forces F along the lab's axes that press a swimmer together turn it, at F sin(tilt)/(6 pi eta a l): over
/// half a period, in which their mean is 2/pi of the amplitude, a tilt grows by the exponential of (2/pi) F
/// T/2 / (6 pi eta a l). The other half takes it back.
double growth_of_tilt(const SwimmerType& type, double viscosity) {
  if (type.driving.frame == DrivingFrame::body) return 1;
  constexpr double pi = std::numbers::pi;
  const double force = std::max(std::abs(type.driving.amplitude[0]), std::abs(type.driving.amplitude[1]));
  const double length = (type.springs[0].rest_length + type.springs[1].rest_length) / 2;
  const double drag = 6 * pi * viscosity * type.beads[1].radius;
  return std::exp(std::min(most_growth, 2 / pi * force * type.driving.period / 2 / (drag * length)));
}

}  // namespace

SceneFacts facts_of(const Layout& layout, double cycles) {
  SceneFacts facts;
  if (layout.domain) {
    constexpr double off_place = 1e-6;  // as beadswim-layout reduce takes it
    ReducedCell reduced = reduce(layout, off_place * smallest_radius(layout));
    facts.cell = std::move(reduced.layout);
    facts.cells = reduced.cells;
  } else {
    facts.cell = layout;
  }
  for (Representative& representative : representatives(facts.cell))
    facts.asked.push_back(ask(std::move(representative)));
  for (Asked& asked : facts.asked)
    asked.turning = growth_of_tilt(asked.representative.type, layout.fluid.dynamic_viscosity());
  if (facts.cell.swimmers.size() > 1) {
    for (const Asked& asked : facts.asked)
      facts.disorder =
          std::max(facts.disorder, growth_of_disorder(asked.representative.question.swimmer, cycles));
  }
  return facts;
}

std::string film_between_beads(const Asked& asked) {
  if (!asked.best) return "theory has no motion for it: " + asked.why_not;
  constexpr double thin = 0.5;  // [radius]
  if (asked.best->nearest >= thin * *std::ranges::min_element(asked.representative.question.swimmer.radius))
    return {};
  return fmt::format(
      "beads come as near as {:.3g} in their stroke, where films between them matter, which mobility models "
      "lack or have badly",
      asked.best->nearest);
}

ErrorEstimate worst(const ErrorEstimate& a, const ErrorEstimate& b) {
  return {.velocity = std::max(a.velocity, b.velocity),
          .arm_amplitudes = {std::max(a.arm_amplitudes[0], b.arm_amplitudes[0]),
                             std::max(a.arm_amplitudes[1], b.arm_amplitudes[1])}};
}

ErrorEstimate times(double factor, ErrorEstimate error) {
  error.velocity *= factor;
  for (double& arm : error.arm_amplitudes) arm *= factor;
  return error;
}

double output_bytes(const RunSettings& settings, std::size_t swimmers, double cells, double bytes_of_cell) {
  constexpr double empty = 3.3e5, of_frame = 60, of_bead = 34,
                   of_flow_cell = 20;  // as files have them [byte]
  const double frames = 1 + settings.cycles * settings.frames_per_cycle;
  double bytes = empty + frames * (of_frame + of_bead * 3 * static_cast<double>(swimmers));
  if (settings.flow_every)
    bytes += std::floor(settings.cycles / *settings.flow_every + 1) * of_flow_cell * cells;
  if (settings.checkpoint_every) bytes += 2 * cells * bytes_of_cell;
  return bytes;
}

}  // namespace beadswim
