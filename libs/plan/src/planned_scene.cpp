#include "planned_scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/reduce.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double max_growth_exponent = 50;  // e^50 stands for unbounded growth

/// Returns the factor by which a small tilt of the axis against the driving forces grows in half a period.
/// Driving forces along fixed axes turn the axis while they compress the swimmer. The mean of the force F
/// over half a period is 2/pi of its amplitude F_max:
///
///   rate of the tilt = F sin(tilt) / (6 pi eta a l)
///   growth           = exp((2/pi) F_max (T/2) / (6 pi eta a l))
///
/// a: bead radius, l: arm length [length]. eta: dynamic viscosity [mass/(length time)]. T: period [time]. In
/// the other half period, the forces extend the swimmer and the tilt decreases again.
double growth_of_tilt(const ThreeBeadSwimmer& type, double viscosity) {
  if (type.driving.frame == DrivingFrame::body) return 1;
  constexpr double pi = std::numbers::pi;
  const double force = std::max(std::abs(type.driving.amplitude[0]), std::abs(type.driving.amplitude[1]));
  const double length = (type.springs[0].rest_length + type.springs[1].rest_length) / 2;
  const double drag = 6 * pi * viscosity * type.beads[1].radius;
  return std::exp(std::min(max_growth_exponent, 2 / pi * force * type.driving.period / 2 / (drag * length)));
}

SwimmerFacts evaluate_swimmer(Representative representative) {
  SwimmerFacts swimmer_facts{
      .representative = std::move(representative), .best = {}, .obstacle = {}, .lag = {}};
  const Question& question = swimmer_facts.representative.question;
  swimmer_facts.tilt_growth = growth_of_tilt(swimmer_facts.representative.type, question.line().viscosity);
  const auto driven = swimmer_facts.representative.type.driving.amplitude;
  const auto axial_amplitude = question.line().amplitude;
  constexpr double negligible = 1e-9;
  swimmer_facts.obstacle = reason_against([&] {
    swimmer_facts.lag.emplace(question);
    if (std::hypot(axial_amplitude[0], axial_amplitude[1]) < negligible * std::hypot(driven[0], driven[1]))
      throw InputError(
          "the driving forces are perpendicular to the swimmer's axis and only bend the swimmer, without a "
          "stroke along the axis");
    swimmer_facts.best = best_prediction(question);
  });
  return swimmer_facts;
}

/// Returns true if a swimmer and its periodic image would overlap along its axis.
bool exceeds_box(const Representative& swimmer, const Layout& cell) {
  const auto placed = std::ranges::find(cell.swimmers, swimmer.swimmer, &Swimmer::id);
  double length = swimmer.type.beads[0].radius + swimmer.type.beads[2].radius;
  for (const Spring& arm : swimmer.type.springs) length += arm.rest_length;
  return (length * placed->orientation().col(0).cwiseAbs().array() >= cell.domain.box->lengths.array()).any();
}

/// Returns the facts of all representatives of the cell. A box can leave too little room for a stand-in,
/// which may be longer than the swimmer itself; its facts are then those in open space.
std::vector<SwimmerFacts> evaluate_swimmers(const Layout& cell) {
  std::vector<SwimmerFacts> all;
  for (Representative& representative : representatives(cell))
    all.push_back(evaluate_swimmer(std::move(representative)));
  if (!cell.domain.box) return all;
  const auto is_misfit = [&](const SwimmerFacts& facts) {
    return facts.representative.is_stand_in && (!facts.best || exceeds_box(facts.representative, cell));
  };
  if (std::ranges::none_of(all, is_misfit)) return all;
  Layout open = cell;
  open.domain.box.reset();
  std::vector<SwimmerFacts> others = evaluate_swimmers(open);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_misfit(all[i]) || !others[i].best) continue;
    all[i] = std::move(others[i]);
    std::string& approximation = all[i].representative.approximation;
    if (approximation.empty()) approximation = "alone in open space";
  }
  return all;
}

/// Returns the changes of velocity and arm amplitudes by the box, the largest of all swimmers.
MotionValues changes_by_box(const std::vector<SwimmerFacts>& all) {
  MotionValues changes = MotionValues::Zero();
  for (const SwimmerFacts& swimmer_facts : all) {
    Question open = swimmer_facts.representative.question;
    if (!open.surroundings.box || !swimmer_facts.best) continue;
    open.surroundings.box.reset();
    changes = changes.max(difference(best_prediction(open).motion, *swimmer_facts.best));
  }
  return changes;
}

/// Returns exp(rate cycles), the factor by which deviations from the order of a swarm grow in `cycles`
/// cycles. The rate [1/cycle] is a power law of gamma omega/k, where gamma is the drag coefficient of a bead,
/// omega the driving frequency and k the stiffness. docs/results/stability.sh measured 0.011 at gamma omega/k
/// = 0.59 and 0.10 at 3.4 (docs/swarm-stability.md); between them, at 1.18, it measured 0.026, as the law.
double growth_of_disorder(const CollinearSwimmer& swimmer, double cycles) {
  const double drag = 6 * std::numbers::pi * swimmer.viscosity * swimmer.radius[1];
  const double softness =
      drag * swimmer.angular_frequency() / std::min(swimmer.stiffness[0], swimmer.stiffness[1]);
  const double rate = 0.011 * std::pow(softness / 0.592, 1.26);
  return std::exp(std::min(max_growth_exponent, rate * cycles));
}

}  // namespace

SceneFacts scene_facts(const Layout& in_layout_units, double cycles) {
  SceneFacts facts;
  facts.units = natural_units(in_layout_units);
  const Layout layout = in_units(in_layout_units, facts.units);
  for (const auto& [name, type] : layout.types)
    if (!three_bead_form(type)) facts.unvalidated = name;
  if (layout.domain.box) {
    constexpr double off_place = 1e-6;  // relative to the smallest radius, as in beadswim-layout reduce
    ReducedCell reduced = reduce(layout, off_place * smallest_radius(layout));
    facts.cell = std::move(reduced.layout);
    facts.cells = reduced.cells;
  } else {
    facts.cell = layout;
  }
  if (const auto& half_space = layout.domain.half_space)
    facts.height = smallest_relative_height(placed_beads(layout), *half_space);
  facts.swimmer_facts = evaluate_swimmers(facts.cell);
  facts.box_changes = changes_by_box(facts.swimmer_facts);
  if (facts.cell.swimmers.size() > 1) {
    for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts)
      facts.disorder_growth = std::max(
          facts.disorder_growth, growth_of_disorder(swimmer_facts.representative.question.line(), cycles));
  }
  return facts;
}

std::string film_obstacle(const SwimmerFacts& swimmer_facts) {
  if (!swimmer_facts.best) return "theory cannot predict the motion: " + swimmer_facts.obstacle;
  if (swimmer_facts.representative.is_stand_in) return {};  // its gaps are not those of the swimmer
  constexpr double thin = 0.5;  // at smaller gaps, docs/results/hard-shapes.sh found errors up to 300 %
  const double gap = swimmer_facts.best->smallest_stroke_gap /
                     *std::ranges::min_element(swimmer_facts.representative.question.line().radius);
  if (gap >= thin) return {};
  return fmt::format(
      "the smallest gap between beads in the stroke is {:.3g} bead radii, where lubrication matters; "
      "mobility models lack lubrication or approximate it poorly",
      gap);
}

void complete_cost(PlannedRun& run, std::size_t beads, double cells, int ranks) {
  // Each of some 20 data sets begins with 16 KiB. A frame has 17 numbers, and for each bead position, image
  // and velocity; the flow has the velocity, the pressure and the number of the bead in each cell.
  constexpr double empty = 20 * 16384, bytes_per_frame = 17 * 8, bytes_per_bead = 9 * 4,
                   bytes_per_flow_cell = 5 * 4;  // [byte]
  const RunSettings& settings = run.settings;
  const double frames = 1 + settings.cycles * settings.frames_per_cycle;
  run.output_bytes = empty + frames * (bytes_per_frame + bytes_per_bead * static_cast<double>(beads));
  if (settings.flow_every)  // on all cells; smaller grids count for little
    run.output_bytes += std::floor(settings.cycles / *settings.flow_every + 1) * bytes_per_flow_cell * cells;
  if (settings.checkpoint_every && cells > 0) run.output_bytes += 2 * run.memory_bytes;
  // Start-up cost per rank [core-seconds] and memory of the program per rank without a scene [byte], from
  // short runs (docs/results/plan-costs.sh).
  constexpr double start_seconds = 0.01, program_bytes = 3e7;
  run.core_seconds += start_seconds * ranks;
  run.memory_bytes += program_bytes * ranks;
}

}  // namespace beadswim
